using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>What a simulation's settings have to fulfil. One set of checks serves the inspector, the console and tests.</summary>
    public static class FluidSimulationChecks
    {
        /// <summary>Checks a simulation with its liquid and its colliders, of a prefab asset only the settings; changes nothing.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <returns>What is wrong or worth knowing, errors first.</returns>
        public static List<FluidMessage> Validate(FluidSimulation simulation) => Preview(simulation, out FluidSolverSettings? _);

        /// <summary>Whether any message says that the simulation cannot run.</summary>
        /// <param name="messages">The messages.</param>
        /// <returns>True when one is an error.</returns>
        public static bool HasErrors(IReadOnlyList<FluidMessage> messages) => FluidChecks.HasErrors(messages);

        /// <summary>
        /// What Automatic has picked for a simulation, or would pick by what is known; null with another method, or where it cannot start.
        /// </summary>
        /// <param name="simulation">The simulation.</param>
        /// <returns>The choice; nothing is measured for it.</returns>
        public static FluidMethodChoice PreviewChoice(FluidSimulation simulation)
        {
            if (simulation.MethodChoice != null || !FluidMethods.IsChosen(simulation.Method)) return simulation.MethodChoice;
            using (var collision = new CollisionScene())
            {
                FluidChecks.Check(simulation.Spec, FluidScene.Volumes(simulation), collision, FluidSpawner.Measure, out FluidStart start);
                return start?.Choice;
            }
        }

        /// <summary>Checks like <see cref="Validate"/> and gives the constants that the simulation would start with.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <param name="constants">Null when there is an error.</param>
        /// <returns>The messages, errors first.</returns>
        internal static List<FluidMessage> Preview(FluidSimulation simulation, out FluidSolverSettings? constants) =>
            FluidChecks.Preview(simulation.Spec, FluidScene.Volumes(simulation), out constants);
    }
}
