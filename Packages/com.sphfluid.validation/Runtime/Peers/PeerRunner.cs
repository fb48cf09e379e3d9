using System;
using System.Collections;

namespace SphFluid.Validation
{
    /// <summary>Does a run: the case goes to PySPH, and the states that come back go to the case's metric.</summary>
    internal sealed class PeerRunner
    {
        private const double WholeRun = 0.999; // of its duration

        private readonly PySph program;

        public PeerRunner(PySph program) => this.program = program;

        /// <summary>Does a run and hands over its lines of the table.</summary>
        public IEnumerator Run(PeerPoint point, Action<PeerRow[]> done)
        {
            using (var folder = new PeerFolder())
            {
                folder.Write(point);
                yield return program.Run(folder.Name);
                PeerFacts facts = folder.ReadFacts();
                CaseMetric metric = point.Peer.Case.CreateMetric(point.Parameters, point.Setup);
                CaseResult result = PeerSample.Evaluate(point.Setup, metric, folder.ReadSamples(point.Setup));
                if (!result.Failed && facts.End < WholeRun * point.Setup.Duration)
                {
                    result.Failure =
                        FormattableString.Invariant($"it had done {facts.Steps} steps at {facts.End:G3} s: they became too short");
                }
                done(PeerRow.Of(point, facts, folder.ReadTimes(), result));
            }
        }
    }
}
