namespace SphFluid.Validation
{
    /// <summary>What is asked: a kind of flow, its size, and how much it may err or cost.</summary>
    public sealed class ChoiceQuestion
    {
        /// <summary>Frames a second that costs are given for.</summary>
        public const double DefaultFramesPerSecond = 60.0;

        /// <summary>Largest compression by motion, (v/c)²; more is soft, and other errors than the case's own grow.</summary>
        public const double DefaultCompression = 0.04;

        /// <summary>The case whose flow is like the one in question.</summary>
        public ValidationCase Case;

        /// <summary>Largest error, in the case's own unit: 0.05 is five per cent. Not a number: the least within the time.</summary>
        public double Error = double.NaN;

        /// <summary>Most GPU time of a frame [ms]. Not a number: the least within the error.</summary>
        public double Milliseconds = double.NaN;

        /// <summary>Frames a second of play.</summary>
        public double FramesPerSecond = DefaultFramesPerSecond;

        /// <summary>
        /// The liquid's length, of the kind that <see cref="ValidationCase.LengthTitle"/> names [m]; not a number: the case's own.
        /// </summary>
        public double Length = double.NaN;

        /// <summary>The liquid's fastest speed [m/s]; not a number: as the case's, in proportion to its size.</summary>
        public double Speed = double.NaN;

        /// <summary>The liquid's volume [m³]; not a number: as the case's, in proportion to its size.</summary>
        public double Volume = double.NaN;

        /// <summary>Largest compression by motion, (v/c)².</summary>
        public double Compression = DefaultCompression;
    }
}
