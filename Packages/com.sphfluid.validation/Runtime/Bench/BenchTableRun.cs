using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// Measures rows of one table: settles the liquids, takes a sample of every row that is thrown away and one in which its passes are
    /// timed, then round after round one sample of every row, so that a slow change of the machine affects all rows alike. The file is
    /// written after every round.
    /// </summary>
    internal sealed class BenchTableRun : IDisposable
    {
        private readonly List<BenchLiquid> liquids = new List<BenchLiquid>();
        private readonly List<BenchRow> rows = new List<BenchRow>();
        private readonly Dictionary<BenchRow, BenchLiquid> liquidOf = new Dictionary<BenchRow, BenchLiquid>();
        private readonly Dictionary<BenchRow, double> frameTimes = new Dictionary<BenchRow, double>();
        private readonly ResultTable<BenchRow> table;
        private readonly BenchSampler sampler;
        private readonly BenchArguments arguments;
        private readonly SessionProgress progress;
        private double copySpeed;

        public BenchTableRun(ResultTable<BenchRow> table, BenchSampler sampler, BenchArguments arguments, SessionProgress progress)
        {
            this.table = table;
            this.sampler = sampler;
            this.arguments = arguments;
            this.progress = progress;
        }

        /// <summary>How long the whole benchmark takes.</summary>
        public BenchForecast Forecast { get; set; }

        /// <summary>Time since it began.</summary>
        public Stopwatch Session { get; set; }

        public IEnumerator Run(FluidShaderSet shaders, BenchPlan plan, IReadOnlyList<int> particles)
        {
            var clock = Stopwatch.StartNew();
            progress
                .Say(
                    $"{plan.Name}: {particles.Sum(n => plan.ConfigsOf(n).Count)} rows on {table.Device}; letting " +
                    $"{string.Join(", ", particles)} particles fall first.");
            if (plan.NeedsCopySpeed) yield return MeasureCopy();
            foreach (int count in particles) yield return MakeRows(shaders, plan, count);
            for (int i = 0; i < rows.Count; i++)
            {
                Show($"warming up row {i + 1} of {rows.Count}, {Title(rows[i])}");
                yield return Measure(rows[i]);
            }
            sampler.TimesPasses = true;
            for (int i = 0; i < rows.Count; i++)
            {
                Show($"passes of row {i + 1} of {rows.Count}, {Title(rows[i])}");
                yield return Measure(rows[i]);
                rows[i].Passes = sampler.Last;
                rows[i].Clock = CardClock.Megahertz();
            }
            sampler.TimesPasses = false;
            progress
                .Say(
                    $"{plan.Name}: warming up took {SessionProgress.Duration(clock.Elapsed)}; {SessionProgress.About(Forecast.Left)} " +
                    "left.");
            for (int round = 0; round < arguments.Samples; round++)
            {
                for (int i = 0; i < rows.Count; i++)
                {
                    Show($"round {round + 1} of {arguments.Samples}, {Title(rows[i])}");
                    yield return Measure(rows[i]);
                    Keep(rows[i]);
                }
                table.Write();
            }
        }

        public void Dispose()
        {
            foreach (BenchLiquid liquid in liquids) liquid.Dispose();
        }

        private IEnumerator MeasureCopy()
        {
            using (var buffers = new CopyBuffers())
            {
                yield return sampler.Copy(buffers); // thrown away
                for (int i = 0; i < CopyBuffers.Samples; i++)
                {
                    yield return sampler.Copy(buffers);
                    buffers.Add(sampler.Last.Frame);
                }
                copySpeed = buffers.Speed;
            }
        }

        // The first solver's liquid settles, and all rows start from its state: the same neighbours for all.
        private IEnumerator MakeRows(FluidShaderSet shaders, BenchPlan plan, int count)
        {
            var liquidsOfSize = new Dictionary<BenchSolver, BenchLiquid>();
            BenchState state = null;
            foreach (BenchSolver solver in plan.Solvers)
            {
                var liquid = new BenchLiquid(shaders, solver, count);
                liquids.Add(liquid);
                liquidsOfSize.Add(solver, liquid);
                if (state == null)
                {
                    var clock = Stopwatch.StartNew();
                    IEnumerator fall = sampler.Settle(liquid);
                    while (fall.MoveNext())
                    {
                        Show($"{liquid.SettledSteps} of {BenchLiquid.SettleSteps} steps of the fall of {count} particles");
                        yield return fall.Current;
                    }
                    state = liquid.State;
                    Forecast.TakeFall(solver, count, clock.Elapsed.TotalSeconds);
                }
                liquid.State = state;
            }
            foreach (BenchConfig config in plan.ConfigsOf(count)) AddRow(liquidsOfSize[config.Solver], config);
        }

        private void AddRow(BenchLiquid liquid, BenchConfig config)
        {
            FluidSolver solver = liquid.Solver;
            bool limited = config.Kind == BenchSurfaceKind.Geometry && !FluidSupport.IsSoftwareDevice;
            var row = new BenchRow(config, solver.ParticleCount)
            {
                Spacing = solver.Settings.Spacing,
                Support = solver.Settings.SupportRadius,
                NeighboursMean = liquid.State.NeighboursMean(solver.Settings.SupportRadius),
                CandidatesMean = liquid.State.CandidatesMean(solver),
                Cells = solver.CellCount,
                Triangles = liquid.TriangleCount,
                CopySpeed = copySpeed,
                Machine = BenchMachine.This,
                Peers = table.Rows,
                Note = limited ? "graphics-limited" : "",
            };
            table.Add(row);
            rows.Add(row);
            liquidOf.Add(row, liquid);
        }

        private IEnumerator Measure(BenchRow row)
        {
            var clock = Stopwatch.StartNew();
            frameTimes.TryGetValue(row, out double expected);
            yield return sampler.Sample(liquidOf[row], row.Config, expected);
            row.Dispatches = sampler.Dispatches;
            row.IsListed = liquidOf[row].Solver.ListsNeighbours;
            row.Surface = sampler.FactsOf(row.Config);
            Forecast.TakeSample(row.Config, row.Particles, clock.Elapsed.TotalSeconds);
            frameTimes[row] = sampler.Last.Frame;
        }

        private void Keep(BenchRow row)
        {
            row.Add(sampler.Last);
            if (sampler.NeighbourSetup is double milliseconds) row.AddNeighbourSetup(milliseconds);
        }

        private void Show(string what)
        {
            TimeSpan left = Forecast.Left;
            progress.Show(Session.Elapsed.TotalSeconds / Math.Max(1e-9, (Session.Elapsed + left).TotalSeconds), left, what);
        }

        private static string Title(BenchRow row) =>
            string.Format(CultureInfo.InvariantCulture, "{0}, {1:N0} particles", row.Config.Title, row.Particles);
    }
}
