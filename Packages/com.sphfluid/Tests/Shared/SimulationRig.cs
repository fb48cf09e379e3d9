using System;
using System.Collections.Generic;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// Small simulations made from code, with 64 particles each unless another number is given; everything is destroyed afterwards.
    /// </summary>
    internal sealed class SimulationRig : IDisposable
    {
        public const int Layer = 28;
        public const float Spacing = 0.05f;

        private readonly List<Object> made = new List<Object>();
        private readonly float captureDelta = Time.captureDeltaTime;

        public SimulationRig(float deltaTime = 0.01f)
        {
            GpuTest.Require();
            Time.captureDeltaTime = deltaTime;
            Profile = Object.Instantiate(TestAssets.Water);
            Profile.name = "Test Water";
            made.Add(Profile);
        }

        /// <summary>A copy of the water profile, free to change.</summary>
        public FluidProfile Profile { get; }

        /// <summary>A domain of 0.4 m with a cube of 0.2 m of liquid in it, on a layer of its own.</summary>
        public FluidSimulation Create(string name = "Fluid", bool liquid = true, Vector3 position = default)
        {
            GameObject holder = NewObject(name);
            holder.transform.position = position;
            FluidSimulation simulation = holder.AddComponent<FluidSimulation>();
            simulation.Profile = Profile;
            simulation.DomainSize = new Vector3(0.4f, 0.4f, 0.4f);
            simulation.Spacing = Spacing;
            simulation.ColliderLayers = 1 << Layer;
            simulation.MaxSubstepsPerFrame = 1000;
            if (liquid) AddVolume(simulation);
            return simulation;
        }

        /// <summary>A cube of liquid, 0.2 m wide, as a child.</summary>
        public FluidVolume AddVolume(FluidSimulation simulation, string name = "Liquid")
        {
            GameObject holder = NewObject(name);
            holder.transform.SetParent(simulation.transform, false);
            FluidVolume volume = holder.AddComponent<FluidVolume>();
            volume.Size = new Vector3(0.2f, 0.2f, 0.2f);
            return volume;
        }

        /// <summary>An object that is destroyed with the rig, on the rig's layer.</summary>
        public GameObject NewObject(string name)
        {
            var holder = new GameObject(name) { layer = Layer };
            made.Add(holder);
            return holder;
        }

        /// <summary>Particles now, by id.</summary>
        public static FluidParticle[] Read(FluidSimulation simulation)
        {
            var particles = new List<FluidParticle>();
            simulation.TryReadParticles(particles);
            particles.Sort((a, b) => a.Id.CompareTo(b.Id));
            return particles.ToArray();
        }

        /// <summary>Mean height in simulation space [m].</summary>
        public static float MeanHeight(FluidSimulation simulation)
        {
            float sum = 0f;
            FluidParticle[] particles = Read(simulation);
            foreach (FluidParticle particle in particles) sum += particle.Position.y;
            return sum / particles.Length;
        }

        public void Dispose()
        {
            Time.captureDeltaTime = captureDelta;
            foreach (Object item in made)
                if (item != null) Object.DestroyImmediate(item);
        }
    }
}
