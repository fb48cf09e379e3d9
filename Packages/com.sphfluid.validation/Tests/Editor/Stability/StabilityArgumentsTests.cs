using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class StabilityArgumentsTests
    {
        [Test]
        public void TakesAllMapsMethodsAndBordersWithoutFlags()
        {
            StabilityArguments arguments = Parse("player", "--");

            Assert.That(arguments.Maps.Select(m => m.Name), Is.EqualTo(new[] { "M1", "M2", "M3", "M4", "M5", "M6" }));
            Assert.That(arguments.Methods, Is.EqualTo(CaseMethod.All));
            Assert.That(arguments.Limits, Is.True);
            Assert.That(arguments.Slice, Is.Null);
        }

        [Test]
        public void LeavesThePrintedMethodOutWhenQuick()
        {
            Assert.That(Parse("player", "--", "--quick").Methods.Select(m => m.Name), Is.EqualTo(new[] { "thesis", "robust", "standard" }));
            Assert.That(Parse("player", "--", "--quick", "--method", "thesis-printed").Methods.Single().Name, Is.EqualTo("thesis-printed"));
        }

        [TestCase("--map", "M3", "M1")]
        [TestCase("--map", "M3,M1", "--quick")]
        [TestCase("--map=M3,M1", "--slice", "2.5")]
        public void TakesMapsAsWordsAndLists(params string[] words)
        {
            StabilityArguments arguments = Parse(new[] { "player", "--" }.Concat(words).ToArray());

            Assert.That(arguments.Maps.Select(m => m.Name), Is.EqualTo(new[] { "M3", "M1" }));
            Assert.That(arguments.Limits, Is.False, "borders belong to the whole");
        }

        [TestCase("--mp", "M1", "--map")]
        [TestCase("--map", "M7", "M1, M2, M3, M4, M5, M6")]
        [TestCase("--map", "M1,M1", "twice")]
        [TestCase("--method", "dfsph", "thesis")]
        [TestCase("--slice", "0", "'0'")]
        public void NamesTheFlagAndTheCure(string flag, string value, string mentioned)
        {
            var exception = Assert.Throws<CommandLineException>(() => Parse("player", "--", flag, value));

            Assert.That(exception.Message, Does.Contain(flag).And.Contain(mentioned));
        }

        [Test]
        public void ReadsSliceAndFolder()
        {
            StabilityArguments arguments = Parse("Unity", "--slice", "8", "--out", "there", "-batchmode");

            Assert.That(arguments.Slice, Is.EqualTo(TimeSpan.FromMinutes(8)));
            Assert.That(arguments.OutputFolder, Is.EqualTo("there"));
        }

        private static StabilityArguments Parse(params string[] words) => StabilityArguments.Parse(words);
    }
}
