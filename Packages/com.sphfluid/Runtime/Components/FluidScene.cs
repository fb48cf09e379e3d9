using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What a simulation finds in the scene: its liquid volumes, the space it lives in, where it looks for colliders.</summary>
    internal static class FluidScene
    {
        /// <summary>Distance of a liquid site from a collider below which it is left out, as a fraction of the spacing.</summary>
        public const float ObstacleClearance = 0.3f;

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

        /// <summary>Simulation space to world space: position and rotation of the simulation's transform, without scale.</summary>
        public static Matrix4x4 LocalToWorld(Transform transform) =>
            Matrix4x4.TRS(transform.position, transform.rotation, Vector3.one);

        /// <summary>World space to simulation space.</summary>
        public static Matrix4x4 WorldToLocal(Transform transform) => WorldToLocal(transform.position, transform.rotation);

        /// <summary>World space to the space of a pose.</summary>
        public static Matrix4x4 WorldToLocal(Vector3 position, Quaternion rotation)
        {
            Quaternion inverse = Quaternion.Inverse(rotation);
            return Matrix4x4.TRS(inverse * -position, inverse, Vector3.one);
        }

        /// <summary>Where the simulation, which is in a scene, looks for colliders.</summary>
        public static CollisionQuery Query(FluidSimulation simulation) => new CollisionQuery
        {
            Simulation = simulation,
            Scene = simulation.gameObject.scene.GetPhysicsScene(),
            Position = simulation.transform.position,
            Rotation = simulation.transform.rotation,
            DomainSize = simulation.DomainSize,
            Layers = simulation.ColliderLayers,
            Spacing = simulation.Spacing,
        };

        /// <summary>The spawner's request for shapes of liquid among the colliders gathered in <paramref name="collision"/>.</summary>
        public static SpawnRequest Request(FluidSimulation simulation, IReadOnlyList<LiquidShape> shapes, CollisionScene collision)
        {
            float clearance = ObstacleClearance * simulation.Spacing;
            bool obstacles = collision != null && collision.Solids.Count > 0;
            return new SpawnRequest
            {
                DomainSize = simulation.DomainSize,
                Spacing = simulation.Spacing,
                Shapes = shapes,
                MaxParticles = simulation.Profile != null ? simulation.Profile.MaxParticles : FluidProfile.ParticleLimit,
                Seed = simulation.Seed,
                Jitter = simulation.StartRelaxation == FluidStartRelaxation.None ? simulation.StartJitter : 0f,
                Obstacle = obstacles ? point => collision.FindCovering(point, clearance) : (Func<Vector3, int>)null,
                Velocity = simulation.VelocityField,
            };
        }

        static bool Holds(FluidSimulation simulation, Vector3 world)
        {
            Vector3 local = WorldToLocal(simulation.transform).MultiplyPoint3x4(world);
            Vector3 half = simulation.DomainSize * 0.5f;
            return Mathf.Abs(local.x) <= half.x && Mathf.Abs(local.y) <= half.y && Mathf.Abs(local.z) <= half.z;
        }
    }
}
