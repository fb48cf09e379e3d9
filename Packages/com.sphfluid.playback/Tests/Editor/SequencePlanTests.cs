using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What is known of a sequence before it is played: memory, and what is wrong.</summary>
    public sealed class SequencePlanTests
    {
        private SequenceFiles files;

        [SetUp]
        public void SetUp() => files = new SequenceFiles();

        [TearDown]
        public void TearDown() => files.Dispose();

        [Test]
        public void FramesFillTheBudgetAndNoMore()
        {
            const int most = 20011, count = 9;
            Write(count, most);
            for (int budget = 1; budget < 8; budget++)
            {
                SequencePlan plan = Plan(budget, out FluidMessage? problem);
                long file = SequenceFiles.Ply(new FluidParticle[0]).Length + 4 + most * 28, each = most * 28, shown = most * 48;
                int fitting = (int)Math.Min(count, ((budget << 20) - file - shown) / each);
                if (fitting < 2)
                {
                    Assert.That(plan, Is.Null);
                    Assert.That(problem?.Text,
                        Does.Contain($"A Memory Budget of {budget} MiB holds fewer than two frames of {most} particles"));
                    continue;
                }
                Assert.That(plan.Slots, Is.EqualTo(fitting), $"{budget} MiB");
                Assert.That(plan.Bytes, Is.LessThanOrEqualTo(budget << 20));
            }
            Assert.That(Plan(1, out FluidMessage? needed), Is.Null);
            Assert.That(needed?.Cure, Is.EqualTo("Raise Memory Budget to 3 or more."));
            Assert.That(Plan(3, out _), Is.Not.Null);
            Assert.That(Plan(2, out _), Is.Null);
        }

        [Test]
        public void OneFrameAndEmptyFramesArePlayed()
        {
            files.Write(new[] { 0.0 }, _ => new FluidParticle[0], Vector3.one, 0.1f);
            Assert.That(Plan(1, out _).Slots, Is.EqualTo(1));
        }

        [Test]
        public void AnotherSpacingIsNamed()
        {
            Write(2, 3);
            Assert.That(Messages(Plan(1, out _), 0.1f), Is.Empty);
            Assert.That(Messages(Plan(1, out _), 0.1005f), Is.Empty);
            Assert.That(Messages(Plan(1, out _), 0.12f).Single(),
                Does.Contain("spacing of 0.1 m, and the simulation's is 0.12 m").And
                    .Contain("Set the simulation's Particle Spacing to 0.1."));
        }

        [Test]
        public void WhatDoesNothingIsNamed()
        {
            Write(2, 3);
            SequencePlan plan =
                SequencePlan.TryMake(new PlaybackOptions { Folder = files.Folder, Scale = 2f, MemoryBudget = 1 }, null, out _);
            Assert.That(Messages(plan, 0.1f).Single(), Does.Contain("Axes and Scale are not used"));
            using (var others = new SequenceFiles())
            {
                File.WriteAllBytes(others["a.ply"],
                    SequenceFiles.Ply(new FluidParticle[3], "ascii", new[] { "float x", "float y", "float z" }));
                var options =
                    new PlaybackOptions { Folder = others.Folder, Scale = 2f, MemoryBudget = 1, FrameRate = 30f, Interpolates = true };
                plan = SequencePlan.TryMake(options, null, out _);
                Assert.That(plan.Interpolates, Is.False);
                Assert.That(Messages(plan, 0.1f).Single(), Does.Contain("have no ids"));
            }
        }

        [TestCase("", 1f, "No folder is given")]
        [TestCase(" ", 1f, "No folder is given")]
        [TestCase("no such folder", 1f, "'no such folder' is no folder, so nothing is played.")]
        [TestCase("a\0b", 1f, "")]
        [TestCase(".", 0f, "Scale is 0")]
        [TestCase(".", float.NaN, "Scale is NaN")]
        [TestCase(".", float.PositiveInfinity, "Scale is Infinity")]
        public void WhatCannotBePlayedIsNamedWithACure(string folder, float scale, string expected)
        {
            Assert.That(SequencePlan.TryMake(new PlaybackOptions { Folder = folder, Scale = scale, MemoryBudget = 64, FrameRate = 30f },
                null, out FluidMessage? problem), Is.Null);
            Assert.That(problem?.Text, Does.Contain(expected));
            Assert.That(problem?.Issue, Is.EqualTo(FluidIssue.PlaybackInvalid));
            Assert.That(problem?.Severity, Is.EqualTo(FluidSeverity.Error));
            Assert.That(problem?.Cure, Is.Not.Empty);
        }

        private void Write(int frames, int most) =>
            files.Write(Enumerable.Range(0, frames).Select(i => 0.1 * i).ToArray(),
                i => ParticleSets.Random(i == 1 ? most : Math.Min(most, 7), Vector3.one, 1f, i), Vector3.one, 0.1f);

        private SequencePlan Plan(int budget, out FluidMessage? problem) =>
            SequencePlan.TryMake(new PlaybackOptions { Folder = files.Folder, Scale = 1f, MemoryBudget = budget, Interpolates = true },
                null, out problem);

        private static List<string> Messages(SequencePlan plan, float spacing)
        {
            var messages = new List<FluidMessage>();
            plan.Check(Vector3.one, spacing, messages);
            return messages.ConvertAll(m => $"{m.Text} {m.Cure}");
        }
    }
}
