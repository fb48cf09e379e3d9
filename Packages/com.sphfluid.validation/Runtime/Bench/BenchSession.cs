using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A whole benchmark. <see cref="Step"/> is called once a frame of the engine, by a component in play mode or by the Editor's
    /// update; it needs no scene.
    /// </summary>
    public sealed class BenchSession : IValidationSession
    {
        const int LeastSweepParticles = 4096;
        const int MostSweepParticles = 1024 * 1024;

        readonly BenchArguments arguments;
        readonly FluidShaderSet shaders;
        readonly SessionProgress progress;
        readonly SessionWork work;
        readonly ResultFolder results;
        readonly List<BenchTable> tables = new List<BenchTable>();
        BenchSampler sampler;
        BenchTableRun run;
        bool isDisposed;

        /// <summary>Prepares a benchmark; nothing is measured yet.</summary>
        /// <param name="arguments">What to measure.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="FluidDeviceException">The device cannot run it, or has no GPU times.</exception>
        /// <exception cref="CommandLineException">The output folder cannot be written, or holds other files of the tables' names.</exception>
        public BenchSession(BenchArguments arguments, FluidShaderSet shaders, SessionProgress progress)
        {
            this.arguments = arguments;
            this.shaders = SessionAssets.Require(shaders, "The benchmark has");
            this.progress = progress;
            if (!SystemInfo.supportsGpuRecorder)
            {
                throw new FluidDeviceException($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) has no GPU times in Unity's profiler. " +
                    "Run the benchmark with Direct3D 11 or 12.");
            }
            results = ResultFolder.Open(
                arguments.OutputFolder, Plans().Select(p => ResultFile.Text(BenchTable.FileOf(p.Name), BenchTable.FirstLineOf(p.Layout))));
            work = new SessionWork(Run());
        }

        /// <summary>Least GPU time of a sample [ms].</summary>
        internal double SampleMilliseconds { get; set; } = 200.0;

        /// <summary>Goes on; waits for the GPU by returning.</summary>
        /// <returns>False when all is measured and written.</returns>
        /// <exception cref="FluidDeviceException">The device failed or gave no times.</exception>
        /// <exception cref="IOException">A file cannot be written.</exception>
        public bool Step() => work.Step();

        /// <summary>Frees the GPU memory. An unfinished benchmark leaves the files of its last whole round, and says so.</summary>
        public void Dispose()
        {
            if (isDisposed)
                return;
            isDisposed = true;
            if (!work.IsDone)
                progress.Say($"Stopped early. The files in '{arguments.OutputFolder}' hold whole rounds; their column samples says how many.");
            work.Clear();
            run?.Dispose();
            sampler?.Dispose();
            results.Close();
        }

        /// <summary>4,096, 8,192, ... 1,048,576.</summary>
        internal static IReadOnlyList<int> SweepParticles()
        {
            var counts = new List<int>();
            for (int count = LeastSweepParticles; count <= MostSweepParticles; count *= 2)
                counts.Add(count);
            return counts;
        }

        IEnumerator Run()
        {
            foreach (BenchPlan plan in Plans())
                yield return Measure(plan);
            foreach (BenchTable table in tables)
                SayTable(table);
        }

        IEnumerable<BenchPlan> Plans()
        {
            string lack = GeometrySurface.MissingSupport();
            if (arguments.Wants(BenchArguments.ThesisTable))
            {
                yield return BenchPlan.Thesis(arguments.Particles, arguments.Grids, lack);
                if (arguments.Sweep ?? !SurfaceGridSizes.IsSoftwareDevice)
                    yield return BenchPlan.Sweep(SweepParticles());
            }
            if (arguments.Wants(BenchArguments.SolverTable))
                yield return BenchPlan.Solver(arguments.Particles);
            if (arguments.Wants(BenchArguments.SurfaceTable))
                yield return BenchPlan.Surface(arguments.Particles, arguments.Grids, lack);
        }

        IEnumerator Measure(BenchPlan plan)
        {
            string date = DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);
            var table = new BenchTable(plan.Name, SystemInfo.graphicsDeviceName, date, plan.Layout);
            tables.Add(table);
            table.Write(arguments.OutputFolder);
            if (plan.LeftOut != null)
                progress.Say(plan.LeftOut);
            IEnumerable<IReadOnlyList<int>> sizes = plan.SizeBySize ? plan.Particles.Select(n => (IReadOnlyList<int>)new[] { n }) : new[] { plan.Particles };
            foreach (IReadOnlyList<int> particles in sizes)
            {
                sampler = new BenchSampler(shaders, plan.Blocks) { SampleMilliseconds = SampleMilliseconds };
                run = new BenchTableRun(table, sampler, arguments, progress);
                yield return run.Run(shaders, plan, particles);
                run.Dispose();
                sampler.Dispose();
                run = null;
                sampler = null;
            }
        }

        void SayTable(BenchTable table)
        {
            progress.Say($"{Path.Combine(arguments.OutputFolder, BenchTable.FileOf(table.Name))}, {table.Device}:");
            progress.Say(table.Layout.Head);
            foreach (BenchRow row in table.Rows)
                progress.Say(table.Layout.Line(table, row));
        }
    }
}
