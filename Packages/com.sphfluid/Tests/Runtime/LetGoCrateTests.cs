using System;
using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A light crate that is let go above a pool at rest gains no energy from it.</summary>
    public sealed class LetGoCrateTests
    {
        private const float Spacing = 0.06f, Ratio = 0.15f, Fall = 0.11f, Gravity = 9.81f;

        private static readonly Vector3 Crate = new Vector3(0.42f, 0.3f, 0.42f);

        private readonly float fixedDelta = Time.fixedDeltaTime;
        private SimulationRig rig;
        private FluidSimulation simulation;
        private Rigidbody crate;

        [SetUp]
        public void SetUp()
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
            crate.mass = Ratio * 1000f * Crate.x * Crate.y * Crate.z;
        }

        [TearDown]
        public void TearDown()
        {
            Time.fixedDeltaTime = fixedDelta;
            rig.Dispose();
        }

        [UnityTest]
        public IEnumerator ItNeverRisesAboveItsReleaseHeightAndNoEnergyGrows()
        {
            while (!simulation.IsRunning) yield return null;
            float released = crate.position.y, highest = float.NegativeInfinity, lowest = released;
            double begun = Energy(), most = begun;
            string figures = "";
            while (simulation.SimulatedTime < 1.2)
            {
                yield return null;
                if (simulation.SimulatedTime > 0.2) highest = Mathf.Max(highest, crate.position.y);
                lowest = Mathf.Min(lowest, crate.position.y);
                most = Math.Max(most, Energy());
                figures += $"{simulation.SimulatedTime:0.00}: {crate.position.y - released:0.000} {Energy() - begun:0.00}; ";
            }
            double drop = crate.mass * Gravity * Fall;
            TestContext.WriteLine(figures);
            Assert.That(lowest, Is.LessThan(released - Fall), "it falls into the water");
            Assert.That(highest, Is.LessThan(released), figures);
            Assert.That(most - begun, Is.LessThan(0.05 * drop), $"of {drop} J; {figures}");
        }

        // Of motion, height and compression [J].
        private double Energy()
        {
            FluidSolverSettings settings = simulation.Solver.Settings;
            FluidParticle[] particles = SimulationRig.Read(simulation);
            float[] densities = GpuTest.Read<float>(simulation.Solver.Density, particles.Length);
            double each = settings.RestDensity * Mathf.Pow(settings.Spacing, 3f), sum = 0.0;
            sum += particles.Sum(p => each * (0.5 * p.VelT0.sqrMagnitude + Gravity * p.Position.y));
            double squares = densities.Sum(d => d > settings.RestDensity ? Math.Pow(d / settings.RestDensity - 1.0, 2.0) : 0.0);
            sum += 0.5 * each * settings.SoundSpeed * settings.SoundSpeed * squares;
            Vector3 moment = Vector3.Scale(crate.inertiaTensor, crate.angularVelocity);
#pragma warning disable 618 // linearVelocity in Unity 6
            Vector3 velocity = crate.velocity;
#pragma warning restore 618
            return sum + crate.mass * (0.5 * velocity.sqrMagnitude + Gravity * crate.position.y) +
                0.5 * Vector3.Dot(moment, crate.angularVelocity);
        }
    }
}
