using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
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
        readonly List<BenchTable> tables = new List<BenchTable>();
        BenchSampler sampler;
        BenchTableRun run;

        /// <summary>Prepares a benchmark; nothing is measured yet.</summary>
        /// <param name="arguments">What to measure.</param>
        /// <param name="shaders">The package's shaders.</param>
        /// <param name="progress">Where it says how far it is.</param>
        /// <exception cref="FluidDeviceException">The device cannot run it, or has no GPU times.</exception>
        /// <exception cref="IOException">The output folder cannot be written.</exception>
        public BenchSession(BenchArguments arguments, FluidShaderSet shaders, SessionProgress progress)
        {
            this.arguments = arguments;
            this.shaders = shaders;
            this.progress = progress;
            if (shaders == null)
                throw new FluidDeviceException("The benchmark has no shader set. Install the package under its name, com.sphfluid.");
            if (!SystemInfo.supportsGpuRecorder)
            {
                throw new FluidDeviceException($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) has no GPU times in Unity's profiler. " +
                    "Run the benchmark with Direct3D 11 or 12.");
            }
            Directory.CreateDirectory(arguments.OutputFolder);
            sampler = new BenchSampler(shaders);
            work = new SessionWork(Run());
        }

        /// <summary>Goes on; waits for the GPU by returning.</summary>
        /// <returns>False when all is measured and written.</returns>
        /// <exception cref="FluidDeviceException">The device failed or gave no times.</exception>
        /// <exception cref="IOException">A file cannot be written.</exception>
        public bool Step() => work.Step();

        /// <summary>Frees the GPU memory. An unfinished benchmark leaves the files of its last whole round, and says so.</summary>
        public void Dispose()
        {
            if (sampler == null)
                return;
            if (!work.IsDone)
                progress.Say($"Stopped early. The files in '{arguments.OutputFolder}' hold whole rounds; their column samples says how many.");
            work.Clear();
            run?.Dispose();
            sampler.Dispose();
            sampler = null;
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
            if (!sampler.HasSurface && arguments.Grids.Count > 0)
                progress.Say(GeometrySurface.MissingSupport() + " The rows with marching cubes are left out.");
            yield return Measure("thesis", arguments.Particles, Configs());
            if (arguments.Sweep ?? !SurfaceGridSizes.IsSoftwareDevice)
                yield return Measure("sweep", SweepParticles(), new[] { BenchConfig.SphOnly });
            foreach (BenchTable table in tables)
                SayTable(table);
        }

        IReadOnlyList<BenchConfig> Configs()
        {
            var configs = new List<BenchConfig> { BenchConfig.SphOnly, BenchConfig.SphParticles };
            if (sampler.HasSurface)
            {
                foreach (int cells in arguments.Grids)
                    configs.Add(BenchConfig.SphMarchingCubes(cells));
            }
            return configs;
        }

        IEnumerator Measure(string name, IReadOnlyList<int> particles, IReadOnlyList<BenchConfig> configs)
        {
            string date = DateTime.UtcNow.ToString("yyyy-MM-dd", CultureInfo.InvariantCulture);
            var table = new BenchTable(name, SystemInfo.graphicsDeviceName, date, BenchBlocks.Names);
            tables.Add(table);
            table.Write(arguments.OutputFolder);
            run = new BenchTableRun(table, sampler, arguments, progress);
            yield return run.Run(shaders, particles, configs);
            run.Dispose();
            run = null;
        }

        void SayTable(BenchTable table)
        {
            progress.Say($"{Path.Combine(arguments.OutputFolder, table.Name + ".csv")}, {table.Device}:");
            progress.Say($"{"",-16}{"particles",10}{"k",7}{"dispatches",12}{"GPU ms",10}{"1/s",10}{"GTX 580",10}{"GTX 430",10}{"blocks",8}");
            foreach (BenchRow row in table.Rows)
            {
                progress.Say(string.Format(CultureInfo.InvariantCulture, "{0,-16}{1,10}{2,7:F1}{3,12}{4,10:F3}{5,10:F1}{6,10}{7,10}{8,8:P0}  {9}",
                    row.Config.Title, row.Particles, row.NeighboursMean, row.Dispatches, row.Frame.Median, row.FramesPerSecond,
                    PublishedTables.System1(row.Config, row.Particles), PublishedTables.System2(row.Config, row.Particles), row.BlocksOverStep, row.Note));
            }
        }
    }
}
