using System;

namespace SphFluid
{
    /// <summary>
    /// For how many steps an order of particles and their lists of neighbours serve. Listed pairs are computed at their present places,
    /// so only pairs that come within R since are left out: bodies of liquid at a speed v that fall together close by 2 v Δt a step. What
    /// is left out of a pair that is late by a part q of R has the weight of (1 − q)⁴ (4q + 1) and is soon found, but pairs that come much
    /// nearer unseen would jolt. Those at a surface are listed ahead (Shaders/Solver/Cells/NeighbourSearch.hlsl).
    /// </summary>
    internal static class ListReuse
    {
        /// <summary>
        /// Over R: what two bodies may close between the first step that uses a list and the last where steps are long, forces follow
        /// single particles or liquid is stiff: only the outermost particles of bodies look ahead.
        /// </summary>
        public const double CarefulClosing = 0.6;

        private const double MostClosing = 1.2;    // the same of soft liquid, over R
        private const double MostBodyMotion = 0.3; // of a triangle, over R
        private const double SoftRatio = 6.0;      // of a liquid that may close MostClosing

        /// <summary>
        /// What two bodies may close, over R. Splashes are several times as fast as bodies, so some pairs come near unseen, and what they
        /// push with is an energy of c²: stiff liquid is thrown about by it.
        /// </summary>
        /// <param name="stiffness">The speed of sound over that of the fastest bodies.</param>
        public static double ClosingFor(double stiffness) =>
            Math.Min(MostClosing, Math.Max(CarefulClosing, MostClosing * SoftRatio / stiffness));

        /// <summary>Steps that may go on with lists after the first that uses them, among walls at rest; infinite at rest.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <param name="speed">Speed at which bodies of liquid move [m/s].</param>
        /// <param name="closing">What two bodies may close, over R.</param>
        public static double StepsAfter(in FluidSolverSettings settings, double timeStep, double speed, double closing) =>
            Math.Floor(closing * settings.SupportRadius / (2.0 * speed * timeStep));

        /// <summary>Steps that may go on with lists after the first that uses them; infinite at rest, 0 where there are no lists.</summary>
        /// <param name="state">The liquid.</param>
        /// <param name="steps">Steps through which bodies go on their motion of the frame, 1 or more.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <param name="speed">Speed at which bodies of liquid move [m/s].</param>
        /// <param name="closing">What two bodies may close, over R.</param>
        public static double StepsAfter(CellState state, int steps, double timeStep, double speed, double closing)
        {
            if (!state.MayListNeighbours) return 0.0;
            double motion = state.HasBodies && state.Bodies.IsUnderWay ? state.Bodies.LongestMotion / steps : 0.0;
            double byBodies = Math.Floor(MostBodyMotion * state.Settings.SupportRadius / motion);
            return Math.Min(StepsAfter(state.Settings, timeStep, speed, closing), byBodies);
        }
    }
}
