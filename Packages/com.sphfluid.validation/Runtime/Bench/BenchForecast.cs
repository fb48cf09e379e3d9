using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// How long a benchmark takes. Before anything is measured: by the particle-steps of its rows and the time of one, as a calibration of
    /// the device has it. A row that was measured counts by what it took, and its like by what was found so far against what was expected.
    /// </summary>
    internal sealed class BenchForecast
    {
        // Of a sample beside its frames: the saved state put back, a step or a sort before it, waiting for times.
        private const double SampleOverhead = 0.2;
        // The one that is thrown away, and the one in which the passes are timed.
        private const int OtherSamples = 2;

        // Work in particle-steps of the Standard method: of the thesis method's step, of a surface and of whitewater for each particle; for
        // each cell of a dense grid, and of a sparse one for each square of cells across, as many as its surface is large; of water's
        // picture. From benchmarks/surface-llvmpipe-2026-11-25.csv, by the calibration of that run.
        private const double ThesisWeight = 2.0, RobustWeight = 2.4, SurfaceWeight = 1.5, WhitewaterWeight = 4.5, CellWeight = 0.9,
            SquareWeight = 12.0, WaterPicture = 5e4, StepOverhead = 1500.0;

        private readonly List<Item> items = new List<Item>();
        private readonly double sampleSeconds, secondsPerWork;
        private readonly int samples;

        /// <param name="secondsPerStep">Time of a step of the calibration [s].</param>
        /// <param name="sampleSeconds">Least time of a sample [s].</param>
        /// <param name="samples">Samples of each row.</param>
        public BenchForecast(double secondsPerStep, double sampleSeconds, int samples)
        {
            secondsPerWork = secondsPerStep / Work(DeviceCalibration.Particles, 1.0);
            this.sampleSeconds = sampleSeconds;
            this.samples = samples;
        }

        /// <summary>Adds the fall of a liquid, which comes once.</summary>
        public void AddFall(BenchSolver solver, int particles) =>
            items
                .Add(new Item(FallKey(solver, particles), BenchLiquid.SettleSteps * Work(particles, WeightOf(solver)) * secondsPerWork, 1));

        /// <summary>Adds a row: a sample to warm up, one of its passes, and those that count.</summary>
        public void AddRow(BenchConfig config, int particles) =>
            items.Add(new Item(RowKey(config, particles), SecondsOfSample(config, particles), OtherSamples + samples));

        /// <summary>Takes note of a fall.</summary>
        public void TakeFall(BenchSolver solver, int particles, double seconds) => Take(FallKey(solver, particles), seconds);

        /// <summary>Takes note of a sample.</summary>
        public void TakeSample(BenchConfig config, int particles, double seconds) => Take(RowKey(config, particles), seconds);

        /// <summary>Time left.</summary>
        public TimeSpan Left
        {
            get
            {
                List<Item> measured = items.Where(i => i.Taken > 0).ToList();
                double expected = measured.Sum(i => i.Expected * i.Taken), taken = measured.Sum(i => i.Mean * i.Taken);
                // A second of what was expected counts beside what was measured: the first row may be a small one.
                double factor = (taken + 1.0) / (expected + 1.0);
                return TimeSpan.FromSeconds(items.Sum(i => Math.Max(0, i.Count - i.Taken) * (i.Taken > 0 ? i.Mean : i.Expected * factor)));
            }
        }

        private double SecondsOfSample(BenchConfig config, int particles)
        {
            double work = config.Steps * Work(particles, WeightOf(config.Solver));
            if (config.HasSurface) work += Work(particles, SurfaceWeight) + SurfaceWork(config, particles);
            double prepare = Work(particles, WeightOf(config.Solver)) * secondsPerWork + SampleOverhead;
            return prepare + Math.Max(sampleSeconds, work * secondsPerWork);
        }

        private static double SurfaceWork(BenchConfig config, int particles)
        {
            switch (config.Kind)
            {
                case BenchSurfaceKind.Geometry:
                case BenchSurfaceKind.DenseCompute: return CellWeight * Math.Pow(config.Grid, 3.0);
                case BenchSurfaceKind.Water: return WaterPicture;
                case BenchSurfaceKind.Whitewater: return WhitewaterWeight * particles;
                default: return SquareWeight * Math.Pow(config.Grid, 2.0);
            }
        }

        private static double WeightOf(BenchSolver solver) => solver.IsThesis ? ThesisWeight : solver.Method == FluidMethodKind.Robust
            ? RobustWeight : 1.0;

        private static double Work(double particles, double weight) => weight * particles + StepOverhead;

        private static string FallKey(BenchSolver solver, int particles) => $"fall {solver.Name} {particles}";

        private static string RowKey(BenchConfig config, int particles) => $"{config.Solver.Name} {config.Name} {config.Title} {particles}";

        private void Take(string key, double seconds)
        {
            Item item = items.Find(i => i.Key == key && i.Taken < i.Count) ?? items.Find(i => i.Key == key);
            if (item == null) return;
            // The last ones count more: the first also compiles.
            item.Mean = item.Taken > 1 ? 0.7 * item.Mean + 0.3 * seconds : seconds;
            item.Taken++;
        }

        private sealed class Item
        {
            public Item(string key, double expected, int count) => (Key, Expected, Count) = (key, expected, count);

            public readonly string Key;
            public readonly double Expected;
            public readonly int Count;
            public double Mean;
            public int Taken;
        }
    }
}
