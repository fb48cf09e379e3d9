using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class ChartArgumentsTests
    {
        private static readonly ValidationCase[] cases = { new FlatCase("one"), new FlatCase("two"), new FlatCase("gate") { Gate = true } };

        [Test]
        public void TakesEverythingButGatesWithoutFlags()
        {
            ChartArguments arguments = Parse("player", "--device", "1", "--");

            Assert.That(arguments.Cases.Select(c => c.Name), Is.EqualTo(new[] { "one", "two" }));
            Assert.That(arguments.Methods, Is.EqualTo(CaseMethod.All));
            Assert.That(arguments.Quick, Is.False);
            Assert.That(arguments.Slice, Is.Null);
        }

        [TestCase("--case", "two", "one", "--quick")]
        [TestCase("--case", "two,one", "--quick", "--quick")]
        [TestCase("--case", "two", "--case", "one")]
        [TestCase("--case=two,one", "--quick", "--quick", "--quick")]
        public void TakesNamesAsWordsListsAndRepeats(params string[] words)
        {
            ChartArguments arguments = Parse(new[] { "player", "--" }.Concat(words).ToArray());

            Assert.That(arguments.Cases.Select(c => c.Name), Is.EqualTo(new[] { "two", "one" }));
        }

        [Test]
        public void ReadsTheOtherFlags()
        {
            ChartArguments arguments =
                Parse("player", "--out", "elsewhere", "--", "--method", "thesis", "--out", "there", "--slice", "7.5", "--quick");

            Assert.That(arguments.Methods.Single().Name, Is.EqualTo("thesis"));
            Assert.That(arguments.OutputFolder, Is.EqualTo("there"));
            Assert.That(arguments.Slice, Is.EqualTo(TimeSpan.FromSeconds(450)));
            Assert.That(arguments.Quick, Is.True);
        }

        [TestCase("chart")]
        [TestCase("chart --quick", "--quick", "--slice", "3", "--out", "there")]
        [TestCase("chart --case two --method standard thesis", "--method", "standard,thesis", "--case", "two")]
        public void SaysItsCommandInShort(string command, params string[] words) =>
            Assert.That(Parse(new[] { "player", "--" }.Concat(words).ToArray()).Command, Is.EqualTo(command));

        [Test]
        public void AQuickChartEndsInTime()
        {
            Assert.That(Parse("player", "--", "--quick").Slice, Is.EqualTo(TimeSpan.FromMinutes(9)));
            Assert.That(Parse("player", "--", "--quick", "--slice", "20").Slice, Is.EqualTo(TimeSpan.FromMinutes(20)));
        }

        [Test]
        public void PassesOverFlagsOfOthersWithoutASeparator()
        {
            Assert.That(Parse("Unity", "--case", "two", "-batchmode", "-executeMethod", "A.B").Cases.Single().Name, Is.EqualTo("two"));
        }

        [TestCase("--cse", "one", "--case")]
        [TestCase("--case", "three", "one, two")]
        [TestCase("--case", "gate", "'gate'")]
        [TestCase("--case", "one,one", "twice")]
        [TestCase("--case", "one,", "empty")]
        [TestCase("--method", "dfsph", "thesis")]
        [TestCase("--slice", "0", "'0'")]
        [TestCase("--slice", "-3", "'-3'")]
        [TestCase("--slice", "NaN", "'NaN'")]
        [TestCase("--slice", "1e9", "'1e9'")]
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
            Assert.That(() => Parse("player", "--", "--case", "--quick"),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("--case needs a value"));
            Assert.That(() => Parse("player", "--", "--quick=1"),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("takes no value"));
        }

        private static ChartArguments Parse(params string[] words) => ChartArguments.Parse(words, cases);
    }
}
