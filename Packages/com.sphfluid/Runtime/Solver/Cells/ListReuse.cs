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
        // Over R: what two bodies may close between the first step that uses a list and the last, and what a moving triangle may go.
        private const float MostClosing = 1.2f;
        private const float MostBodyMotion = 0.3f;

        /// <summary>Steps that may go on with lists after the first that uses them, among walls at rest; infinite at rest.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <param name="speed">Speed at which bodies of liquid move [m/s].</param>
        public static double StepsAfter(in FluidSolverSettings settings, double timeStep, double speed) =>
            MostClosing * settings.SupportRadius / (2.0 * speed * timeStep);

        /// <summary>Steps that may go on with lists after the first that uses them; infinite at rest, 0 where there are no lists.</summary>
        /// <param name="state">The liquid.</param>
        /// <param name="steps">Steps through which bodies go on their motion of the frame, 1 or more.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <param name="speed">Speed at which bodies of liquid move [m/s].</param>
        public static double StepsAfter(CellState state, int steps, double timeStep, double speed)
        {
            if (!state.MayListNeighbours) return 0.0;
            double motion = state.HasBodies && state.Bodies.IsUnderWay ? state.Bodies.LongestMotion / steps : 0.0;
            return Math.Min(StepsAfter(state.Settings, timeStep, speed), MostBodyMotion * state.Settings.SupportRadius / motion);
        }
    }
}
