using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Every flag of every verb with every kind of wrong value: one line that names the flag.</summary>
    public sealed class CommandLineTableTests
    {
        private static readonly string[] NoNames = { "", " ", "-1", "NaN", "no such thing", "99999999999999999999", "\n" };
        private static readonly string[] NoCounts = { "", " ", "-1", "0", "NaN", "1.5", "1e30", "0x10", "1_000",
            "99999999999999999999", "many" };
        private static readonly string[] NoSeeds = { "", "-1", "NaN", "1.5", "1e30", "99999999999999999999", "many" };
        private static readonly string[] NoProfiles = { "", "2", "substeps", "substeps=", "substeps=-1", "substeps=NaN", "sub=2", "=2",
            "substeps=2,", "substeps=2,substeps=3", "support-ratio=2;substeps=2" };
        private static readonly string[] NoMinutes = { "", "-1", "0", "NaN", "Infinity", "1e30", "1e-30", "99999999999999999999", "soon" };
        private static readonly string[] NoShares = { "", " ", "-1", "-5%", "0", "0%", "%", "NaN", "Infinity", "1e30",
            "5 per cent", "soon" };
        private static readonly string[] NoShards = { "", " ", "1", "/", "1/", "/2", "0/3", "4/3", "1/0", "0/0", "-1/3", "+1/3", "1/-3",
            "a/b", "1.0/3", "1/2/3", "1/1000000", "1/99999999999999999999" };
        private static readonly string[] NoFolders = { "", " " };
        private static readonly string[] NoFiles = { "", " ", "a", ".ply", ".csv", "a.txt" };

        private static readonly (string Verb, Action<string[]> Parse, (string Flag, string[] Wrong)[] Flags)[] Verbs =
        {
            ("play", w => PlayArguments.Parse(w), new[]
            {
                ("--method", NoNames), ("--budget", NoMinutes), ("--surface", NoNames), ("--particles", NoCounts), ("--seed", NoSeeds),
                ("--profile", NoProfiles), ("--sequence", NoFolders), ("--write-sequence", NoFolders), ("--state", NoFiles),
                ("--mesh", NoFiles), ("--record", NoFiles),
            }),
            ("bench", w => BenchArguments.Parse(w), new[]
            {
                ("--table", NoNames), ("--particles", NoCounts), ("--grids", NoCounts), ("--repeat", NoCounts), ("--out", NoFolders),
            }),
            ("chart", w => ChartArguments.Parse(w),
                new[] { ("--case", NoNames), ("--method", NoNames), ("--slice", NoMinutes), ("--shard", NoShards), ("--out", NoFolders) }),
            ("choose", w => ChooseArguments.Parse(w), new[]
            {
                ("--case", NoNames), ("--error", NoShares), ("--ms", NoShares), ("--fps", NoShares), ("--length", NoShares),
                ("--speed", NoShares),
                ("--volume", NoShares), ("--compression", NoShares), ("--chart", NoFolders), ("--verify", NoCounts), ("--out", NoFolders),
            }),
            ("stability", w => StabilityArguments.Parse(w),
                new[] { ("--map", NoNames), ("--method", NoNames), ("--slice", NoMinutes), ("--shard", NoShards), ("--out", NoFolders) }),
            ("leaks", w => LeakArguments.Parse(w), new[] { ("--scene", NoNames), ("--shard", NoShards), ("--out", NoFolders) }),
            ("surfaces", w => SurfaceArguments.Parse(w),
                new[] { ("--state", NoNames), ("--variant", NoNames), ("--shard", NoShards), ("--out", NoFolders) }),
            ("merge", w => MergeArguments.Parse(w), new[] { ("--out", NoFolders) }),
            ("budgets", w => BudgetArguments.Parse(w),
                new[] { ("--budget", NoMinutes), ("--particles", NoCounts), ("--repeat", NoCounts), ("--out", NoFolders) }),
            ("export", w => ExportArguments.Parse(w), new[]
            {
                ("--scene", NoFiles), ("--engine", NoNames), ("--scheme", NoNames), ("--seconds", NoShares), ("--frame-rate", NoShares),
                ("--spacing", NoShares),
                ("--particles", NoCounts), ("--ranks", NoCounts), ("--out", NoFolders),
            }),
            ("peers", w => PeerArguments.Parse(w),
                new[] { ("--case", NoNames), ("--python", NoFolders), ("--chart", NoFolders), ("--slice", NoMinutes),
                    ("--out", NoFolders) }),
            ("figures", w => FigureArguments.Parse(w, new[] { "clumps" }), new[] { ("--only", NoNames), ("--out", NoFolders) }),
        };

        private static IEnumerable<TestCaseData> Rows() =>
            from verb in Verbs
            from flag in verb.Flags
            from wrong in flag.Wrong
            from joined in new[] { false, true }
            select new TestCaseData(verb.Parse, flag.Flag, wrong, joined)
                .SetName($"AWrongValueIsOneLine({verb.Verb} {flag.Flag}{(joined ? "=" : " ")}'{wrong.Replace("\n", "newline")}')");

        private static IEnumerable<TestCaseData> Flags() =>
            from verb in Verbs
            from flag in verb.Flags
            select new TestCaseData(verb.Parse, flag.Flag).SetName($"AFlagAlone({verb.Verb} {flag.Flag})");

        private static IEnumerable<TestCaseData> EveryVerb() =>
            from verb in Verbs select new TestCaseData(verb.Verb, verb.Parse).SetName($"AnUnknownFlag({verb.Verb})");

        private static IEnumerable<TestCaseData> Folders() =>
            from verb in Verbs
            where verb.Flags.Any(f => f.Flag == "--out")
            select new TestCaseData(verb.Parse).SetName($"AFileInPlaceOfAFolder({verb.Verb} --out)");

        [TestCaseSource(nameof(Rows))]
        public void IsRefused(Action<string[]> parse, string flag, string wrong, bool joined) =>
            Expect(parse, flag, joined ? new[] { flag + "=" + wrong } : new[] { flag, wrong });

        [TestCaseSource(nameof(Flags))]
        public void NeedsAValue(Action<string[]> parse, string flag) => Expect(parse, flag, flag);

        [TestCaseSource(nameof(EveryVerb))]
        public void IsNamedWithThoseThatThereAre(string verb, Action<string[]> parse)
        {
            Assert.That(Expect(parse, "--sead", "--sead", "3"), Does.Contain("Its flags are --"));
            Expect(parse, "stray", "stray");
        }

        [TestCaseSource(nameof(Folders))]
        public void IsRefusedBeforeAnythingIsComputed(Action<string[]> parse)
        {
            string file = Path.GetTempFileName();
            try
            {
                Assert.That(Expect(parse, "--out", "--out", file), Does.Contain("is a file; name a folder"));
                Assert.That(Expect(parse, "--out", "--out", Path.Combine(file, "below")), Does.Contain("is a file"));
                Assert.That(Expect(parse, "--out", "--out", Path.Combine(Path.GetTempPath(), new string('x', 300))),
                    Does.Contain("cannot be written"));
            }
            finally
            {
                File.Delete(file);
            }
        }

        [Test]
        public void AFlagGivenTwiceIsRefused()
        {
            Assert.That(Expect(w => PlayArguments.Parse(w), "--seed", "--seed", "1", "--seed=2"), Does.Contain("given twice"));
            Assert.That(Expect(w => ChartArguments.Parse(w), "--out", "--out", "a", "--out", "b"), Does.Contain("given twice"));
        }

        [Test]
        public void TwoResultsInOneFileAreRefused()
        {
            Expect(w => PlayArguments.Parse(w), "--mesh", "--state", "a.ply", "--mesh", "./a.ply");
        }

        [TestCase("--state", ".ply")]
        [TestCase("--mesh", ".ply")]
        [TestCase("--record", ".csv")]
        public void AFileThatCannotBeWrittenIsRefused(string flag, string ending)
        {
            Assert.That(Expect(w => PlayArguments.Parse(w), flag, flag, Path.Combine(Path.GetTempPath(), new string('x', 300) + ending)),
                Does.Contain("cannot be written"));
            PlayArguments.Parse(new[] { "player", "--", flag, Path.Combine(Path.GetTempPath(), "no such folder", "a" + ending) });
            Assert.That(Directory.Exists(Path.Combine(Path.GetTempPath(), "no such folder")), Is.False,
                "nothing is made before there is something to write");
        }

        private static string Expect(Action<string[]> parse, string flag, params string[] words)
        {
            var exception = Assert.Throws<CommandLineException>(() => parse(new[] { "player", "--" }.Concat(words).ToArray()));
            Assert.That(exception.Message, Does.Contain(flag));
            Assert.That(exception.Message, Does.Not.Contain("\n"));
            Assert.That(exception.Message.Length, Is.LessThan(1000));
            return exception.Message;
        }
    }
}
