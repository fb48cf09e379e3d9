using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class BenchArgumentsTests
    {
        [Test]
        public void MeasuresTheThesisTablesWithoutFlags()
        {
            BenchArguments arguments = Parse("player", "--device", "1", "--");

            Assert.That(arguments.Table, Is.EqualTo("thesis"));
            Assert.That(arguments.Particles, Is.Null, "the table's own");
            Assert.That(arguments.Grids, Is.Null, "the table's own");
            Assert.That(arguments.Samples, Is.EqualTo(5));
            Assert.That(arguments.Sweep, Is.Null);
        }

        [Test]
        public void ReadsTheFlagsBehindTheSeparator()
        {
            BenchArguments arguments =
                Parse("player", "--out", "elsewhere", "--", "--table=all", "--particles", "1000, 2000", "--grids", "64", "--repeat", "9",
                "--out", "there", "--sweep");

            Assert.That(arguments.Table, Is.EqualTo("all"));
            Assert.That(arguments.Particles, Is.EqualTo(new[] { 1000, 2000 }));
            Assert.That(arguments.Grids, Is.EqualTo(new[] { 64 }));
            Assert.That(arguments.Samples, Is.EqualTo(9));
            Assert.That(arguments.OutputFolder, Is.EqualTo("there"));
            Assert.That(arguments.Sweep, Is.True);
        }

        [Test]
        public void LeavesOutGridsAndSweep()
        {
            BenchArguments arguments = Parse("player", "--", "--grids", "none", "--no-sweep");

            Assert.That(arguments.Grids, Is.Empty);
            Assert.That(arguments.Sweep, Is.False);
        }

        [Test]
        public void PassesOverFlagsOfOthersWithoutASeparator()
        {
            Assert.That(Parse("Unity", "-batchmode", "-executeMethod", "A.B", "--repeat", "6").Samples, Is.EqualTo(6));
        }

        [TestCase("--tabel", "thesis", "--particles")]
        [TestCase("--table", "surfaces", "thesis, solver, surface, all")]
        [TestCase("--particles", "63", "64")]
        [TestCase("--particles", "1000,x", "'x'")]
        [TestCase("--particles", "1000,", "''")]
        [TestCase("--particles", "1000,1000", "twice")]
        [TestCase("--grids", "2048", "1024")]
        [TestCase("--repeat", "4", "from 5")]
        [TestCase("--repeat", "-5", "'-5'")]
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
            Assert.That(() => Parse("player", "--", "--out"),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("--out needs a value"));
            Assert.That(() => Parse("player", "--", "--sweep=1"),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("takes no value"));
        }

        private static BenchArguments Parse(params string[] words) => BenchArguments.Parse(words);
    }
}
