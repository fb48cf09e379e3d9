using System.Collections;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>What a restore refuses, and what it leaves as it is.</summary>
    public sealed class SaveRefusalTests
    {
        private SimulationRig rig;
        private FluidSimulation simulation;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(0.01f);
            simulation = rig.Create();
        }

        [TearDown]
        public void TearDown()
        {
            LogAssert.ignoreFailingMessages = false;
            rig.Dispose();
        }

        private IEnumerator Play(int frames)
        {
            while (!simulation.IsRunning) yield return null;
            for (int i = 0; i < frames; i++) yield return null;
        }

        private byte[] Save()
        {
            var stream = new MemoryStream();
            simulation.Save(stream);
            return stream.ToArray();
        }

        private FluidMessage Refused(byte[] save)
        {
            LogAssert.ignoreFailingMessages = true;
            int logged = 0;
            void Count(FluidMessage message) => logged++;
            simulation.Reported += Count;
            ulong hash = simulation.ComputeStateHash();
            FluidSolver solver = simulation.Solver;
            Assert.That(simulation.Restore(new MemoryStream(save)), Is.False);
            Assert.That(simulation.Solver, Is.SameAs(solver));
            Assert.That(simulation.ComputeStateHash(), Is.EqualTo(hash));
            simulation.Reported -= Count;
            Assert.That(logged, Is.EqualTo(1));
            FluidMessage message = simulation.Messages.Last();
            Assert.That((message.Severity, message.Issue), Is.EqualTo((FluidSeverity.Error, FluidIssue.SaveInvalid)));
            Assert.That(message.ToString(), Does.Not.Contain("\n"));
            return message;
        }

        [UnityTest]
        public IEnumerator WhatIsNoSaveOrIsCutOrAltered()
        {
            yield return Play(3);
            byte[] save = Save(), altered = (byte[])save.Clone(), other = (byte[])save.Clone();
            altered[save.Length / 2] ^= 1;
            other[8]++;
            Assert.That(Refused(new byte[0]).Text, Does.Contain("cut"));
            Assert.That(Refused(save.Take(save.Length - 1).ToArray()).Text, Is.Not.Empty.And.Contain("cut").Or.Contain("missing"));
            Assert.That(Refused(altered).Text, Does.Contain("altered"));
            Assert.That(Refused(other).Text, Does.Contain($"version {SaveFile.Version + 1u}"));
            Assert.That(Refused(Enumerable.Repeat((byte)7, 100).ToArray()).Text, Does.Contain("no save"));
            yield return Play(3);
            Assert.That(simulation.Restore(new MemoryStream(save)), simulation.StatusMessage);
            Assert.That(simulation.StatusMessage, Is.Empty, "what was wrong with others is no message of this liquid");
        }

        [UnityTest]
        public IEnumerator ALiquidOfOtherSettingsNamesTheSetting()
        {
            yield return Play(2);
            byte[] save = Save();
            simulation.Spacing *= 1.5f;
            yield return Play(2);
            Assert.That(Refused(save).Text, Does.Contain("Particle Spacing").And.Contain("0.05 m").And.Contain("0.075 m"));
            simulation.Spacing = SimulationRig.Spacing;
            simulation.DomainSize = new Vector3(0.4f, 0.45f, 0.4f);
            yield return Play(2);
            Assert.That(Refused(save).Text, Does.Contain("Domain Size"));
            simulation.DomainSize = new Vector3(0.4f, 0.4f, 0.4f);
            simulation.Method = FluidMethodKind.Thesis;
            yield return Play(2);
            Assert.That(Refused(save).Text, Does.Contain("Method").And.Contain("Standard").And.Contain("Thesis"));
            simulation.Method = FluidMethodKind.Standard;
            rig.Profile.MaxParticles = 10;
            LogAssert.ignoreFailingMessages = true;
            yield return null;
            Assert.That(simulation.Restore(new MemoryStream(save)), Is.False);
            Assert.That(simulation.Messages.Last().Text, Does.Contain("64 particles").And.Contain("10"));
        }

        [UnityTest]
        public IEnumerator AStoppedLiquidHasNothingToSaveAndIsStartedByARestore()
        {
            yield return Play(4);
            byte[] save = Save();
            ulong hash = simulation.ComputeStateHash();
            simulation.StopSimulation();
            Assert.That(() => simulation.Save(new MemoryStream()),
                Throws.InvalidOperationException.With.Message.Contains("nothing to save"));
            Assert.That(() => simulation.Save(null), Throws.ArgumentNullException);
            Assert.That(() => simulation.Restore(null), Throws.ArgumentNullException);
            int started = 0;
            simulation.Started += _ => started++;
            Assert.That(simulation.Restore(new MemoryStream(save)), simulation.StatusMessage);
            Assert.That((started, simulation.IsRunning, simulation.ComputeStateHash()), Is.EqualTo((1, true, hash)));
            long steps = simulation.StepCount;
            yield return null;
            Assert.That(simulation.StepCount, Is.GreaterThan(steps));
            Assert.That(started, Is.EqualTo(1), "it is not started again");
        }

        [UnityTest]
        public IEnumerator WhatTheSceneDoesNotHaveIsNamed()
        {
            GameObject gate = rig.NewObject("Gate");
            gate.transform.position = new Vector3(0.15f, 0f, 0f);
            gate.AddComponent<BoxCollider>().size = new Vector3(0.02f, 0.3f, 0.3f);
            yield return Play(3);
            byte[] save = Save();
            Object.DestroyImmediate(gate);
            yield return Play(1);
            LogAssert.ignoreFailingMessages = true;
            Assert.That(simulation.Restore(new MemoryStream(save)), simulation.StatusMessage);
            FluidMessage message = simulation.Messages.Last(m => m.Issue == FluidIssue.SaveDiffers);
            Assert.That(message.Text, Does.Contain("Gate:BoxCollider"));
            yield return Play(3);
        }

        [UnityTest]
        public IEnumerator AReaderStopsBehindTheSave()
        {
            yield return Play(2);
            var stream = new MemoryStream();
            stream.WriteByte(1);
            simulation.Save(stream);
            stream.WriteByte(99);
            stream.Position = 1;
            Assert.That(simulation.Restore(stream), simulation.StatusMessage);
            Assert.That(stream.ReadByte(), Is.EqualTo(99));
        }

        [UnityTest]
        public IEnumerator APausedLiquidStaysAndItsTimeGoesOn()
        {
            yield return Play(3);
            simulation.Paused = true;
            yield return Play(2);
            byte[] save = Save();
            ulong hash = simulation.ComputeStateHash();
            simulation.Paused = false;
            yield return Play(3);
            Assert.That(simulation.ComputeStateHash(), Is.Not.EqualTo(hash));
            simulation.Paused = true;
            Assert.That(simulation.Restore(new MemoryStream(save)), simulation.StatusMessage);
            yield return Play(2);
            Assert.That(simulation.ComputeStateHash(), Is.EqualTo(hash));
        }
    }
}
