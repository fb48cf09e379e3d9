using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>A force along the channel from t = 0 on, walls at rest: in the end a parabola.</summary>
    public sealed class PoiseuilleCase : ChannelCase
    {
        /// <inheritdoc/>
        public override string Name => "poiseuille";

        /// <inheritdoc/>
        public override IReadOnlyList<string> Words => new[] { "channel", "pipe" };

        /// <inheritdoc/>
        public override string LengthTitle => "the gap";

        /// <inheritdoc/>
        public override string Title => "Poiseuille start-up";

        /// <inheritdoc/>
        protected override double UpperWall => 0.0;

        /// <summary>8 ν u_max/L².</summary>
        protected override double Force => 8.0 * Viscosity * MaxSpeed / (Gap * Gap);

        /// <inheritdoc/>
        protected override double Exact(double y, double t) => ChannelFlow.Poiseuille(y, t, Gap, Viscosity, Force);
    }
}
