using System;
using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A crate that is let go above a pool at rest gains no energy from it.</summary>
    public sealed class LetGoCrateTests
    {
        private const float Spacing = 0.06f, Fall = 0.11f, Gravity = 9.81f;

        private static readonly Vector3 Crate = new Vector3(0.42f, 0.3f, 0.42f);

        private readonly float fixedDelta = Time.fixedDeltaTime;
        private SimulationRig rig;
        private FluidSimulation simulation;
        private Rigidbody crate;

        private void SetUp(float ratio)
        {
            rig = new SimulationRig(1f / 60f);
            Time.fixedDeltaTime = Time.captureDeltaTime;
            simulation = rig.Create(liquid: false);
            simulation.Spacing = Spacing;
            simulation.DomainSize = new Vector3(12f, 18f, 12f) * Spacing;
            simulation.Boundaries = new FluidBoundaries { Periodic = FluidAxes.X | FluidAxes.Z };
            simulation.StartRelaxation = FluidStartRelaxation.Hydrostatic;
            FluidVolume water = rig.AddVolume(simulation);
            water.Size = new Vector3(12f, 8f, 12f) * Spacing;
            water.transform.localPosition = new Vector3(0f, -5f * Spacing, 0f);
            GameObject holder = rig.NewObject("Crate");
            holder.transform.position = new Vector3(0f, -Spacing + Fall + 0.5f * Crate.y, 0f);
            holder.AddComponent<BoxCollider>().size = Crate;
            crate = holder.AddComponent<Rigidbody>();
            crate.mass = ratio * 1000f * Crate.x * Crate.y * Crate.z;
        }

        [TearDown]
        public void TearDown()
        {
            Time.fixedDeltaTime = fixedDelta;
            rig.Dispose();
        }

        [UnityTest]
        public IEnumerator ItNeverRisesAboveItsReleaseHeightAndNoEnergyGrows([Values(0.15f, 0.5f)] float ratio)
        {
            SetUp(ratio);
            while (!simulation.IsRunning) yield return null;
            float released = crate.position.y, highest = float.NegativeInfinity, lowest = released;
            double begun = double.NaN, most = double.NegativeInfinity, drop = crate.mass * Gravity * Fall;
            string figures = $"drop {drop:0.00} J; ";
            while (simulation.SimulatedTime < 0.6)
            {
                yield return null;
                double energy = Energy(out float height);
                if (double.IsNaN(begun)) begun = energy;
                if (simulation.SimulatedTime > 0.2) highest = Mathf.Max(highest, Mathf.Max(height, crate.position.y));
                lowest = Mathf.Min(lowest, crate.position.y);
                most = Math.Max(most, energy - begun);
                figures += $"{simulation.SimulatedTime:0.00}: {crate.position.y - released:0.000} m, {energy - begun:0.00} J; ";
            }
            TestContext.WriteLine(figures);
            Assert.That(lowest, Is.LessThan(released - Fall), "it falls into the water");
            Assert.That(highest, Is.LessThan(released - 0.5f * Fall), figures);
            Assert.That(most, Is.LessThan(0.05 * drop), figures);
        }

        // Of motion, height and compression [J], with the crate as the liquid has it: the Rigidbody follows some frames later.
        private double Energy(out float height)
        {
            FluidSolverSettings settings = simulation.Solver.Settings;
            FluidParticle[] particles = SimulationRig.Read(simulation);
            float[] densities = GpuTest.Read<float>(simulation.Solver.Density, particles.Length);
            FloatingBodies bodies = simulation.Solver.State.Bodies.Floating;
            FloatingState state = bodies.ReadNow(bodies.Bodies.Single());
            height = state.Centre.y;
            double each = settings.ParticleMass, c = settings.SoundSpeed;
            double sum = particles.Sum(p => each * (0.5 * p.VelT0.sqrMagnitude + Gravity * p.Position.y));
            sum += densities.Select(d => Math.Max(1.0, d / settings.RestDensity)).Sum(r => each * c * c * (Math.Log(r) + 1.0 / r - 1.0));
            Vector3 turning = Vector3.Scale(crate.inertiaTensor, state.AngularVelocity);
            return sum + crate.mass * (0.5 * state.Velocity.sqrMagnitude + Gravity * height) +
                0.5 * Vector3.Dot(turning, state.AngularVelocity);
        }
    }
}
