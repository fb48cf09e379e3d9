namespace SphFluid
{
    /// <summary>The frames that a playback needs, in the order in which it needs them, if it goes on as it does.</summary>
    internal struct SequenceWalk
    {
        private readonly int count;
        private readonly FluidPlaybackLoop loop;

        /// <param name="first">The first frame.</param>
        /// <param name="direction">1: on to later frames, −1: back to earlier ones.</param>
        /// <param name="count">Number of frames, one or more.</param>
        /// <param name="loop">What happens past the ends.</param>
        public SequenceWalk(int first, int direction, int count, FluidPlaybackLoop loop)
        {
            Frame = first;
            Direction = direction;
            this.count = count;
            this.loop = loop;
        }

        /// <summary>The frame.</summary>
        public int Frame { get; private set; }

        /// <summary>Which way it goes.</summary>
        public int Direction { get; private set; }

        /// <summary>Goes to the next frame.</summary>
        /// <returns>False where there is none.</returns>
        public bool Next()
        {
            int next = Frame + Direction;
            if (next < 0 || next >= count)
            {
                if (loop == FluidPlaybackLoop.None || count == 1) return false;
                if (loop == FluidPlaybackLoop.Repeat) next = Direction > 0 ? 0 : count - 1;
                else
                {
                    Direction = -Direction;
                    next = Frame + Direction;
                }
            }
            Frame = next;
            return true;
        }

        /// <summary>Whether two walks are the same.</summary>
        public readonly bool Is(in SequenceWalk other) => Frame == other.Frame && Direction == other.Direction && loop == other.loop &&
            count == other.count;
    }
}
