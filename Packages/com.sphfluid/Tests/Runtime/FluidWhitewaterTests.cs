using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>The component: what it costs when it is off, what it leaves of the liquid, and when it begins anew.</summary>
    public sealed class FluidWhitewaterTests
    {
        private const int Frames = 14;

        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(1f / 60f);

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator OffItHoldsNoMemoryAndDispatchesNothing()
        {
            FluidSimulation simulation = Splash(out FluidWhitewater whitewater);
            whitewater.enabled = false;
            simulation.Paused = true;
            for (int frame = 0; frame < 3; frame++) yield return null;
            long dispatches = ComputeKernel.DispatchesRecorded;
            simulation.StepOnce();
            yield return null;
            long without = ComputeKernel.DispatchesRecorded - dispatches;
            Assert.That(whitewater.GpuBytes, Is.Zero);
            Assert.That(whitewater.Flow, Is.Null);

            whitewater.enabled = true;
            yield return null;
            Assert.That(whitewater.GpuBytes, Is.GreaterThan(2 * 48 * whitewater.MaxParticles));
            dispatches = ComputeKernel.DispatchesRecorded;
            yield return null;
            Assert.That(ComputeKernel.DispatchesRecorded - dispatches, Is.Zero, "paused");
            simulation.StepOnce();
            yield return null;
            Assert.That(ComputeKernel.DispatchesRecorded - dispatches, Is.GreaterThan(without), "with whitewater");

            whitewater.enabled = false;
            Assert.That(whitewater.GpuBytes, Is.Zero);
            dispatches = ComputeKernel.DispatchesRecorded;
            simulation.StepOnce();
            yield return null;
            Assert.That(ComputeKernel.DispatchesRecorded - dispatches, Is.EqualTo(without));
        }

        [UnityTest]
        public IEnumerator ALiquidWithoutWhitewaterMakesNoneUnlessTheComponentHasALookOfItsOwn()
        {
            FluidSimulation simulation = Splash(out FluidWhitewater whitewater);
            var liquid = ScriptableObject.CreateInstance<FluidLiquid>();
            liquid.Whitewater = false;
            simulation.Liquid = liquid;
            for (int frame = 0; frame < 3; frame++) yield return null;
            Assert.That(simulation.IsRunning, simulation.StatusMessage);
            Assert.That(whitewater.GpuBytes, Is.Zero);
            whitewater.OwnLook = true;
            yield return null;
            Assert.That(whitewater.GpuBytes, Is.Not.Zero);
            whitewater.OwnLook = false;
            liquid.Whitewater = true;
            yield return null;
            Assert.That(whitewater.GpuBytes, Is.Not.Zero);
            Object.DestroyImmediate(liquid);
        }

        [UnityTest]
        public IEnumerator EqualRunsHaveEqualWhitewaterAndTheLiquidDoesNotFeelIt()
        {
            FluidSimulation without = Splash(out FluidWhitewater off);
            FluidSimulation first = Splash(out FluidWhitewater one), second = Splash(out FluidWhitewater two);
            off.enabled = false;
            for (int frame = 0; frame < Frames; frame++) yield return null;
            Assert.That(first.ComputeStateHash(), Is.EqualTo(without.ComputeStateHash()));
            int count = (int)one.Flow.ReadCounts().Particles;
            Assert.That(count, Is.GreaterThan(100));
            Assert.That(two.Flow.ReadCounts().Particles, Is.EqualTo(count));
            Assert.That(Read(one, count), Is.EqualTo(Read(two, count)));
            foreach (Vector3 place in Places(one, count)) Assert.That(DomainSpace.Holds(place, first.DomainSize), Is.True, $"{place}");
        }

        [UnityTest]
        public IEnumerator WhatIsMoreThanItMayBeIsCountedAndReportedOnce()
        {
            FluidSimulation simulation = Splash(out FluidWhitewater whitewater);
            whitewater.MaxParticles = 64;
            whitewater.Amount = 20f;
            for (int frame = 0; frame < Frames; frame++) yield return null;
            WhitewaterCounts counts = whitewater.Flow.ReadCounts();
            Assert.That(counts.Particles, Is.InRange(1, 64));
            Assert.That(counts.Refused, Is.GreaterThan(100));
            FluidMessage message = simulation.Messages.Single(m => m.Issue == FluidIssue.WhitewaterFull);
            Assert.That(message.ToString(), Does.Contain("64").And.Contain("Raise Max Particles"));
        }

        [UnityTest]
        public IEnumerator ANewStartAndOtherParticlesBeginWithoutAny()
        {
            FluidSimulation simulation = Splash(out FluidWhitewater whitewater);
            for (int frame = 0; frame < Frames; frame++) yield return null;
            Assert.That(whitewater.Flow.ReadCounts().Particles, Is.GreaterThan(100));
            simulation.Solver.SetParticles(SimulationRig.Read(simulation).Select(p => new FluidParticle(p.Position, Vector3.zero, p.Id))
                .ToArray());
            yield return null;
            Assert.That(whitewater.Flow.ReadCounts().Born, Is.LessThan(20));

            for (int frame = 0; frame < Frames; frame++) yield return null;
            simulation.ResetSimulation();
            yield return null;
            Assert.That(whitewater.Flow.ReadCounts().Particles, Is.Zero);
            simulation.StopSimulation();
            yield return null;
            Assert.That(whitewater.GpuBytes, Is.Zero);
        }

        [UnityTest]
        public IEnumerator LiquidThatComesAndGoesHasWhitewater()
        {
            FluidSimulation simulation = Splash(out FluidWhitewater whitewater);
            for (int frame = 0; frame < Frames; frame++)
            {
                if (frame % 10 == 5)
                {
                    simulation.AddLiquid(new Vector3(0f, 0.12f, 0f), 0.15f * Vector3.one, Quaternion.identity, 3f * Vector3.down);
                }
                if (frame % 10 == 9) simulation.RemoveLiquid(new Vector3(0f, -0.15f, 0f), 0.08f);
                yield return null;
            }
            int count = (int)whitewater.Flow.ReadCounts().Particles;
            Assert.That(count, Is.GreaterThan(100));
            foreach (Vector3 place in Places(whitewater, count))
            {
                Assert.That(DomainSpace.Holds(place, simulation.DomainSize), Is.True, $"{place}");
            }
        }

        // A block that falls on its corner of the domain.
        private FluidSimulation Splash(out FluidWhitewater whitewater)
        {
            FluidSimulation simulation = rig.Create(liquid: false);
            simulation.Spacing = 0.02f;
            simulation.StartJitter = 0f;
            FluidVolume volume = rig.AddVolume(simulation);
            volume.transform.localPosition = new Vector3(-0.1f, -0.05f, -0.1f);
            volume.InitialVelocity = new Vector3(3f, -2f, 0.5f);
            whitewater = simulation.gameObject.AddComponent<FluidWhitewater>();
            whitewater.MaxParticles = 8192;
            return simulation;
        }

        private static float[] Read(FluidWhitewater whitewater, int count) =>
            GpuTest.Read<float>(whitewater.Flow.Buffers.Present, count * WhitewaterBuffers.Stride / 4);

        private static System.Collections.Generic.IEnumerable<Vector3> Places(FluidWhitewater whitewater, int count)
        {
            float[] read = Read(whitewater, count);
            return Enumerable.Range(0, count).Select(i => new Vector3(read[12 * i], read[12 * i + 1], read[12 * i + 2]));
        }
    }
}
