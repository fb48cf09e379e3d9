namespace SphFluid
{
    /// <summary>A failure that a detector saw, with its figure and its cure.</summary>
    public readonly struct FluidFinding
    {
        /// <summary>A finding.</summary>
        /// <param name="failure">What goes wrong.</param>
        /// <param name="value">The figure that shows it.</param>
        /// <param name="limit">The figure's limit.</param>
        /// <param name="text">What is wrong, a full sentence with the figure.</param>
        /// <param name="cure">What to change, a full sentence.</param>
        public FluidFinding(FluidFailure failure, double value, double limit, string text, string cure)
        {
            Failure = failure;
            Value = value;
            Limit = limit;
            Text = text;
            Cure = cure;
        }

        /// <summary>What goes wrong.</summary>
        public FluidFailure Failure { get; }

        /// <summary>The figure that shows it.</summary>
        public double Value { get; }

        /// <summary>The figure's limit.</summary>
        public double Limit { get; }

        /// <summary>What is wrong, with the figure.</summary>
        public string Text { get; }

        /// <summary>What to change.</summary>
        public string Cure { get; }
    }
}
