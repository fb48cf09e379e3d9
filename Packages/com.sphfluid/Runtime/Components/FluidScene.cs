using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The liquid volumes that belong to a simulation.</summary>
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
        public static FluidSimulation Owner(FluidVolume volume, FluidSimulation[] simulations)
        {
            if (volume.Simulation != null) return volume.Simulation;
            // Nothing in a prefab asset is active.
            FluidSimulation parent = volume.GetComponentInParent<FluidSimulation>(SceneObjects.IsPrefabAsset(volume));
            if (parent != null) return parent;
            FluidSimulation only = null;
            int count = 0;
            foreach (FluidSimulation simulation in simulations)
            {
                if (!simulation.enabled) continue;
                count++;
                only = simulation;
            }
            return count == 1 ? only : Array.Find(simulations, s => s.enabled && Holds(s, volume.transform.position));
        }

        static bool Holds(FluidSimulation simulation, Vector3 world)
        {
            Vector3 local = DomainSpace.FromWorld(simulation.transform.position, simulation.transform.rotation).MultiplyPoint3x4(world);
            Vector3 half = simulation.DomainSize * 0.5f;
            return Mathf.Abs(local.x) <= half.x && Mathf.Abs(local.y) <= half.y && Mathf.Abs(local.z) <= half.z;
        }
    }
}
