using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using SphFluid.Laboratory;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A whole benchmark; it needs no scene.</summary>
    public sealed class BenchSession : MeasuringSession
    {
        private const int LeastSweepParticles = 4096;
        private const int MostSweepParticles = 1024 * 1024;

        private readonly BenchArguments arguments;
        private readonly FluidShaderSet shaders;
        private readonly Stopwatch session = new Stopwatch();
        private readonly List<(BenchPlan Plan, ResultTable<BenchRow> Table)> tables = new List<(BenchPlan, ResultTable<BenchRow>)>();
        private BenchForecast forecast;

        /// <summary>Prepares a benchmark; nothing is measured yet.</summary>
        /// <param name="arguments">What to measure.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="FluidDeviceException">The device cannot run it, or has no GPU times.</exception>
        /// <exception cref="CommandLineException">The output folder cannot be written, or holds other files of the tables'
        /// names.</exception>
        public BenchSession(BenchArguments arguments, FluidShaderSet shaders, SessionProgress progress) : base(arguments, progress)
        {
            this.arguments = arguments;
            this.shaders = SessionAssets.Require(shaders, "The benchmark has");
            if (!SystemInfo.supportsGpuRecorder)
            {
                throw new FluidDeviceException(
                    $"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) has no GPU times in Unity's profiler. " +
                    "Run the benchmark with Direct3D 11 or 12.");
            }
            if (Plays && !Application.isPlaying)
            {
                throw new CommandLineException(
                    "--table playback plays a Fluid Simulation, which runs in play mode only. Enter play mode first, or use a built " +
                    "player.");
            }
            Claim(Plays ? new[] { PlaybackRow.Format.File } : Plans().Select(p => p.Layout.Format.File));
        }

        /// <summary>Least GPU time of a sample [ms].</summary>
        internal double SampleMilliseconds { get; set; } = 200.0;

        /// <summary>Width and height of the picture that is drawn.</summary>
        internal Vector2Int PictureSize { get; set; } = BenchDrawing.Size;

        private protected override string Unfinished => $"The files in '{Folder}' hold whole rounds; their column samples says how many.";

        /// <summary>4,096, 8,192, ... 1,048,576.</summary>
        internal static IReadOnlyList<int> SweepParticles()
        {
            var counts = new List<int>();
            for (int count = LeastSweepParticles; count <= MostSweepParticles; count *= 2) counts.Add(count);
            return counts;
        }

        private bool Plays => arguments.Includes(BenchArguments.PlaybackTable);

        private protected override IEnumerator Run()
        {
            if (Plays)
            {
                yield return MeasurePlayback();
                yield break;
            }
            var calibration = new DeviceCalibration(shaders);
            yield return calibration.Run();
            Forecast(calibration.SecondsPerStep, out int rows);
            Progress.Say($"{SessionProgress.About(forecast.Left)} for {rows} rows, {arguments.Samples} samples of each.");
            session.Restart();
            foreach (BenchPlan plan in Plans()) yield return Measure(plan);
            foreach ((BenchPlan plan, ResultTable<BenchRow> table) in tables) SayTable(plan.Layout, table);
        }

        private void Forecast(double secondsPerStep, out int rows)
        {
            forecast = new BenchForecast(secondsPerStep, 1e-3 * SampleMilliseconds, arguments.Samples);
            rows = 0;
            foreach (BenchPlan plan in Plans())
            {
                foreach (int particles in plan.Particles)
                {
                    forecast.AddFall(plan.Solvers[0], particles);
                    foreach (BenchConfig config in plan.ConfigsOf(particles))
                    {
                        forecast.AddRow(config, particles);
                        rows++;
                    }
                }
            }
        }

        private IEnumerable<BenchPlan> Plans() =>
            arguments.Particles == null ? AllPlans().Select(plan => plan.Within(BenchMemory.Most)) : AllPlans();

        private IEnumerable<BenchPlan> AllPlans()
        {
            string missing = MeasuredGeometrySurface.MissingSupport();
            if (arguments.Includes(BenchArguments.ThesisTable))
            {
                yield return BenchPlan.Thesis(arguments.Particles, arguments.Grids, missing);
                if (arguments.Sweep ?? !FluidSupport.IsSoftwareDevice) yield return BenchPlan.Sweep(SweepParticles());
            }
            if (arguments.Includes(BenchArguments.SolverTable)) yield return BenchPlan.Solver(arguments.Particles);
            if (arguments.Includes(BenchArguments.SurfaceTable))
            {
                yield return BenchPlan.Surface(arguments.Particles, arguments.Grids, missing);
            }
        }

        private IEnumerator Measure(BenchPlan plan)
        {
            var table = new ResultTable<BenchRow>(plan.Layout.Format, Folder, SystemInfo.graphicsDeviceName);
            tables.Add((plan, table));
            table.Write();
            if (plan.LeftOut != null) Progress.Say(plan.LeftOut);
            IEnumerable<IReadOnlyList<int>> sizes = plan.SizeBySize ? plan.Particles.Select(n => (IReadOnlyList<int>)new[] { n })
                : new[] { plan.Particles };
            foreach (IReadOnlyList<int> particles in sizes)
            {
                using (var sampler = new BenchSampler(shaders, plan.Blocks, PictureSize) { SampleMilliseconds = SampleMilliseconds })
                using (var run = new BenchTableRun(table, sampler, arguments, Progress) { Forecast = forecast, Session = session })
                    yield return run.Run(shaders, plan, particles);
            }
        }

        private IEnumerator MeasurePlayback()
        {
            var table = new ResultTable<PlaybackRow>(PlaybackRow.Format, Folder, SystemInfo.graphicsDeviceName);
            foreach (int particles in arguments.Particles ?? new[] { PlaybackBench.UsualParticles })
            {
                using (var bench = new PlaybackBench(shaders, particles))
                    yield return bench.Run(table, Progress);
            }
            foreach (PlaybackRow row in table.Rows) Progress.Say(PlaybackRow.Format.Line(row));
        }

        private void SayTable(BenchLayout layout, ResultTable<BenchRow> table)
        {
            Progress.Say($"{Path.Combine(Folder, layout.Format.FileName)}, {table.Device}:");
            Progress.Say(layout.Head);
            foreach (BenchRow row in table.Rows) Progress.Say(layout.Line(row));
        }
    }
}
