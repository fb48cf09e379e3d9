using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class PlayArgumentsTests
    {
        [Test]
        public void ReadsTheLiquidsFlagsBehindTheSeparator()
        {
            PlayArguments arguments =
                Parse("player", "--scene", "A.unity", "--out", "there", "--", "--method", "thesis", "--surface", "particles",
                "--particles", "4096", "--seed", "7", "--state", "a.ply", "--mesh", "b.ply", "--record", "c.csv");

            Assert.That(arguments.OutputFolder, Is.EqualTo("there"));
            Assert.That(arguments.Method, Is.EqualTo(FluidMethodKind.Thesis));
            Assert.That(arguments.Surface, Is.EqualTo("particles"));
            Assert.That(arguments.Particles, Is.EqualTo(4096));
            Assert.That(arguments.Seed, Is.EqualTo(7));
            Assert.That(arguments.StateFile, Is.EqualTo("a.ply"));
            Assert.That(arguments.MeshFile, Is.EqualTo("b.ply"));
            Assert.That(arguments.RecordFile, Is.EqualTo("c.csv"));
        }

        [TestCase("thesis", FluidMethodKind.Thesis)]
        [TestCase("thesis-printed", FluidMethodKind.ThesisPrinted)]
        public void NamesEveryMethod(string name, FluidMethodKind kind)
        {
            Assert.That(Parse("player", "--", "--method", name).Method, Is.EqualTo(kind));
        }

        [Test]
        public void KeepsTheSceneWithoutFlags()
        {
            PlayArguments arguments = Parse("player", "--scene", "A.unity", "--");

            Assert.That(arguments.Method, Is.Null);
            Assert.That(arguments.Surface, Is.Null);
            Assert.That(arguments.Particles, Is.Null);
            Assert.That(arguments.Seed, Is.Null);
            Assert.That(arguments.OutputFolder, Is.Null);
        }

        [Test]
        public void PassesOverFlagsOfOthersWithoutASeparator()
        {
            PlayArguments arguments = Parse("Unity", "-batchmode", "-executeMethod", "A.B", "--seed", "3", "-quit");

            Assert.That(arguments.Seed, Is.EqualTo(3));
        }

        [TestCase("--sead", "1", "--sead")]
        [TestCase("--seed", "-1", "--seed")]
        [TestCase("--seed", "x", "'x'")]
        [TestCase("--particles", "0", "from 1 to 2147483647")]
        [TestCase("--particles", "1.5", "whole number")]
        [TestCase("--surface", "bubbles", "marching-cubes-gs")]
        [TestCase("--method", "magic", "thesis")]
        [TestCase("--state", "a.txt", ".ply")]
        [TestCase("--record", "a.ply", ".csv")]
        public void NamesTheFlagAndTheCure(string flag, string value, string mentioned)
        {
            var exception = Assert.Throws<CommandLineException>(() => Parse("player", "--", flag, value));

            Assert.That(exception.Message, Does.Contain(flag));
            Assert.That(exception.Message, Does.Contain(mentioned));
            Assert.That(exception.Message, Does.Not.Contain("\n"));
        }

        [Test]
        public void AsksForAMissingValue()
        {
            Assert.That(() => Parse("player", "--", "--seed"),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("--seed needs a value"));
            Assert.That(() => Parse("player", "--", "--seed", "--mesh", "a.ply"),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("--seed needs a value"));
        }

        [Test]
        public void AutomaticComesWithABudget()
        {
            PlayArguments arguments = Parse("player", "--", "--method", "automatic", "--budget", "2.5");
            Assert.That(arguments.Method, Is.EqualTo(FluidMethodKind.Automatic));
            Assert.That(arguments.Budget, Is.EqualTo(2.5f));
            Assert.That(Parse("player", "--").Budget, Is.Null);
        }

        [Test]
        public void ABudgetWithoutAutomaticIsRefused()
        {
            Assert.That(() => Parse("player", "--", "--method", "standard", "--budget", "4"),
                Throws.TypeOf<CommandLineException>().With.Message.StartsWith("--budget acts with --method automatic only"));
        }

        [TestCase("Samples~/Fountain/Fountain.unity")]
        [TestCase("Fountain")]
        public void AWordBesideFlagsIsToldHowASceneIsNamed(string word)
        {
            Assert.That(() => Parse("player", "--", "--seed", "1", word),
                Throws.TypeOf<CommandLineException>().With.Message
                    .StartsWith($"'{word}' is not understood by play's liquid: flags begin with --, and a scene is named by --scene."));
        }

        [Test]
        public void ReadsTheFoldersOfSequences()
        {
            PlayArguments arguments = Parse("player", "--", "--sequence", "a", "--write-sequence", "b");
            Assert.That((arguments.Sequence, arguments.SequenceFolder), Is.EqualTo(("a", "b")));
            Assert.That(Parse("player", "--").Sequence, Is.Null);
        }

        [TestCase("--method", "standard")]
        [TestCase("--budget", "2")]
        [TestCase("--particles", "100")]
        [TestCase("--seed", "0")]
        [TestCase("--profile", "substeps=2")]
        public void WhatAPlayedLiquidDoesNotStartByIsRefused(string flag, string value)
        {
            var exception = Assert.Throws<CommandLineException>(() => Parse("player", "--", "--sequence", "a", flag, value));
            Assert.That(exception.Message, Does.StartWith(flag + " changes how a liquid starts"));
        }

        [Test]
        public void AFolderWithASequenceIsNotWrittenOver()
        {
            string folder = System.IO.Directory.CreateDirectory(TestFolder.Fresh()).FullName;
            try
            {
                Parse("player", "--", "--write-sequence", folder);
                System.IO.File.WriteAllText(System.IO.Path.Combine(folder, "sequence.json"), "{}");
                Assert.That(() => Parse("player", "--", "--write-sequence", folder),
                    Throws.TypeOf<CommandLineException>().With.Message.Contains("holds a sequence"));
            }
            finally
            {
                TestFolder.Delete(folder);
            }
        }

        private static PlayArguments Parse(params string[] words) => PlayArguments.Parse(words);
    }
}
