using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A row of a table: what was measured, and its samples.</summary>
    public sealed class BenchRow : MeasuredRow
    {
        private readonly List<BenchTimes> samples = new List<BenchTimes>();
        private readonly List<double> setups = new List<double>();

        /// <summary>A row without samples.</summary>
        /// <param name="config">What a frame does.</param>
        /// <param name="particles">Number of particles.</param>
        public BenchRow(BenchConfig config, int particles)
        {
            Config = config;
            Particles = particles;
        }

        /// <summary>All rows of the table, for columns that compare.</summary>
        internal IReadOnlyList<BenchRow> Peers { get; set; }

        /// <inheritdoc/>
        public override bool IsMeasured => samples.Count > 0;

        /// <summary>What a frame does.</summary>
        public BenchConfig Config { get; }

        /// <summary>Number of particles.</summary>
        public int Particles { get; }

        /// <summary>Particle spacing dx [m].</summary>
        public double Spacing { get; set; }

        /// <summary>Support radius R [m].</summary>
        public double Support { get; set; }

        /// <summary>Mean number of neighbours within R.</summary>
        public double NeighboursMean { get; set; }

        /// <summary>Mean number of particles that the search looks at, the particle itself included.</summary>
        public double CandidatesMean { get; set; }

        /// <summary>Number of cells of the search.</summary>
        public int Cells { get; set; }

        /// <summary>Whether density listed the neighbours for the forces.</summary>
        public bool IsListed { get; set; }

        /// <summary>Number of triangles in the liquid.</summary>
        public int Triangles { get; set; }

        /// <summary>The device's copy speed before the samples, read and written [B/s].</summary>
        public double CopySpeed { get; set; }

        /// <summary>Compute dispatches of a frame, all its steps together.</summary>
        public long Dispatches { get; set; }

        /// <summary>The surface that was drawn last; all nothing without one.</summary>
        public BenchSurfaceFacts Surface { get; set; }

        /// <summary>What it was measured with.</summary>
        public BenchMachine Machine { get; set; } = BenchMachine.None;

        /// <summary>Clock of the graphics card right after a sample [MHz]; not a number where nothing tells it.</summary>
        public double Clock { get; set; } = double.NaN;

        /// <summary>What is to be known when the row is read; empty when nothing.</summary>
        public string Note { get; set; } = "";

        /// <summary>The sample in which the passes were timed too; the others have none of their times.</summary>
        public BenchTimes Passes { get; set; }

        /// <summary>Number of samples.</summary>
        public int SampleCount => samples.Count;

        /// <summary>Frames of all samples, or steps where a frame has several.</summary>
        public int FrameCount => samples.Sum(s => s.Frames);

        /// <summary>GPU time of a frame: statistics of the samples' means [ms].</summary>
        public SampleStatistics Frame => SampleStatistics.Of(samples.Select(s => s.Frame).ToList());

        /// <summary>Frames a second of GPU time, one step each.</summary>
        public double FramesPerSecond => 1000.0 / Frame.Median;

        /// <summary>Millions of particles stepped a second of GPU time.</summary>
        public double MillionParticleSteps => Particles * FramesPerSecond * 1e-6;

        /// <summary>Sum of the blocks over the frame.</summary>
        public double BlocksOverStep => Passes.BlocksOverTotal;

        /// <summary>GPU time of a block in a frame [ms].</summary>
        /// <param name="index">Number of the block.</param>
        public double Block(int index) => Passes.Block(index);

        /// <summary>Neighbour setups a step.</summary>
        public double Rebuilds => (double)Passes.Setups / Passes.Frames;

        /// <summary>Part of a frame's GPU time that a block takes.</summary>
        /// <param name="index">Number of the block.</param>
        public double Share(int index) => Passes.Block(index) / Passes.Frame;

        /// <summary>
        /// GPU time of the neighbour setup before the frames of a sample, and no part of them, median of the samples [ms]; not a number
        /// where there was none.
        /// </summary>
        public double NeighbourSetup => setups.Count > 0 ? SampleStatistics.Of(setups).Median : double.NaN;

        /// <summary>Adds a sample.</summary>
        /// <param name="times">Times of one frame or more.</param>
        public void Add(BenchTimes times) => samples.Add(times);

        /// <summary>Adds a time of the neighbour setup.</summary>
        /// <param name="milliseconds">GPU time [ms].</param>
        public void AddNeighbourSetup(double milliseconds) => setups.Add(milliseconds);
    }
}
