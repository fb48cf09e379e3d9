namespace SphFluid
{
    /// <summary>
    /// Steps that are taken at once, in the fewest blocks of which each has one neighbour setup, as equal as they come.
    /// Worked example: 13 steps, 4 a block at most, make 4 blocks of 4, 3, 3 and 3.
    /// </summary>
    internal readonly struct StepBlocks
    {
        private readonly int steps, blocks;

        /// <param name="steps">Number of steps, 1 or more.</param>
        /// <param name="most">Most steps of a block, 1 or more.</param>
        public StepBlocks(int steps, int most)
        {
            this.steps = steps;
            blocks = (steps + most - 1) / most;
        }

        /// <summary>Steps of the longest block.</summary>
        public int LongestBlock => (steps + blocks - 1) / blocks;

        /// <summary>Whether a step is the last of its block; the last of all is.</summary>
        public bool IsLast(int step) => Block(step + 1) != Block(step);

        private int Block(int step) => (int)((long)step * blocks / steps);
    }
}
