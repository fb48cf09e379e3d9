using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Help and parser have the same flags; what is said of one is what it does.</summary>
    public sealed class CommandLineHelpTests
    {
        private static readonly Dictionary<string, Action<string[]>> Parsers = new Dictionary<string, Action<string[]>>
        {
            ["play"] = w => PlayArguments.Parse(w),
            ["bench"] = w => BenchArguments.Parse(w),
            ["chart"] = w => ChartArguments.Parse(w),
            ["choose"] = w => ChooseArguments.Parse(w),
            ["stability"] = w => StabilityArguments.Parse(w),
            ["leaks"] = w => LeakArguments.Parse(w),
            ["surfaces"] = w => SurfaceArguments.Parse(w),
            ["merge"] = w => MergeArguments.Parse(w),
            ["budgets"] = w => BudgetArguments.Parse(w),
            ["export"] = w => ExportArguments.Parse(w),
            ["peers"] = w => PeerArguments.Parse(w),
            ["figures"] = w => FigureArguments.Parse(w, new[] { "clumps" }),
        };

        private static IEnumerable<TestCaseData> Options() =>
            from verb in CommandLineHelp.Verbs
            from option in CommandLineHelp.FlagsOf(verb)
            select new TestCaseData(Parsers[verb], option).SetName($"{{m}}({verb} {option.Name})");

        private static IEnumerable<TestCaseData> Choices() =>
            from verb in CommandLineHelp.Verbs
            from option in CommandLineHelp.FlagsOf(verb)
            from choice in option.Choices
            select new TestCaseData(Parsers[verb], option.Name, choice).SetName($"{{m}}({verb} {option.Name} {choice})");

        [TestCaseSource(nameof(Options))]
        public void AFlagIsExplained(Action<string[]> parse, CommandLineOption option)
        {
            Assert.That(option.Name, Does.StartWith("--"));
            Assert.That(option.Text, Is.Not.Empty.And.Not.EndWith("."));
            if (option.Value == null)
                parse(new[] { "player", "--", option.Name });
            else
                Assert.That(() => parse(new[] { "player", "--", option.Name }),
                    Throws.TypeOf<CommandLineException>().With.Message.Contains("needs a value"));
        }

        [TestCaseSource(nameof(Choices))]
        public void EveryChoiceIsTaken(Action<string[]> parse, string flag, string choice) => parse(new[] { "player", "--", flag, choice });

        [Test]
        public void ASlipIsAnsweredWithTheNearest()
        {
            var flag = Assert.Throws<CommandLineException>(() => PlayArguments.Parse(new[] { "player", "--", "--sede", "1" }));
            var value =
                Assert.Throws<CommandLineException>(() => PlayArguments.Parse(new[] { "player", "--", "--surface", "marching-cube" }));

            Assert.That(flag.Message, Does.Contain("; did you mean --seed? Its flags are --"));
            Assert.That(value.Message, Does.EndWith("found 'marching-cube'; did you mean marching-cubes?"));
        }

        [Test]
        public void AnotherVerbIsRefused()
        {
            Assert.That(() => CommandLineHelp.FlagsOf("swim"), Throws.ArgumentException);
        }
    }
}
