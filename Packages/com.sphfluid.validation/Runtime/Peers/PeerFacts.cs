using System;

namespace SphFluid.Validation
{
    /// <summary>What another program tells of its run: the line of run.csv.</summary>
    internal sealed class PeerFacts
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<PeerFacts> Format = new TableFormat<PeerFacts>("run.csv")
            .Text("version", f => f.Version, (f, v) => f.Version = v)
            .Number("support_over_dx", f => f.SupportRatio, (f, v) => f.SupportRatio = v)
            .Count("boundary_particles", f => f.BoundaryParticles, (f, v) => f.BoundaryParticles = v)
            .Count("evaluations", f => f.Evaluations, (f, v) => f.Evaluations = v)
            .Count("steps", f => f.Steps, (f, v) => f.Steps = v)
            .Number("end_s", f => f.End, (f, v) => f.End = v)
            .Number("set_up_s", f => f.SetUpSeconds, (f, v) => f.SetUpSeconds = v)
            .Number("other_cores", f => f.OtherCores, (f, v) => f.OtherCores = v);

        /// <summary>The program and its version.</summary>
        public string Version = "";

        /// <summary>Radius of the kernel's support over dx.</summary>
        public double SupportRatio = double.NaN;

        /// <summary>Particles of walls and obstacles.</summary>
        public long BoundaryParticles;

        /// <summary>Evaluations of the forces in a step.</summary>
        public long Evaluations;

        /// <summary>Steps done.</summary>
        public long Steps;

        /// <summary>Time that was reached [s].</summary>
        public double End = double.NaN;

        /// <summary>
        /// Time before the first step: particles, and code that is generated and compiled where none is kept from an earlier run [s].
        /// </summary>
        public double SetUpSeconds = double.NaN;

        /// <summary>
        /// Processor cores that other programs kept busy meanwhile, the median from sample to sample; not a number where the system does
        /// not say.
        /// </summary>
        public double OtherCores = double.NaN;

        /// <summary>Mean length of a step [s].</summary>
        public double TimeStep => End / Math.Max(1L, Steps);
    }
}
