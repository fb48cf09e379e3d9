using System;

namespace SphFluid
{
    /// <summary>What a simulation lets Automatic choose by; all zero where its method is given.</summary>
    internal readonly struct AutomaticSpec : IEquatable<AutomaticSpec>
    {
        /// <summary>Frames a second where nothing says another number.</summary>
        public const double UsualFrameRate = 60.0;

        private readonly float maxCompression, soundSpeedRatio;
        private readonly int substeps;

        /// <summary>Of a simulation as its settings have it.</summary>
        /// <param name="budget">Time that a frame's steps may take on the graphics device [ms].</param>
        /// <param name="frameRate">Frames a second that it is for.</param>
        /// <param name="rules">What its profile asks for.</param>
        /// <param name="maxSubsteps">Most steps a frame.</param>
        public AutomaticSpec(double budget, double frameRate, in FluidRuleInput rules, int maxSubsteps)
        {
            IsOn = true;
            Budget = budget;
            FrameRate = frameRate;
            maxCompression = rules.MaxCompression;
            soundSpeedRatio = rules.SoundSpeedRatio;
            substeps = rules.Substeps;
            MaxSubsteps = maxSubsteps;
        }

        /// <summary>Whether the method is to be chosen.</summary>
        public bool IsOn { get; }

        /// <summary>Time that a frame's steps may take on the graphics device [ms].</summary>
        public double Budget { get; }

        /// <summary>Frames a second that it is for.</summary>
        public double FrameRate { get; }

        /// <summary>Whether budget and frame rate are those of another.</summary>
        public bool HasBudgetOf(in AutomaticSpec other) => Budget.Equals(other.Budget) && FrameRate.Equals(other.FrameRate);

        /// <summary>Most steps a frame, before a choice changed them.</summary>
        public int MaxSubsteps { get; }

        /// <summary>The profile's rules, before a choice changed them.</summary>
        public FluidRuleInput AsSet(FluidRuleInput rules)
        {
            (rules.MaxCompression, rules.SoundSpeedRatio, rules.Substeps) = (maxCompression, soundSpeedRatio, substeps);
            return rules;
        }

        /// <inheritdoc/>
        public bool Equals(AutomaticSpec other) => IsOn == other.IsOn && HasBudgetOf(other) &&
            maxCompression.Equals(other.maxCompression) &&
            soundSpeedRatio.Equals(other.soundSpeedRatio) && MaxSubsteps == other.MaxSubsteps && substeps == other.substeps;

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is AutomaticSpec other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(IsOn, Budget, FrameRate);
    }
}
