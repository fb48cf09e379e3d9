using System;
using UnityEngine.Rendering;

namespace SphFluid.Laboratory
{
    /// <summary>For measurements only: makes a solver do what it refuses to do for a game.</summary>
    public static class SolverLaboratory
    {
        /// <summary>
        /// For measurements: gives a solver constants that are not checked, so that what wrong ones do can be seen. The grid stays as it
        /// was made.
        /// </summary>
        /// <param name="solver">The solver.</param>
        /// <param name="settings">The constants as they are, of the solver's method.</param>
        /// <exception cref="ArgumentException">They are for another method.</exception>
        public static void SetUnchecked(FluidSolver solver, in FluidSolverSettings settings)
        {
            if (settings.Method != solver.Kind)
            {
                throw new ArgumentException($"The solver computes by {solver.Kind}, and the settings are for {settings.Method}.",
                    nameof(settings));
            }
            solver.State.Settings = settings;
        }

        /// <summary>
        /// For measurements: records the neighbour setup at the particles' present places, whether one was recorded there before or not.
        /// </summary>
        /// <param name="solver">The solver.</param>
        /// <param name="cmd">Command buffer to record into.</param>
        /// <param name="without">Name of a pass to leave out, so that what it is for can be seen; null: none. The thesis method can do
        /// without ResetGridIndices.</param>
        /// <exception cref="ArgumentException">The method has no such pass that can be left out.</exception>
        public static void RecordNeighbourSetup(FluidSolver solver, CommandBuffer cmd, string without = null)
        {
            if (without == null) solver.Stepper.RecordNeighbourSetup(cmd);
            else if (solver.Stepper is ThesisStepper thesis) thesis.RecordNeighbourSetupWithout(cmd, without);
            else throw new ArgumentException(
                $"The method {solver.Kind} cannot leave out '{without}' of the neighbour setup: it needs all of its passes.",
                nameof(without));
        }
    }
}
