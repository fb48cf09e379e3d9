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
        /// <summary>Most steps: more save little.</summary>
        public const int MostSteps = 8;

        // Of a liquid with forces of its own, which follow each particle at the surface or are made with the lists.
        private const int MostStepsWithForces = 8;

        // Over R: what two bodies may close between the first step that uses a list and the last, and what a moving triangle may go.
        private const float MostClosing = 0.6f;
        private const float MostClosingWithForces = 0.6f;
        private const float MostBodyMotion = 0.3f;

        /// <summary>Steps that one sort serves among walls at rest, on a device that holds the lists; 1 or more.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <param name="speed">Speed at which bodies of liquid move [m/s].</param>
        public static int Steps(in FluidSolverSettings settings, double timeStep, double speed) =>
            settings.Own<StandardSettings>().NeighbourList ? Steps(settings, timeStep, speed, double.PositiveInfinity) : 1;

        /// <summary>Steps that one sort serves, 1 or more.</summary>
        /// <param name="state">The liquid.</param>
        /// <param name="steps">Steps through which bodies go on their motion of the frame.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <param name="speed">Speed at which bodies of liquid move [m/s].</param>
        public static int Steps(StandardState state, int steps, float timeStep, float speed)
        {
            if (!state.MayListNeighbours) return 1;
            double bodies = (state.HasBodies && state.Bodies.IsUnderWay ? state.Bodies.LongestMotion : 0f) / Math.Max(1, steps) /
                state.Settings.SupportRadius;
            return Steps(state.Settings, timeStep, speed, MostBodyMotion / bodies);
        }

        private static int Steps(in FluidSolverSettings settings, double timeStep, double speed, double byBodies)
        {
            StandardSettings own = settings.Own<StandardSettings>();
            bool hasForces = false;
            for (int i = 0; i < StandardForces.All.Count; i++) hasForces |= StandardForces.All[i].Acts(own);
            int most = Math.Max(1, Math.Min(hasForces ? MostStepsWithForces : MostSteps, own.StepsPerSort));
            double closing = 2.0 * speed * timeStep / settings.SupportRadius;
            double allowed = Math.Min((hasForces ? MostClosingWithForces : MostClosing) / closing, byBodies); // infinite at rest
            return (int)Math.Min(most, 1.0 + allowed);
        }
    }
}
