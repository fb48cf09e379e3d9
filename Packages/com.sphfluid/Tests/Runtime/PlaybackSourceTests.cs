using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A simulation beside a component that plays a liquid.</summary>
    public sealed class PlaybackSourceTests
    {
        private SimulationRig rig;
        private FluidSimulation simulation;
        private Source source;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            simulation = rig.Create();
            source = simulation.gameObject.AddComponent<Source>();
        }

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator WhatItGivesIsShownInPlaceOfTheLiquid()
        {
            yield return null;
            for (int count = 0; count <= Source.Most; count++)
            {
                source.Count = count;
                yield return null;
                Assert.That(simulation.IsPlayedBack);
                FluidParticle[] shown = SimulationRig.Read(simulation).OrderBy(p => p.Id).ToArray();
                Assert.That(shown.Select(p => p.Position), Is.EqualTo(Enumerable.Range(0, count).Select(Source.Place)));
                Assert.That((simulation.ParticleCount, simulation.SimulatedTime), Is.EqualTo((count, (double)count)));
            }
        }

        [UnityTest]
        public IEnumerator WithoutAPlaybackItSimulates()
        {
            source.enabled = false;
            for (int frame = 0; frame < 3; frame++) yield return null;
            int filled = simulation.ParticleCount;
            Assert.That((simulation.IsPlayedBack, filled > Source.Most), Is.EqualTo((false, true)));
            source.enabled = true;
            yield return null;
            Assert.That((simulation.IsPlayedBack, simulation.ParticleCount), Is.EqualTo((true, source.Count)));
        }

        [UnityTest]
        public IEnumerator AnErrorOfItsCheckKeepsTheSimulationFromStarting()
        {
            source.IsBad = true;
            LogAssert.Expect(LogType.Error, new Regex("The film is torn"));
            yield return null;
            yield return null;
            Assert.That((simulation.IsRunning, simulation.StatusMessage), Is.EqualTo((false, simulation.Messages.Single().ToString())));
        }

        [UnityTest]
        public IEnumerator MoreParticlesThanItSaidAreNamed()
        {
            yield return null;
            source.Count = Source.Most + 1;
            LogAssert.Expect(LogType.Error,
                new Regex($"{Source.Most + 1} particles, more than the {Source.Most} that its MostParticles gave"));
            yield return null;
            Assert.That(simulation.IsRunning, Is.False);
        }

        [TestCase(-1, 0.0)]
        [TestCase(3, 0.0)]
        [TestCase(1, double.NaN)]
        public void AFrameThatCannotBeIsRefused(int count, double time)
        {
            using (var particles = new NativeArray<FluidParticle>(2, Allocator.Persistent))
                Assert.That(() => new FluidPlaybackFrame(particles, count, time, false), Throws.ArgumentException);
        }

        [DefaultExecutionOrder(40)]
        private sealed class Source : MonoBehaviour, IFluidPlaybackSource, IFluidPlayback
        {
            public const int Most = 3;

            private NativeArray<FluidParticle> particles;

            public IFluidPlayback Playback => enabled ? this : null;

            public long MostParticles => Most;

            public int Count { get; set; } = 2;

            public bool IsBad { get; set; }

            public static Vector3 Place(int number) => new Vector3(0f, 0.1f * number - 0.1f, 0f);

            public void Check(Vector3 domainSize, float spacing, List<FluidMessage> messages)
            {
                if (IsBad)
                {
                    messages
                        .Add(new FluidMessage(FluidSeverity.Error, FluidIssue.PlaybackInvalid, this, "The film is torn.", "Splice it."));
                }
            }

            public bool TryTake(Vector3 domainSize, Vector3 period, bool isNew, out FluidPlaybackFrame frame)
            {
                for (int i = 0; i < Count; i++) particles[i] = new FluidParticle(Place(i), Vector3.zero, (uint)i);
                frame = new FluidPlaybackFrame(particles, Count, Count, isNew);
                return true;
            }

            private void Awake() => particles = new NativeArray<FluidParticle>(Most + 1, Allocator.Persistent);

            private void OnDestroy() => particles.Dispose();
        }
    }
}
