namespace SphFluid.Editor
{
    /// <summary>
    /// Whether anything shows a liquid. Only the inspector asks: a script may read the particles and draw them itself.
    /// </summary>
    internal static class ViewRules
    {
        /// <returns>Null when a component shows the liquid, and for a prefab asset, which may be shown from its scene.</returns>
        public static FluidMessage? Check(FluidSimulation simulation)
        {
            if (SceneObjects.IsPrefabAsset(simulation)) return null;
            foreach (FluidView view in SceneObjects.Find<FluidView>(simulation))
                if (view.enabled && view.Simulation == simulation) return null;
            return new FluidMessage(FluidSeverity.Info, FluidIssue.NotDrawn, simulation,
                "No component draws this liquid.",
                "Add a Fluid Surface Renderer or a Fluid Particle Renderer, unless a script draws its particles.");
        }
    }
}
