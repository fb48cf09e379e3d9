using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>The value of --shard, and the folder that follows from it.</summary>
    public sealed class ShardTests
    {
        [TestCase("1/1", 1, 1)]
        [TestCase("3/4", 3, 4)]
        [TestCase("10000/10000", 10000, 10000)]
        public void AShardIsRead(string value, int index, int count)
        {
            Shard shard = Shard.Parse("--shard", value);

            Assert.That((shard.Index, shard.Count), Is.EqualTo((index, count)));
            Assert.That(shard.ToString(), Is.EqualTo(value));
            Assert.That(shard, Is.EqualTo(new Shard(index, count)).And.Not.EqualTo(new Shard(index, count + 1)));
        }

        [TestCase("0/3")]
        [TestCase("4/3")]
        [TestCase("a/b")]
        [TestCase("1/0")]
        [TestCase("1/1000000")]
        [TestCase("1")]
        [TestCase("1/2/3")]
        [TestCase("-1/3")]
        [TestCase(" 1/3")]
        [TestCase("1/4294967297")]
        public void WhatIsNoneIsNamedWithItsCure(string value) => Assert.That(() => Shard.Parse("--shard", value),
            Throws.TypeOf<CommandLineException>().With.Message
                .EqualTo($"--shard must be I/N, one of N shards from 1/N to N/N with N at most 10000, such as 1/4; found '{value}'."));

        [Test]
        public void WithoutAFolderEachShardHasItsOwn()
        {
            Assert.That(LeakArguments.Parse(new[] { "--", "--shard", "2/3" }).OutputFolder, Is.EqualTo("Build/leaks-2-of-3"));
            Assert.That(LeakArguments.Parse(new[] { "--", "--out", "here", "--shard", "2/3" }).OutputFolder, Is.EqualTo("here"));
            Assert.That(LeakArguments.Parse(new[] { "--" }).OutputFolder, Is.EqualTo("Build/leaks"));
        }

        // Reading the command again gives the same plan.
        [TestCase("chart", "chart")]
        [TestCase("chart --quick --case heave,jet --method standard", "chart --quick --case heave jet --method standard")]
        [TestCase("stability --quick --method standard thesis --slice 3", "stability --quick --method standard thesis")]
        [TestCase("stability --map M1 --map M2 --method thesis-printed thesis robust standard-corrected standard --shard 1/2", "stability --map M1 M2")]
        [TestCase("stability --map M1 M2 M3 M4 M5 M6", "stability --map M1 M2 M3 M4 M5 M6")]
        [TestCase("leaks --scene wall cup --out x", "leaks --scene wall cup")]
        [TestCase("surfaces --quick", "surfaces --quick")]
        [TestCase("surfaces --state torus --variant default", "surfaces --state torus --variant default")]
        public void ACommandIsWhatChangesResults(string line, string command)
        {
            string[] words = ("--" + line.Substring(line.Split(' ')[0].Length)).Split(' ');
            Assert.That(Parse(line.Split(' ')[0], words).Command, Is.EqualTo(command));
            Assert.That(Parse(line.Split(' ')[0], ("--" + command.Substring(line.Split(' ')[0].Length)).Split(' ')).Command,
                Is.EqualTo(command));
        }

        private static MeasuringArguments Parse(string verb, string[] words)
        {
            switch (verb)
            {
                case "chart": return ChartArguments.Parse(words);
                case "stability": return StabilityArguments.Parse(words);
                case "leaks": return LeakArguments.Parse(words);
                default: return SurfaceArguments.Parse(words);
            }
        }
    }
}
