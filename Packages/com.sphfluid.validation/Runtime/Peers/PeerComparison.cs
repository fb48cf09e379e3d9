using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A line of peers-compared.csv: main error and time of a point, of another program or of a method of the chart.</summary>
    internal sealed class PeerComparison
    {
        /// <summary>The file.</summary>
        public static readonly TableFormat<PeerComparison> Format = new TableFormat<PeerComparison>("peers-compared.csv")
            .Text("case", r => r.Case)
            .Text("method", r => r.Method)
            .Number("dx", r => r.Spacing)
            .Number("c_or_iterations", r => r.SoundSpeedRatio)
            .Count("particles", r => r.Particles)
            .Number("error", r => r.Error)
            .Text("error_name", r => r.ErrorName)
            .Number("ms_per_sim_s", r => r.Milliseconds)
            .Count("runs", r => r.Runs);

        private static readonly string[] compared = { "robust", "standard" };

        /// <summary>Name of the case.</summary>
        public string Case { get; private set; }

        /// <summary>Name of the method.</summary>
        public string Method { get; private set; }

        /// <summary>Particle spacing dx [m].</summary>
        public double Spacing { get; private set; }

        /// <summary>Speed of sound over the case's own speed.</summary>
        public double SoundSpeedRatio { get; private set; }

        /// <summary>Number of particles of the liquid.</summary>
        public long Particles { get; private set; }

        /// <summary>Magnitude of the case's main error, the median of the seeds; not a number where a run failed.</summary>
        public double Error { get; private set; }

        /// <summary>Name of the error.</summary>
        public string ErrorName { get; private set; }

        /// <summary>
        /// Time per simulated second: by the clock for another program, of the graphics device for a method of the chart [ms/s].
        /// </summary>
        public double Milliseconds { get; private set; }

        /// <summary>Runs of it.</summary>
        public long Runs { get; private set; }

        /// <summary>Whether the point is of a method of the chart.</summary>
        public bool IsOurs => compared.Contains(Method);

        /// <summary>
        /// The lines: case by case the runs of another program, then the bases of the chart's methods and what has their constants at other
        /// spacings.
        /// </summary>
        /// <param name="peers">The runs of other programs.</param>
        /// <param name="chart">The lines of a chart.</param>
        public static List<PeerComparison> Of(IReadOnlyList<PeerRow> peers, IReadOnlyList<ChartRow> chart)
        {
            var lines = new List<PeerComparison>();
            foreach (PeerCase peer in PeerCase.All)
            {
                List<PeerRow> own = peers.Where(r => r.Case == peer.Case.Name && r.ErrorName == peer.Case.ErrorName).ToList();
                if (own.Count == 0) continue;
                lines.AddRange(own.Select(Line));
                foreach (string name in compared)
                {
                    var start = new ChartConfig(peer.Case, peer.Case.Base(CaseMethod.Find(name)), ChartFactor.Base);
                    lines.AddRange(ChartPoint.Of(chart.Where(r => r.Method == name), peer.Case.Name, peer.Case.ErrorName)
                        .Where(p => p.FactorFrom(start) == ChartFactor.Base || p.FactorFrom(start) == ChartFactor.Spacing)
                        .OrderByDescending(p => p.Spacing).Select(Line));
                }
            }
            return lines;
        }

        /// <summary>The lines as a table for the console.</summary>
        public static IEnumerable<string> Lines(IEnumerable<PeerComparison> lines)
        {
            yield return $"{"case",-12}{"method",-14}{"dx",9}{"c",6}{"particles",11}{"ms/s",12}{"error",10}";
            foreach (PeerComparison line in lines)
            {
                yield return string.Format(CultureInfo.InvariantCulture, "{0,-12}{1,-14}{2,9:G3}{3,6:G3}{4,11}{5,12:N0}{6,10:G3}  {7}",
                    line.Case, line.Method,
                    line.Spacing, line.SoundSpeedRatio, line.Particles, line.Milliseconds, line.Error, line.ErrorName);
            }
        }

        private static PeerComparison Line(PeerRow row) => new PeerComparison
        {
            Case = row.Case,
            Method = row.Method,
            Spacing = row.Spacing,
            SoundSpeedRatio = row.SoundSpeedRatio,
            Particles = row.Particles,
            Error = row.Failed ? double.NaN : Math.Abs(row.Error),
            ErrorName = row.ErrorName,
            Milliseconds = row.WallMsPerSecond,
            Runs = 1,
        };

        private static PeerComparison Line(ChartPoint point) => new PeerComparison
        {
            Case = point.Case,
            Method = point.Method,
            Spacing = point.Spacing,
            SoundSpeedRatio = point.SoundSpeedRatio,
            Particles = point.Particles,
            Error = point.IsWhole ? point.Error.Value.Median : double.NaN,
            ErrorName = point.ErrorName,
            Milliseconds = point.Cost?.Median ?? double.NaN,
            Runs = point.Seeds,
        };
    }
}
