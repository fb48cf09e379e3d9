namespace SphFluid.Validation
{
    /// <summary>GPU times of some frames, summed [ms].</summary>
    public readonly struct BenchTimes
    {
        private readonly double[] blocks;

        /// <summary>Times of frames.</summary>
        /// <param name="frames">Number of frames.</param>
        /// <param name="total">Their whole GPU time [ms].</param>
        /// <param name="blocks">GPU time of each block in them [ms].</param>
        /// <param name="setups">Neighbour setups in them.</param>
        public BenchTimes(int frames, double total, double[] blocks, long setups = 0)
        {
            Setups = setups;
            Frames = frames;
            Total = total;
            this.blocks = blocks;
        }

        /// <summary>Number of frames.</summary>
        public int Frames { get; }

        /// <summary>Neighbour setups in them, as their passes were timed.</summary>
        public long Setups { get; }

        /// <summary>GPU time of the frames [ms].</summary>
        public double Total { get; }

        /// <summary>GPU time of a frame [ms].</summary>
        public double Frame => Total / Frames;

        /// <summary>GPU time of a block in one frame [ms].</summary>
        /// <param name="index">Number of the block.</param>
        public double Block(int index) => blocks[index] / Frames;

        /// <summary>Sum of the blocks over the whole: 1 when the blocks are all there is.</summary>
        public double BlocksOverTotal
        {
            get
            {
                double sum = 0;
                foreach (double block in blocks) sum += block;
                return sum / Total;
            }
        }

        /// <summary>These frames and some more.</summary>
        /// <param name="more">The others, of the same blocks.</param>
        public BenchTimes Plus(in BenchTimes more)
        {
            var sums = (double[])blocks.Clone();
            for (int i = 0; i < sums.Length; i++) sums[i] += more.blocks[i];
            return new BenchTimes(Frames + more.Frames, Total + more.Total, sums, Setups + more.Setups);
        }

        /// <summary>The same times, each step counted as a frame.</summary>
        /// <param name="steps">Steps of a frame; none counts as one.</param>
        public BenchTimes PerStep(int steps) => new BenchTimes(Frames * System.Math.Max(1, steps), Total, blocks, Setups);
    }
}
