using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>
    /// A volume that is enabled while the liquid runs adds its liquid, or says why not; of one that changes, the inspector says what that
    /// means.
    /// </summary>
    public sealed class VolumesDuringPlayTests
    {
        private SimulationRig rig;
        private FluidSimulation simulation;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            simulation = rig.Create(liquid: false);
            simulation.StartJitter = 0f;
            Add("First", new Vector3(-0.1f, 0f, 0f));
        }

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator OneThatComesAddsItsLiquidOnce()
        {
            yield return Frames(2);
            Assert.That(simulation.ParticleCount, Is.EqualTo(64));
            FluidSolver solver = simulation.Solver;
            FluidVolume late = Add("Late", new Vector3(0.1f, 0f, 0f));
            yield return Frames(6);
            Assert.That(simulation.Solver, Is.SameAs(solver), "no new start");
            Assert.That(SimulationRig.Read(simulation).Length, Is.EqualTo(128));
            Assert.That(simulation.Messages.Where(m => m.Severity != FluidSeverity.Info), Is.Empty);
            Assert.That(simulation.DifferenceOf(late), Is.Null);
        }

        [UnityTest]
        public IEnumerator OneThatIsEnabledAgainAddsItsLiquidAgain()
        {
            FluidVolume volume = Add("Switched", new Vector3(0.1f, 0f, 0f));
            volume.enabled = false;
            yield return Frames(2);
            Assert.That(simulation.ParticleCount, Is.EqualTo(64));
            volume.enabled = true;
            yield return Frames(6);
            Assert.That(SimulationRig.Read(simulation).Length, Is.EqualTo(128));
            volume.enabled = false;
            yield return null;
            Assert.That(simulation.DifferenceOf(volume).Value.ToString(),
                Does.Contain("'Switched'").And.Contain("was disabled").And.Contain("Restart"));
            simulation.RemoveLiquid(simulation.transform.position, 2f * Vector3.one, Quaternion.identity);
            yield return Frames(6);
            Assert.That(SimulationRig.Read(simulation), Is.Empty);
            volume.enabled = true;
            yield return Frames(6);
            Assert.That(SimulationRig.Read(simulation).Length, Is.EqualTo(64));
        }

        [UnityTest]
        public IEnumerator OneThatAScriptAddsIsNotAddedTwice()
        {
            yield return Frames(2);
            FluidVolume late = Add("Late", new Vector3(0.1f, 0f, 0f));
            simulation.AddLiquid(late);
            yield return Frames(6);
            FluidCounters counters = simulation.Solver.ReadCountersNow();
            Assert.That((counters.Born, counters.Blocked), Is.EqualTo((64L, 0L)));
        }

        [UnityTest]
        public IEnumerator WhatCannotBeAddedIsNamedAndTheLiquidRunsOn()
        {
            yield return Frames(2);
            LogAssert.Expect(LogType.Warning, new Regex("'Far': The liquid volume lies outside.*adds no liquid.*Move it"));
            Add("Far", new Vector3(3f, 0f, 0f));
            LogAssert.Expect(LogType.Warning, new Regex("'Flat': The liquid volume's size is.*adds no liquid"));
            Add("Flat", Vector3.zero).Size = new Vector3(0.1f, 0f, 0.1f);
            yield return Frames(4);
            Assert.That(SimulationRig.Read(simulation).Length, Is.EqualTo(64));
            Assert.That(simulation.IsRunning);
        }

        [UnityTest]
        public IEnumerator AMethodWithAFixedNumberSaysSo()
        {
            simulation.Method = FluidMethodKind.Thesis;
            yield return Frames(2);
            LogAssert.Expect(LogType.Warning,
                new Regex("'Late': The liquid volume was enabled while 'Fluid' runs by the method Thesis.*Restart.*Standard"));
            Add("Late", new Vector3(0.1f, 0f, 0f));
            yield return Frames(3);
            Assert.That(simulation.ParticleCount, Is.EqualTo(64));
            Assert.That(simulation.Messages.Single(m => m.Severity == FluidSeverity.Warning).Issue, Is.EqualTo(FluidIssue.VolumeChanged));
            Assert.That(simulation.ResetSimulation());
            Assert.That(simulation.ParticleCount, Is.EqualTo(128));
        }

        [UnityTest]
        public IEnumerator OneThatMovesOrChangesIsNamedWithACure()
        {
            FluidVolume volume = Add("Moved", new Vector3(0.1f, 0f, 0f));
            yield return Frames(2);
            Assert.That(simulation.DifferenceOf(volume), Is.Null);
            volume.transform.localPosition += 0.02f * Vector3.up;
            Assert.That(simulation.DifferenceOf(volume).Value.ToString(),
                Does.Contain("'Moved'").And.Contain("moved or changed").And.Contain("Restart"));
            simulation.ResetSimulation();
            Assert.That(simulation.DifferenceOf(volume), Is.Null);
            volume.Size *= 0.5f;
            Assert.That(simulation.DifferenceOf(volume), Is.Not.Null);
            volume.Size *= 2f;
            simulation.transform.position += Vector3.one;
            Assert.That(simulation.DifferenceOf(volume), Is.Null, "it goes along with the domain");
            yield return null;
        }

        [UnityTest]
        public IEnumerator ADryDomainStartsWhenAVolumeComes()
        {
            FluidSimulation dry = rig.Create("Dry", false, new Vector3(5f, 0f, 0f));
            LogAssert.Expect(LogType.Error, new Regex("'Dry': The domain holds no liquid"));
            yield return Frames(3);
            Assert.That(dry.IsRunning, Is.False);
            rig.AddVolume(dry);
            yield return Frames(2);
            Assert.That((dry.IsRunning, dry.ParticleCount), Is.EqualTo((true, 64)));
        }

        private FluidVolume Add(string name, Vector3 place)
        {
            FluidVolume volume = rig.AddVolume(simulation, name);
            volume.transform.localPosition = place;
            return volume;
        }

        private static IEnumerator Frames(int count)
        {
            for (int frame = 0; frame < count; frame++) yield return null;
        }
    }
}
