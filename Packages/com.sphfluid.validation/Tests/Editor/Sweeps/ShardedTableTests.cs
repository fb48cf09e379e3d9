using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Lines of shards' tables as text: whose run they are, what is time and what is result.</summary>
    public sealed class ShardedTableTests
    {
        private static readonly ShardedTable table = ShardedTable.Of(MadeUpRow.Format, new[] { "name", "on" }, "speed_m_s");

        [Test]
        public void ALineKnowsItsRun()
        {
            Assert.That(table.KeyOf("\"a, b\",2.5,10,yes,device,2026-11-25"), Is.EqualTo("made-up.csv|a, b|yes"));
            Assert.That(table.KeyOf("a,2.5,10,yes,device"), Is.Null, "a line that was cut");
        }

        [Test]
        public void TimesAreLeftOutAndNothingElse() =>
            Assert.That(table.WithoutTimes("\"a, b\",2.5,10,yes,\"llvmpipe (LLVM, 256 bits)\",2026-11-25"),
                Is.EqualTo("\"a, b\",,10,yes,\"llvmpipe (LLVM, 256 bits)\",2026-11-25"));

        [Test]
        public void OnlyResultsDiffer()
        {
            Assert.That(table.Difference("a,2.5,10,yes,device,2026-11-25", "a,3.5,10,yes,another,2026-11-26"), Is.Null);
            Assert.That(table.Difference("a,2.5,10,yes,device,2026-11-25", "a,2.5,11,yes,device,2026-11-25"), Is.EqualTo("steps"));
        }

        // The session names its jobs as the table names its lines: else no run would be found.
        [Test]
        public void LeaksAndSurfacesNameTheirRunsAsTheirTablesDo()
        {
            LeakSceneEntry entry = LeakSceneEntry.Find("wall");
            var leak = new LeakResult { Scene = entry.Build(3.0) };
            leak.End = leak.Scene.Particles;
            var quality = new SurfaceQuality { State = "sphere", Variant = "default" };

            Assert.That(ShardedVerb.Find("leaks").Tables.Single().KeyOf(LeakResult.Format.Line(leak)),
                Is.EqualTo(ShardedTable.RunKey(LeakResult.Format, "wall")));
            Assert.That(ShardedVerb.Find("surfaces").Tables.Single().KeyOf(SurfaceQuality.Format.Line(quality)),
                Is.EqualTo(ShardedTable.RunKey(SurfaceQuality.Format, "sphere|default")));
        }

        [Test]
        public void TimedStepsAreNamedAsTheirTableNamesThem()
        {
            var point = new StepCostPoint(CaseMethod.Find("standard"), 2.25, 4200);
            string line = StepCostRow.Format.Line(StepCostRow.Of(point, 120, StepTimes.Of(new[] { 2.0 }, new[] { 1 })));
            ShardedTable steps = ShardedVerb.Find("chart").Tables.Single(t => t.IsOfTimes);

            Assert.That(steps.KeyOf(line), Is.EqualTo(ShardedTable.RunKey(StepCostRow.Format, point.Key)));
            Assert.That(steps.Difference(line, line.Replace("120", "99")), Is.Null);
        }

        [TestCase("Packages/com.sphfluid.validation/package.json")]
        [TestCase("Packages/com.sphfluid/package.json")]
        public void TheVersionIsThePackages(string file) =>
            Assert.That(File.ReadAllText(Path.GetFullPath(file)), Does.Contain($"\"version\": \"{SweepBuild.Version}\""));
    }
}
