using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>The upper wall moves from t = 0 on: in the end a straight line.</summary>
    public sealed class CouetteCase : ChannelCase
    {
        /// <inheritdoc/>
        public override string Name => "couette";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "shear" };

        /// <inheritdoc/>
        public override string LengthTitle => "the gap";

        /// <inheritdoc/>
        public override string Title => "Couette start-up";

        /// <inheritdoc/>
        protected override double UpperWall => MaxSpeed;

        /// <inheritdoc/>
        protected override double Force => 0.0;

        /// <inheritdoc/>
        protected override double Exact(double y, double t) => ChannelFlow.Couette(y, t, Gap, Viscosity, MaxSpeed);
    }
}
