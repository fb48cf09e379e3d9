using System;
using System.Collections;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>
    /// What the rest of a scene makes of a liquid that is played: views, whitewater, queries, instruments, and what does nothing meanwhile.
    /// </summary>
    public sealed class PlayedSceneTests : PlaybackTest
    {
        [UnityTest]
        public IEnumerator WhatStepsALiquidIsRefusedMeanwhile()
        {
            yield return First;
            WriteDrift(100, Frame);
            Open();
            yield return null;
            Assert.That(() => simulation.Save(new MemoryStream()), Throws.InvalidOperationException.With.Message.Contains("played back"));
            Assert.That(() => simulation.AddImpulse(Vector3.zero, 0.1f, Vector3.up), Throws.InvalidOperationException);
            Assert.That(() => simulation.RemoveLiquid(Vector3.zero, 0.1f), Throws.InvalidOperationException);
            LogAssert.Expect(LogType.Error, new Regex("played back, so the save was not restored"));
            Assert.That(simulation.Restore(new MemoryStream()), Is.False);
            yield return null;
            Assert.That(simulation.IsPlayedBack);
        }

        [UnityTest]
        public IEnumerator EmittersAndZonesDoNothingAndAreNamed()
        {
            yield return First;
            WriteDrift(100, Frame);
            Open();
            foreach (Type part in new[] { typeof(FluidEmitter), typeof(FluidDrain), typeof(FluidForceZone) })
            {
                GameObject holder = rig.NewObject(part.Name);
                holder.transform.SetParent(simulation.transform, false);
                holder.AddComponent(part);
            }
            for (int i = 0; i < 10; i++) yield return null;
            Assert.That(simulation.ParticleCount, Is.EqualTo(1));
            Assert.That(simulation.Messages.Single().Text, Does.Contain("so 3 emitters, drains and force zones do nothing"));
        }

        [UnityTest]
        public IEnumerator WhitewaterLivesOnThroughPlayAndBeginsAnewAfterAJump()
        {
            yield return First;
            yield return RecordSplash();
            Open(spacing: 0.025f, domain: 0.6f);
            FluidWhitewater whitewater = simulation.gameObject.AddComponent<FluidWhitewater>();
            FluidDiagnostics diagnostics = simulation.gameObject.AddComponent<FluidDiagnostics>();
            diagnostics.Interval = 1;
            for (int i = 0; i < 25; i++) yield return null;
            Assert.That(diagnostics.MeasurementCount, Is.GreaterThan(10));
            Assert.That(diagnostics.Statistics.MaxSpeed, Is.GreaterThan(1f));
            Assert.That(simulation.Messages.Where(m => m.Issue == FluidIssue.Diagnosis), Is.Empty);
            long born = whitewater.Flow.ReadCounts().Born;
            int alive = (int)whitewater.Flow.ReadCounts().Particles;
            Assert.That(alive, Is.GreaterThan(100));
            playback.Pause();
            for (int i = 0; i < 3; i++) yield return null;
            Assert.That(whitewater.Flow.ReadCounts().Particles, Is.EqualTo(alive));
            playback.Play();
            yield return null;
            Assert.That(whitewater.Flow.ReadCounts().Particles, Is.GreaterThan(alive / 2), "it lives on");
            playback.Seek(2f * Frame);
            yield return null;
            Assert.That(whitewater.Flow.ReadCounts().Particles, Is.Zero, "after a jump");
            Assert.That(born, Is.Positive);
        }

        [UnityTest]
        public IEnumerator QueriesAndInstrumentsReadWhatIsPlayed()
        {
            yield return First;
            files.Write(Enumerable.Range(0, 200).Select(i => i * (double)Frame).ToArray(),
                _ => ParticleSets.Lattice(new Vector3Int(8, 4, 8), 0.05f, 0f, 1)
                    .Select(p => new FluidParticle(p.Position - 0.1f * Vector3.up, 0.5f * Vector3.right, p.Id)).ToArray(),
                0.4f * Vector3.one, SimulationRig.Spacing);
            Open();
            playback.Interpolate = false;
            FluidGauge gauge = Place<FluidGauge>(new Vector3(0f, -0.2f, 0f));
            gauge.Length = 0.4f;
            gauge.AveragingTime = 0f;
            FluidProbe probe = Place<FluidProbe>(new Vector3(0f, -0.1f, 0f));
            probe.Kind = FluidProbeKind.Velocity;
            FluidProbe pressure = Place<FluidProbe>(new Vector3(0f, -0.2f, 0f));
            LogAssert.Expect(LogType.Warning, new Regex("played back and not computed"));
            for (int i = 0; i < 10; i++) yield return null;
            gauge.ReadNow();
            probe.ReadNow();
            Assert.That(gauge.Height, Is.EqualTo(0.2f).Within(0.02f));
            Assert.That((probe.Velocity - 0.5f * Vector3.right).magnitude, Is.LessThan(0.01f));
            Assert.That(pressure.HasValue, Is.False);
            Assert.That(simulation.Queries.AnsweredTime, Is.EqualTo(9.0 * Frame).Within(3.0 * Frame));

            playback.Seek(0f);
            yield return null;
            yield return null;
            yield return null;
            gauge.ReadNow();
            Assert.That(gauge.HasValue, "readings begin anew where time goes back");
            Assert.That(gauge.ReadTime, Is.LessThan(4.0 * Frame));
        }

        [UnityTest]
        public IEnumerator AFrameOfPlayMakesNoGarbage()
        {
            yield return First;
            const int count = 257;
            FluidParticle[] particles = ParticleSets.Random(count, 0.3f * Vector3.one, 0f, 3);
            files.Write(Enumerable.Range(0, 300).Select(i => i * (double)Frame).ToArray(), _ => particles, 0.4f * Vector3.one,
                SimulationRig.Spacing);
            Open(speed: 0.7f, loop: FluidPlaybackLoop.Repeat);
            var meter = simulation.gameObject.AddComponent<BeginMeter>();
            simulation.gameObject.AddComponent<EndMeter>().Begin = meter;
            long most = 0;
            for (int i = 0; i < 40; i++)
            {
                yield return null;
                if (i > 10) most = Math.Max(most, meter.Made);
            }
            Assert.That(most, Is.Zero, "the component");

            SequencePlayer player = playback.Player;
            playback.WaitForFrames = true;
            for (int i = 1; i < 60; i++)
            {
                long before = GC.GetAllocatedBytesForCurrentThread();
                player.MoveTo(i * 0.7 * Frame, 1, FluidPlaybackLoop.Repeat, false, true);
                bool shows = player.TryTake(0.4f * Vector3.one, Vector3.zero, false, out FluidPlaybackFrame _);
                long made = GC.GetAllocatedBytesForCurrentThread() - before;
                Assert.That(shows, $"{i}");
                if (i > 10) most = Math.Max(most, made);
            }
            Assert.That(most, Is.Zero, "the particles");
        }

        // Before and after the playback's own frame.
        [DefaultExecutionOrder(39)]
        private sealed class BeginMeter : MonoBehaviour
        {
            public long Before { get; private set; }

            public long Made { get; set; }

            private void LateUpdate() => Before = GC.GetAllocatedBytesForCurrentThread();
        }

        [DefaultExecutionOrder(41)]
        private sealed class EndMeter : MonoBehaviour
        {
            public BeginMeter Begin { get; set; }

            private void LateUpdate() => Begin.Made = GC.GetAllocatedBytesForCurrentThread() - Begin.Before;
        }

        [UnityTest]
        public IEnumerator UnseenNothingIsReadAndTimeGoesOn()
        {
            yield return First;
            WriteDrift(100, Frame);
            Open();
            playback.CullUnseen = true;
            for (int i = 0; i < 5; i++) yield return null;
            Assert.That(playback.Player.Reads, Is.Zero);
            Assert.That((playback.CurrentFrame, playback.Time), Is.EqualTo((-1, 4f * Frame)));
            Camera camera = rig.NewObject("Camera").AddComponent<Camera>();
            camera.cullingMask = ~0;
            camera.transform.position = new Vector3(0f, 0f, -3f);
            yield return null;
            Assert.That(playback.CurrentFrame, Is.EqualTo(5));
            camera.transform.position = new Vector3(0f, 0f, 3f);
            for (int i = 0; i < 3; i++) yield return null;
            Assert.That((playback.CurrentFrame, playback.Time), Is.EqualTo((5, 8f * Frame)));
        }

        [UnityTest]
        public IEnumerator OtherOptionsBeginAnew()
        {
            yield return First;
            WriteDrift(9, Frame);
            Open();
            yield return null;
            SequencePlayer before = playback.Player;
            yield return null;
            Assert.That(playback.Player, Is.SameAs(before));
            playback.Interpolate = false;
            playback.Clock = FluidPlaybackClock.Manual;
            playback.Time = 2.75f * Frame;
            yield return null;
            Assert.That(playback.Player, Is.Not.SameAs(before));
            Assert.That(CentreX(), Is.EqualTo(0.03f).Within(1e-6f), "the nearer frame");
        }

        private T Place<T>(Vector3 position) where T : Component
        {
            GameObject holder = rig.NewObject(typeof(T).Name);
            holder.transform.SetParent(simulation.transform, false);
            holder.transform.localPosition = position;
            return holder.AddComponent<T>();
        }

        private IEnumerator RecordSplash()
        {
            FluidSimulation splash = rig.Create("Splash", liquid: false);
            splash.DomainSize = 0.6f * Vector3.one;
            splash.Spacing = 0.025f;
            FluidVolume water = rig.AddVolume(splash);
            water.Size = 0.25f * Vector3.one;
            water.transform.localPosition = new Vector3(-0.175f, 0.175f, -0.175f);
            using (var writer = new FluidSequenceWriter(files.Folder, splash.DomainSize, splash.Spacing))
            {
                for (int i = 0; i < 50; i++)
                {
                    yield return null;
                    if (splash.IsRunning && (writer.FrameCount == 0 || splash.SimulatedTime > 0.0)) writer.Write(splash);
                }
            }
            splash.enabled = false;
        }
    }
}
