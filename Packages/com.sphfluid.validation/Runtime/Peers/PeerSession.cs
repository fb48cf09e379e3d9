using System;
using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Gives cases of the chart to PySPH run by run, and compares its errors and times with those of a chart's methods.</summary>
    public sealed class PeerSession : JobSession
    {
        /// <summary>Makes the work of a run, which hands over its lines of the table.</summary>
        internal delegate IEnumerator Runner(PeerPoint point, Action<PeerRow[]> done);

        private readonly PeerArguments arguments;
        private readonly Runner runner;
        private readonly ResultTable<PeerRow> table;
        private readonly Func<ChartData> findChart;

        /// <summary>Prepares the runs; nothing is computed yet.</summary>
        /// <param name="arguments">What to run.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="CommandLineException">PySPH is missing, or the folder has a table that cannot be continued.</exception>
        public PeerSession(PeerArguments arguments, SessionProgress progress)
            : this(arguments, new PeerRunner(PySph.Find(arguments.Python)).Run, progress,
                FormattableString.Invariant($"{SystemInfo.processorType}, {PySph.Threads} threads"), () => FindChart(arguments))
        {
        }

        internal PeerSession(PeerArguments arguments, Runner runner, SessionProgress progress, string device, Func<ChartData> findChart)
            : base(arguments, "runs", device, progress, new SessionRate(null))
        {
            this.arguments = arguments;
            this.runner = runner;
            this.findChart = findChart;
            table = ResultTable<PeerRow>.Resume(PeerRow.Format, Folder, device, () => new PeerRow());
            Claim(PeerScript.Files().Concat(new[] { PeerRow.Format.File, PeerComparison.Format.File }));
        }

        private protected override IEnumerable<SessionJob> Jobs() => arguments.Cases.SelectMany(c => c.Points(arguments.Quick)).Select(Job);

        private protected override void Draw()
        {
            ChartData chart;
            try
            {
                chart = findChart();
            }
            catch (CommandLineException exception)
            {
                Progress.Say($"{exception.Message} Without a chart nothing is compared; {PeerRow.Format.FileName} has all runs.");
                return;
            }
            List<PeerComparison> lines = PeerComparison.Of(table.Rows, chart.Rows);
            PeerComparison.Format.Write(Folder, lines);
            foreach (string line in PeerComparison.Lines(lines)) Progress.Say(line);
            string problem = GnuplotScript.Draw(Folder, new GnuplotScript[] { new PeerScript(lines, table.Device, chart.Device) });
            Progress.Say(problem ??
                $"{Path.Combine(Folder, "peers.png")}, peers.svg, {PeerRow.Format.FileName} and {PeerComparison.Format.FileName} are " +
                "written.");
        }

        private SessionJob Job(PeerPoint point)
        {
            PeerRow[] rows = null;
            return new SessionJob(point.ToString(), point.Cost, () => table.Contains(point.Key),
                () => runner(point, done =>
                {
                    rows = done;
                    table.Add(done);
                }),
                () =>
                    Progress.Say(FormattableString.Invariant($"{Done}/{Count}  {point}: ") +
                        (rows[0].Failed ? $"failed: {rows[0].Reason}" : Told(rows[0])) +
                    TimeLeft(", ")));
        }

        private static string Told(PeerRow row) =>
            FormattableString.Invariant($"{row.ErrorName} {row.Error:G3}, {row.WallMsPerSecond:N0} ms by the clock per simulated second");

        private static ChartData FindChart(PeerArguments arguments) => arguments.Chart != null ? ChartData.Read(arguments.Chart)
            : ChartData.Newest(Path.GetDirectoryName(Application.dataPath), SystemInfo.graphicsDeviceName, null);
    }
}
