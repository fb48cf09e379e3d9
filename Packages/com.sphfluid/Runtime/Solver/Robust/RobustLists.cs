using System;

namespace SphFluid
{
    /// <summary>
    /// For how many steps lists of neighbours serve after they were made. Listed pairs are computed at their present places; left out are
    /// pairs that come within R since, which bodies of liquid that fall together do first. Those at a surface are listed ahead
    /// (Shaders/Solver/Cells/NeighbourSearch.hlsl), and inside the liquid neighbours part slowly.
    /// </summary>
    internal static class RobustLists
    {
        // Over R: what two bodies of liquid may close in these steps, and what a moving triangle may go.
        private const float MostClosing = 1.2f;
        private const float MostBodyMotion = 0.3f;

        /// <summary>Steps that may go on with lists after they were made, among walls at rest; 0 for none.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <param name="speed">Speed at which bodies of liquid move [m/s].</param>
        public static double StepsAfter(in FluidSolverSettings settings, double timeStep, double speed) =>
            settings.Own<RobustSettings>().NeighbourList ? Math.Floor(MostClosing * settings.SupportRadius / (2.0 * speed * timeStep))
                : 0.0;

        /// <summary>Steps that may go on with lists after they were made; 0 for none.</summary>
        /// <param name="state">The liquid.</param>
        /// <param name="steps">Steps through which bodies go on their motion of the frame, and the most that is asked for.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <param name="speed">Speed at which bodies of liquid move [m/s].</param>
        public static int StepsAfter(RobustState state, int steps, float timeStep, float speed)
        {
            if (!state.MayListNeighbours) return 0;
            double motion = state.HasBodies && state.Bodies.IsUnderWay ? state.Bodies.LongestMotion / Math.Max(1, steps) : 0.0;
            double byBodies = MostBodyMotion * state.Settings.SupportRadius / motion; // infinite at rest
            return (int)Math.Min(steps, Math.Min(StepsAfter(state.Settings, timeStep, speed), byBodies));
        }
    }
}
