using System.Collections;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>Liquid of an open domain: it goes where colliders let it, as far as it may, anywhere in the world.</summary>
    public sealed class FarthestDistanceTests
    {
        private const float Frame = 1f / 64f;
        private const int Cube = 64; // particles

        private SimulationRig rig;
        private Mesh mesh;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(Frame);

        [TearDown]
        public void TearDown()
        {
            rig.Dispose();
            if (mesh != null) Object.DestroyImmediate(mesh);
        }

        // A cube of liquid of 0.2 m at the object.
        private FluidSimulation Open(Vector3 farthest, Vector3 position = default, bool liquid = true)
        {
            FluidSimulation simulation = rig.Create(position: position, liquid: liquid);
            simulation.Domain = FluidDomain.Open;
            simulation.FarthestDistance = farthest;
            return simulation;
        }

        // Slanting, as a mesh, in places that are exact far away too: multiples of 1/1024 m.
        private void AddStep(Vector3 position, Vector3 size, float slant = 0f)
        {
            if (mesh == null) mesh = TestMeshes.Cube();
            GameObject step = rig.NewObject("Step");
            step.transform.SetPositionAndRotation(position, Quaternion.Euler(0f, 0f, slant));
            step.transform.localScale = size;
            step.AddComponent<MeshCollider>().sharedMesh = mesh;
        }

        private FluidEmitter AddNozzle(FluidSimulation simulation, Vector3 place)
        {
            GameObject holder = rig.NewObject("Nozzle");
            holder.transform.SetPositionAndRotation(simulation.transform.position + place,
                Quaternion.LookRotation(Vector3.down, Vector3.right));
            FluidEmitter emitter = holder.AddComponent<FluidEmitter>();
            emitter.Simulation = simulation;
            emitter.Size = new Vector2(0.2f, 0.2f);
            emitter.Speed = 1f;
            return emitter;
        }

        private static IEnumerator Play(FluidSimulation simulation, int frames)
        {
            while (!simulation.IsRunning) yield return null;
            for (int i = 0; i < frames; i++) yield return null;
        }

        [UnityTest]
        public IEnumerator LiquidBeyondIsRemovedAndToldOnce(
            [Values(FluidMethodKind.Standard, FluidMethodKind.Robust)] FluidMethodKind method)
        {
            FluidSimulation simulation = Open(new Vector3(0.5f, 0.4f, 0.3f));
            simulation.Method = method;
            LogAssert.Expect(LogType.Warning, new Regex(
                @"'Fluid': Liquid goes farther than Farthest Distance, 0\.5 × 0\.4 × 0\.3 m from this object.*Raise Farthest Distance"));
            yield return Play(simulation, 40);
            Assert.That(simulation.RemovedParticles, Is.EqualTo(Cube));
            Assert.That(simulation.ParticleCount, Is.Zero);
            Assert.That(simulation.Messages.Select(m => m.Issue), Is.EqualTo(new[] { FluidIssue.FarthestReached }));
        }

        [UnityTest]
        public IEnumerator WhatIsDrainedIsNotToldOf()
        {
            FluidSimulation simulation = Open(2f * Vector3.one);
            GameObject holder = rig.NewObject("Drain");
            holder.transform.SetParent(simulation.transform, false);
            holder.transform.localPosition = new Vector3(0f, -0.3f, 0f);
            holder.AddComponent<FluidDrain>().Size = new Vector3(1f, 0.3f, 1f);
            yield return Play(simulation, 30);
            Assert.That(simulation.RemovedParticles, Is.EqualTo(Cube));
            Assert.That(simulation.Messages, Is.Empty);
        }

        [UnityTest]
        public IEnumerator ABudgetOfParticlesIsToldOf()
        {
            FluidSimulation simulation = Open(2f * Vector3.one, liquid: false);
            AddStep(new Vector3(0f, -0.5f, 0f), new Vector3(2f, 0.125f, 2f));
            AddNozzle(simulation, Vector3.zero);
            simulation.CapacityPolicy = FluidCapacityPolicy.Fixed;
            simulation.Capacity = 50;
            LogAssert.Expect(LogType.Warning, new Regex("'Fluid': The liquid has 50 particles, as many as it may have"));
            yield return Play(simulation, 40);
            Assert.That(simulation.ParticleCount, Is.EqualTo(50));
        }

        // Steps as for the speed that liquid has, not for that of a fall to the floor of the domain, and pressure that follows.
        [UnityTest]
        public IEnumerator StepsAreThoseOfTheLiquidNotOfTheDomain()
        {
            FluidSimulation simulation = Open(new Vector3(50f, 10f, 50f));
            AddStep(new Vector3(0f, -0.25f, 0f), new Vector3(2f, 0.125f, 2f));
            yield return Play(simulation, 2);
            Assert.That(simulation.Solver.Settings.MaxSpeed, Is.LessThan(3f), "20 m lower it were 14 m/s");
            yield return Play(simulation, 40);
            Assert.That(simulation.Solver.Settings.MaxSpeed, Is.LessThan(7f));
            Assert.That(simulation.Solver.ReadCountersNow().MaxCompression, Is.LessThan(0.2f));
            Assert.That(simulation.ParticleCount, Is.EqualTo(Cube), "the step holds it");
        }

        [UnityTest]
        public IEnumerator ASaveInAnOpenDomainGoesOnToTheBit()
        {
            FluidSimulation simulation = Open(new Vector3(50f, 10f, 50f));
            AddStep(new Vector3(0f, -0.25f, 0f), new Vector3(2f, 0.125f, 2f), 5f);
            AddNozzle(simulation, new Vector3(0.125f, 0.5f, 0f));
            yield return Play(simulation, 12);
            Assert.That(simulation.Solver.State.Sparse.AreUsed);
            var save = new MemoryStream();
            simulation.Save(save);
            yield return Play(simulation, 12);
            ulong first = simulation.ComputeStateHash();
            Assert.That(simulation.ParticleCount, Is.GreaterThan(Cube + 30));
            save.Position = 0L;
            Assert.That(simulation.Restore(save), simulation.StatusMessage);
            yield return Play(simulation, 12);
            Assert.That(simulation.ComputeStateHash(), Is.EqualTo(first));
        }

        [UnityTest]
        public IEnumerator MemoryDoesNotGrowWithTheWayThatLiquidGoes()
        {
            FluidSimulation simulation = Open(new Vector3(50f, 10f, 50f));
            simulation.SleepsAtRest = false;
            AddStep(new Vector3(0f, -0.25f, 0f), new Vector3(20f, 0.125f, 20f), -20f); // down along x
            yield return Play(simulation, 5);
            Vector3 begin = Middle(simulation);
            long bytes = simulation.GpuBytes;
            yield return Play(simulation, 150);
            Assert.That(Middle(simulation).x - begin.x, Is.GreaterThan(3f));
            Assert.That(simulation.GpuBytes, Is.EqualTo(bytes));
            Assert.That(simulation.ParticleCount, Is.EqualTo(Cube));
        }

        private static Vector3 Middle(FluidSimulation simulation)
        {
            FluidParticle[] particles = SimulationRig.Read(simulation);
            return particles.Aggregate(Vector3.zero, (sum, p) => sum + p.Position) / particles.Length;
        }

        [UnityTest]
        public IEnumerator TenKilometresAwayItIsTheSameToTheBit([Values(0f, 30f)] float turn)
        {
            var states = new List<FluidParticle[]>();
            foreach (Vector3 place in new[] { Vector3.zero, new Vector3(10000f, 0f, 10000f), new Vector3(-10000f, 500f, 10000f) })
            {
                FluidSimulation simulation = Open(new Vector3(50f, 10f, 50f), place);
                simulation.transform.rotation = Quaternion.Euler(0f, turn, 0f);
                AddStep(place + new Vector3(0.125f, -0.25f, 0.0625f), new Vector3(0.5f, 0.125f, 0.5f), -10f);
                AddStep(place + new Vector3(0.625f, -0.75f, 0.125f), new Vector3(1f, 0.125f, 1f));
                AddNozzle(simulation, new Vector3(0.125f, 0.5f, 0f));
                yield return Play(simulation, 40);
                states.Add(SimulationRig.Read(simulation));
                Assert.That(states[states.Count - 1].Count(p => p.Position.y > -0.9f), Is.GreaterThan(100), "the meshes hold it");
                simulation.gameObject.SetActive(false);
            }
            Assert.That(states[0].Length, Is.GreaterThan(100));
            for (int i = 1; i < states.Count; i++)
            {
                Assert.That(states[i].Select(p => p.Id), Is.EqualTo(states[0].Select(p => p.Id)));
                Assert.That(states[i].Select(p => p.Position), Is.EqualTo(states[0].Select(p => p.Position)));
            }
        }
    }
}
