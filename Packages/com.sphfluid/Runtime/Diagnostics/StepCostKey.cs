using System;

namespace SphFluid
{
    /// <summary>Of which steps a cost is: those of a method at a support radius, with or without bodies in the liquid.</summary>
    internal readonly struct StepCostKey : IEquatable<StepCostKey>
    {
        private readonly string text;

        private StepCostKey(string text) => this.text = text;

        /// <summary>The key of a liquid's steps.</summary>
        /// <param name="settings">Its constants.</param>
        /// <param name="hasBodies">Whether there are triangles in its domain.</param>
        public static StepCostKey Create(in FluidSolverSettings settings, bool hasBodies) =>
            Create(settings.Method, settings.SupportRadius / (double)settings.Spacing, hasBodies,
                FluidMethods.Get(settings.Method).CostVariant(settings));

        /// <summary>The key of a method's steps.</summary>
        /// <param name="method">The method.</param>
        /// <param name="supportRatio">κ = R/dx.</param>
        /// <param name="hasBodies">Whether there are triangles in the domain.</param>
        /// <param name="variant">What the method computes besides, see <see cref="FluidMethod.CostVariant"/>.</param>
        public static StepCostKey Create(FluidMethodKind method, double supportRatio, bool hasBodies, string variant = "") =>
            new StepCostKey(
            FormattableString.Invariant($"{method}.{FluidMethods.Get(method).CostRevision}{variant}/{supportRatio:0.00}") +
            FormattableString.Invariant($"/{(hasBodies ? "bodies" : "free")}"));

        /// <summary>The key that a stored text stands for.</summary>
        public static StepCostKey Parse(string text) => new StepCostKey(text);

        /// <inheritdoc/>
        public bool Equals(StepCostKey other) => text == other.text;

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is StepCostKey other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => text?.GetHashCode() ?? 0;

        /// <summary>The method with its revision, κ and whether bodies are there: Standard.1/2.25/free.</summary>
        public override string ToString() => text ?? "";
    }
}
