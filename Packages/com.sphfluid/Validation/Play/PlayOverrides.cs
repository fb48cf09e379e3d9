using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Changes every simulation of the loaded scenes as the command line asks, before they start.</summary>
    static class PlayOverrides
    {
        public static void Apply(PlayArguments arguments, IReadOnlyList<FluidSimulation> simulations)
        {
            foreach (FluidSimulation simulation in simulations)
            {
                if (arguments.Method is FluidMethodKind method)
                    simulation.Method = method;
                if (arguments.Particles is int count)
                    simulation.Spacing = simulation.SpacingForParticleCount(count);
                if (arguments.Seed is int seed)
                    simulation.Seed = seed;
                if (arguments.Surface != null)
                    SetSurface(simulation, arguments.Surface);
            }
        }

        /// <summary>What draws a simulation now, in the words of --surface.</summary>
        public static string SurfaceOf(FluidSimulation simulation)
        {
            foreach (FluidRenderer renderer in Renderers(simulation))
            {
                if (!renderer.isActiveAndEnabled)
                    continue;
                return NameOf(renderer);
            }
            return "none";
        }

        static string NameOf(FluidRenderer renderer)
        {
            if (!(renderer is FluidSurfaceRenderer surface) || surface.UsesFallback)
                return "particles";
            return surface.Style == FluidSurfaceStyle.Cubes ? "cubes" : "marching-cubes-gs";
        }

        /// <summary>The iso value of a simulation's surface; the default where it has none.</summary>
        public static float IsoValueOf(FluidSimulation simulation)
        {
            foreach (FluidRenderer renderer in Renderers(simulation))
            {
                if (renderer is FluidSurfaceRenderer surface)
                    return surface.IsoValue;
            }
            return 0.5f;
        }

        /// <summary>Cells a side of a simulation's surface grid; automatic where it has none.</summary>
        public static SurfaceGridSize GridSizeOf(FluidSimulation simulation)
        {
            foreach (FluidRenderer renderer in Renderers(simulation))
            {
                if (renderer is FluidSurfaceRenderer surface)
                    return surface.GridSize;
            }
            return SurfaceGridSize.Automatic;
        }

        static void SetSurface(FluidSimulation simulation, string surface)
        {
            foreach (FluidRenderer renderer in Renderers(simulation))
                renderer.enabled = false;
            if (surface == "particles")
                Enable<FluidParticleRenderer>(simulation);
            else if (surface == "cubes")
                Enable<FluidSurfaceRenderer>(simulation).Style = FluidSurfaceStyle.Cubes;
            else if (surface == "marching-cubes-gs")
                Enable<FluidSurfaceRenderer>(simulation).Style = FluidSurfaceStyle.MarchingCubes;
        }

        static T Enable<T>(FluidSimulation simulation) where T : FluidRenderer
        {
            foreach (FluidRenderer renderer in Renderers(simulation))
            {
                if (renderer is T found)
                {
                    found.enabled = true;
                    return found;
                }
            }
            var added = simulation.gameObject.AddComponent<T>();
            added.Simulation = simulation;
            return added;
        }

        static IEnumerable<FluidRenderer> Renderers(FluidSimulation simulation)
        {
            foreach (FluidRenderer renderer in Object.FindObjectsByType<FluidRenderer>(FindObjectsInactive.Include, FindObjectsSortMode.InstanceID))
            {
                if (renderer.Simulation == simulation)
                    yield return renderer;
            }
        }
    }
}
