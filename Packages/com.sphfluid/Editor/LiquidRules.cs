using System.Collections.Generic;

namespace SphFluid.Editor
{
    /// <summary>
    /// Whether a simulation moves and looks as its liquid does. Only the inspector asks: it may be meant.
    /// </summary>
    internal static class LiquidRules
    {
        /// <summary>Adds what differs to messages.</summary>
        public static void Check(FluidSimulation simulation, ICollection<FluidMessage> messages)
        {
            FluidLiquid liquid = simulation.ActiveLiquid;
            if (liquid == null) return;
            FluidProfile own = simulation.OwnProfile;
            if (own != null && own != liquid.Profile)
            {
                messages.Add(new FluidMessage(FluidSeverity.Info, FluidIssue.LiquidOverridden, simulation,
                    $"It looks as '{liquid.name}' and moves by the profile '{own.name}'.",
                    "Clear Profile under Advanced to let it move as its liquid does."));
            }
            foreach (FluidSurfaceRenderer view in SceneObjects.Find<FluidSurfaceRenderer>(simulation))
            {
                if (!view.enabled || !view.OwnLook || view.Simulation != simulation) continue;
                messages.Add(new FluidMessage(FluidSeverity.Info, FluidIssue.LiquidOverridden, view,
                    $"It is drawn by this component's rows and moves as '{liquid.name}'.",
                    "Switch Own Look off to draw it as its liquid looks."));
            }
        }
    }
}
