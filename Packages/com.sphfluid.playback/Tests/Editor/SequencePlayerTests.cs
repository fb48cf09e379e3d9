using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A player without a simulation: what it gives while frames come late or not at all.</summary>
    public sealed class SequencePlayerTests
    {
        // Reads as the sequence's own reader does, when the gate is open.
        private sealed class Late : ISequenceReader, IDisposable
        {
            private readonly ISequenceReader files;

            public Late(ISequenceReader files) => this.files = files;

            public ManualResetEventSlim Gate { get; } = new ManualResetEventSlim(false);

            public void Read(int frame, SequenceSlot slot)
            {
                Gate.Wait();
                files.Read(frame, slot);
            }

            public void Dispose() => Gate.Dispose();
        }

        private readonly List<FluidMessage> messages = new List<FluidMessage>();
        private SequenceFiles files;
        private SequencePlan plan;
        private Late reader;
        private SequencePlayer player;

        [SetUp]
        public void SetUp()
        {
            messages.Clear();
            files = new SequenceFiles();
            files.Write(new[] { 0.0, 1.0, 2.0 }, i => new[] { new FluidParticle(0.1f * i * Vector3.right, 0.1f * Vector3.right, 3u) },
                Vector3.one, 0.1f);
            plan = SequencePlan.TryMake(new PlaybackOptions { Folder = files.Folder, Scale = 1f, MemoryBudget = 1, Interpolates = true },
                null, out _);
            reader = new Late(plan.MakeReader());
            player = new SequencePlayer(plan, null, messages.Add, reader);
        }

        [TearDown]
        public void TearDown()
        {
            reader.Gate.Set();
            player.Dispose();
            reader.Dispose();
            files.Dispose();
        }

        [Test]
        public void WhileAFrameIsNotReadTheLastOneStaysAndNobodyWaits()
        {
            MoveTo(0.0);
            Assert.That(TryTake(out _), Is.False);
            Assert.That((player.IsBuffering, player.ShownFrame), Is.EqualTo((true, -1)));
            reader.Gate.Set();
            Assert.That(TakeInTime().Time, Is.Zero);
            Assert.That((player.IsBuffering, player.ShownFrame), Is.EqualTo((false, 0)));
            Assert.That(TryTake(out _), Is.False, "it is shown already");
            Assert.That(player.IsBuffering, Is.False);
        }

        [Test]
        public void WhoeverWaitsHasTheFrame()
        {
            var opens = new Thread(() =>
            {
                Thread.Sleep(20);
                reader.Gate.Set();
            });
            opens.Start();
            player.MoveTo(1.5, 1, FluidPlaybackLoop.None, false, true);
            Assert.That(TryTake(out FluidPlaybackFrame frame), Is.True);
            opens.Join();
            Assert.That(frame.Particles[0].Position.x, Is.EqualTo(0.15f).Within(1e-6f));
            Assert.That((frame.Count, frame.Time, player.ShownFrame), Is.EqualTo((1, 1.5, 1)));
        }

        [Test]
        public void AJumpIsAJumpUntilItIsShown()
        {
            reader.Gate.Set();
            MoveTo(0.0, true);
            Assert.That(TakeInTime().IsJump, Is.True);
            MoveTo(0.5);
            Assert.That(TakeInTime().IsJump, Is.False);
            MoveTo(2.0, true);
            MoveTo(2.0);
            Assert.That(TakeInTime().IsJump, Is.True);
        }

        [Test]
        public void ANewLiquidIsShownWhatIsShownAlready()
        {
            reader.Gate.Set();
            MoveTo(1.0);
            TakeInTime();
            Assert.That(player.TryTake(Vector3.one, Vector3.zero, true, out FluidPlaybackFrame frame), Is.True);
            Assert.That(frame.Time, Is.EqualTo(1.0));
        }

        [Test]
        public void WhatIsLeftOutIsCountedInEachFrameAndNamedOnce()
        {
            reader.Gate.Set();
            for (int i = 0; i < 3; i++)
            {
                MoveTo(i);
                WaitAndTake(new Vector3(0.3f, 1f, 1f));
                Assert.That(player.LeftOut, Is.EqualTo(i < 2 ? 0 : 1));
            }
            Assert.That(messages.Single().ToString(),
                Does.Contain("1 particles of 'frame-00002.ply' are outside").And.Contain("made in one of 1 × 1 × 1 m"));
            MoveTo(0.0);
            WaitAndTake(Vector3.zero);
            Assert.That(messages.Count, Is.EqualTo(1));
        }

        // A liquid that starts forgets the messages before it, and the frames around the first may have been read by then.
        [Test]
        public void WhatCannotBeReadIsNamedWhenFramesAreTaken()
        {
            System.IO.File.WriteAllBytes(files["frame-00001.ply"], new byte[5]);
            reader.Gate.Set();
            MoveTo(0.0);
            Assert.That(SpinWait.SpinUntil(() => player.Reads >= 3, 5000), Is.True, "those around are tried");
            MoveTo(1.0);
            Assert.That(messages, Is.Empty);
            TryTake(out _);
            Assert.That(messages.Single().ToString(), Does.Contain("frame-00001.ply' was cut"));
        }

        private void MoveTo(double time, bool isJump = false) => player.MoveTo(time, 1, FluidPlaybackLoop.None, isJump, false);

        private bool TryTake(out FluidPlaybackFrame frame) => player.TryTake(Vector3.one, Vector3.zero, false, out frame);

        private FluidPlaybackFrame TakeInTime() => WaitAndTake(Vector3.one);

        private FluidPlaybackFrame WaitAndTake(Vector3 domain)
        {
            FluidPlaybackFrame frame = default;
            Assert.That(SpinWait.SpinUntil(() => player.TryTake(domain, Vector3.zero, false, out frame), TimeSpan.FromSeconds(30)));
            return frame;
        }
    }
}
