using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Frames that are read ahead: which, in which order, in how much memory, and those that cannot be read.</summary>
    public sealed class SequenceLoaderTests
    {
        // Frames of one particle that has the frame's number; a gate holds reads back.
        private sealed class Numbers : ISequenceReader
        {
            public readonly HashSet<int> Bad = new HashSet<int>();
            public readonly List<int> Order = new List<int>();
            public readonly ManualResetEventSlim Gate = new ManualResetEventSlim(true);

            public void Read(int frame, SequenceSlot slot)
            {
                Gate.Wait();
                Order.Add(frame);
                if (Bad.Contains(frame))
                {
                    throw frame % 2 == 0 ? (Exception)new SequenceException("is bad", "Mend it.") : new IOException("No disk.");
                }
                slot.Resize(1)[0] = new StoredParticle { Id = (uint)frame };
            }
        }

        private Numbers reader;
        private SequenceLoader loader;

        [SetUp]
        public void SetUp() => reader = new Numbers();

        [TearDown]
        public void TearDown()
        {
            reader.Gate.Set();
            loader?.Dispose();
            loader = null;
        }

        [Test]
        public void FramesAheadAreReadInTheOrderOfPlayAndNoMoreThanFit()
        {
            loader = new SequenceLoader(reader, 10, 4, 1);
            loader.Want(new SequenceWalk(3, 1, 10, FluidPlaybackLoop.None));
            foreach (int frame in new[] { 3, 4, 5, 6 }) CheckFrame(frame);
            Assert.That(loader.Find(7), Is.Null);
            loader.Want(new SequenceWalk(5, 1, 10, FluidPlaybackLoop.None));
            foreach (int frame in new[] { 5, 6, 7, 8 }) CheckFrame(frame);
            Assert.That(reader.Order, Is.EqualTo(new[] { 3, 4, 5, 6, 7, 8 }));
        }

        [Test]
        public void WhereAllFitEachIsReadOnce()
        {
            loader = new SequenceLoader(reader, 5, 5, 1);
            for (int round = 0; round < 3; round++)
            {
                for (int frame = 0; frame < 5; frame++)
                {
                    loader.Want(new SequenceWalk(frame, 1, 5, FluidPlaybackLoop.Repeat));
                    CheckFrame(frame);
                }
            }
            Assert.That(reader.Order, Is.EquivalentTo(new[] { 0, 1, 2, 3, 4 }));
            Assert.That(loader.Reads, Is.EqualTo(5));
        }

        [Test]
        public void AJumpReadsItsFrameNext()
        {
            reader.Gate.Reset();
            loader = new SequenceLoader(reader, 100, 8, 1);
            loader.Want(new SequenceWalk(0, 1, 100, FluidPlaybackLoop.None));
            loader.Want(new SequenceWalk(50, 1, 100, FluidPlaybackLoop.None));
            Assert.That(loader.Find(50), Is.Null);
            reader.Gate.Set();
            CheckFrame(50);
            CheckFrame(51);
            Assert.That(reader.Order.SkipWhile(f => f == 0).Take(2), Is.EqualTo(new[] { 50, 51 }));
        }

        [Test]
        public void AFrameThatCannotBeReadIsToldOnceAndTheNextOnesAreRead()
        {
            reader.Bad.UnionWith(new[] { 1, 2 });
            loader = new SequenceLoader(reader, 5, 3, 1);
            for (int round = 0; round < 2; round++)
            {
                for (int frame = 0; frame < 5; frame++)
                {
                    loader.Want(new SequenceWalk(frame, 1, 5, FluidPlaybackLoop.Repeat));
                    if (reader.Bad.Contains(frame))
                    {
                        loader.WaitFor(frame);
                        Assert.That(loader.HasFailed(frame));
                        Assert.That(loader.Find(frame), Is.Null);
                    }
                    else CheckFrame(frame);
                }
            }
            var told = new List<string>();
            while (loader.TryTakeFailure(out SequenceFailure failure)) told.Add($"{failure.Frame} {failure.Text} {failure.Cure}");
            Assert.That(told.Count, Is.EqualTo(2));
            Assert.That(told[0], Does.StartWith("1 cannot be read (No disk)"));
            Assert.That(told[1], Is.EqualTo("2 is bad Mend it."));
            Assert.That(reader.Order.Count(f => reader.Bad.Contains(f)), Is.EqualTo(2));
        }

        [Test]
        public void BackwardsAndThereAndBackTheyAreReadAhead([Values(FluidPlaybackLoop.None, FluidPlaybackLoop.Repeat,
            FluidPlaybackLoop.PingPong)] FluidPlaybackLoop loop)
        {
            loader = new SequenceLoader(reader, 7, 3, 1);
            var walk = new SequenceWalk(6, -1, 7, loop);
            for (int i = 0; i < 20; i++)
            {
                loader.Want(walk);
                CheckFrame(walk.Frame);
                if (!walk.Next()) break;
            }
        }

        [Test]
        public void AskingAndFindingMakesNoGarbage()
        {
            loader = new SequenceLoader(reader, 100, 8, 1);
            long made = long.MaxValue;
            for (int turn = 0; turn < 3; turn++)
            {
                for (int i = 0; i < 8; i++) loader.WaitFor(Want(i));
                long before = GC.GetAllocatedBytesForCurrentThread();
                for (int i = 0; i < 8; i++)
                {
                    loader.Want(new SequenceWalk(i, 1, 100, FluidPlaybackLoop.Repeat));
                    loader.Find(i);
                    loader.HasFailed(i);
                    loader.TryTakeFailure(out _);
                }
                made = Math.Min(made, GC.GetAllocatedBytesForCurrentThread() - before);
            }
            Assert.That(made, Is.Zero);
        }

        private int Want(int frame)
        {
            loader.Want(new SequenceWalk(frame, 1, 100, FluidPlaybackLoop.Repeat));
            return frame;
        }

        private void CheckFrame(int frame)
        {
            loader.WaitFor(frame);
            SequenceSlot slot = loader.Find(frame);
            Assert.That((slot.Frame, slot.Count, slot.Particles[0].Id), Is.EqualTo((frame, 1, (uint)frame)));
        }
    }
}
