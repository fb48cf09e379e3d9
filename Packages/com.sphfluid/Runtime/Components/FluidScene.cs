using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The components of a scene that belong to a simulation or act on it.</summary>
    internal static class FluidScene
    {
        /// <summary>Enabled volumes that belong to the simulation, in hierarchy order.</summary>
        public static List<FluidVolume> FindVolumes(FluidSimulation simulation)
        {
            FluidSimulation[] simulations = SceneObjects.Find<FluidSimulation>(simulation);
            var found = new List<FluidVolume>();
            foreach (FluidVolume volume in SceneObjects.Find<FluidVolume>(simulation))
                if (volume.enabled && Owner(volume, simulations) == simulation) found.Add(volume);
            found.Sort(HierarchyOrder.Compare);
            return found;
        }

        /// <summary>What the volumes that belong to the simulation fill, in hierarchy order.</summary>
        public static List<VolumeSpec> Volumes(FluidSimulation simulation) => FindVolumes(simulation).ConvertAll(v => v.Spec);

        /// <summary>The simulation that a volume belongs to; null when several could have it and none holds its centre.</summary>
        public static FluidSimulation Owner(FluidVolume volume, IReadOnlyList<FluidSimulation> simulations) =>
            Owner(volume, volume.Simulation, simulations);

        /// <summary>
        /// The simulation that a component belongs to, which may name it; null when several could have it and none holds its place.
        /// </summary>
        public static FluidSimulation Owner(Component component, FluidSimulation named, IReadOnlyList<FluidSimulation> simulations)
        {
            if (named != null) return named;
            // Nothing in a prefab asset is active.
            FluidSimulation parent = component.GetComponentInParent<FluidSimulation>(SceneObjects.IsPrefabAsset(component));
            if (parent != null) return parent;
            FluidSimulation only = null, holder = null;
            int count = 0;
            Vector3 place = component.transform.position;
            for (int i = 0; i < simulations.Count; i++)
            {
                if (!simulations[i].enabled) continue;
                count++;
                only = simulations[i];
                if (holder == null && Holds(only, place)) holder = only;
            }
            return count == 1 ? only : holder;
        }

        /// <summary>What the first of some emitters with a liquid gives; null: none says.</summary>
        public static FluidLiquid LiquidOf(List<EmitterSpec> emitters)
        {
            foreach (EmitterSpec emitter in emitters)
                if (emitter.Liquid != null) return (FluidLiquid)emitter.Liquid;
            return null;
        }

        /// <summary>Looks for all that comes into a liquid, leaves it or acts on it, but not for its volumes.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <param name="parts">Receives it.</param>
        public static void Gather(FluidSimulation simulation, SceneParts parts)
        {
            Own(simulation, parts.Emitters);
            Own(simulation, parts.Drains);
            Shared(simulation, parts.Zones);
            Shared(simulation, parts.Walls);
            parts.Playback = simulation.TryGetComponent(out IFluidPlaybackSource source) ? source.Playback : null;
            parts.Detail = simulation.TryGetComponent(out IFluidDetailSource worth) ? worth.Detail : default;
        }

        /// <summary>The emitters, drains or volumes that belong to a simulation, in hierarchy order where the scene plays.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <param name="specs">Receives them.</param>
        public static void Own<TSpec>(FluidSimulation simulation, List<TSpec> specs)
        {
            specs.Clear();
            IReadOnlyList<IFluidPart<TSpec>> parts = Parts<TSpec>(simulation);
            IReadOnlyList<FluidSimulation> simulations = Application.isPlaying || parts.Count == 0
                ? FluidSimulation.Active : SceneObjects.Find<FluidSimulation>(simulation);
            for (int i = 0; i < parts.Count; i++)
                if (Owner((Component)parts[i], (FluidSimulation)parts[i].Named, simulations) == simulation) specs.Add(parts[i].Spec);
        }

        /// <summary>The force zones that act on a simulation, which may share them, in hierarchy order where the scene plays.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <param name="specs">Receives them.</param>
        private static void Shared<TSpec>(FluidSimulation simulation, List<TSpec> specs)
        {
            specs.Clear();
            IReadOnlyList<IFluidPart<TSpec>> parts = Parts<TSpec>(simulation);
            for (int i = 0; i < parts.Count; i++)
                if (parts[i].Named == null || parts[i].Named == simulation) specs.Add(parts[i].Spec);
        }

        // In play the enabled ones list themselves, so that a frame makes no garbage.
        private static IReadOnlyList<IFluidPart<TSpec>> Parts<TSpec>(FluidSimulation simulation)
        {
            if (Application.isPlaying) return FluidParts<TSpec>.InOrder;
            var found = new List<IFluidPart<TSpec>>();
            foreach (MonoBehaviour behaviour in SceneObjects.Find<MonoBehaviour>(simulation))
                if (behaviour is IFluidPart<TSpec> part && behaviour.enabled) found.Add(part);
            return found;
        }

        private static bool Holds(FluidSimulation simulation, Vector3 world)
        {
            Vector3 local = DomainSpace.FromWorld(simulation.transform.position, simulation.transform.rotation).MultiplyPoint3x4(world);
            return DomainSpace.Holds(local, simulation.DomainSize);
        }
    }
}
