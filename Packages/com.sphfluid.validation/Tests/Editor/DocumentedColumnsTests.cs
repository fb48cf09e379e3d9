using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>The page "Output files" has every column of every measured table, in the order of the file, and no other.</summary>
    public sealed class DocumentedColumnsTests
    {
        private const string Page = "Packages/com.sphfluid.validation/Documentation~/output-files.md";

        private static IEnumerable<TestCaseData> Tables()
        {
            yield return Table("accuracy.csv", ChartRow.Format.Names);
            yield return Table("step-costs.csv", StepCostRow.Format.Names);
            yield return Table("step-fits.csv", StepFitRow.Format.Names);
            yield return Table("error-fits.csv", ErrorFitRow.Format.Names);
            yield return Table("pareto.csv", ParetoFront.Format.Names);
            yield return Table("equal-cost.csv", EqualCost.Format.Names);
            yield return Table("curves", CsvText.Split(CurveFile.FirstLine));
            yield return Table("choose.csv", ChoiceRow.Format.Names);
            yield return Table("choose-verify.csv", VerificationRow.Format.Names);
            yield return Table("stability.csv", StabilityRow.Format.Names);
            yield return Table("limits.csv", LimitRow.Format.Names);
            yield return Table("leaks.csv", LeakResult.Format.Names);
            yield return Table("budgets.csv", BudgetRow.Format.Names);
            yield return Table("peers.csv", PeerRow.Format.Names);
            yield return Table("peers-compared.csv", PeerComparison.Format.Names);
            yield return Table("surface-quality.csv", SurfaceQuality.Format.Names);
            yield return Table("shard.csv and shards.csv", ShardManifest.Format.Names);
            yield return Table("shard-plan.csv", SweepPlan.Format.Names);
            yield return Table("shard-runs.csv", ShardRunRow.Format.Names);
            yield return Table("thesis.csv and sweep.csv", new ThesisLayout("thesis", new[] { "BLOCK" }).Format.Names);
            yield return Table("solver.csv", new SolverLayout(new[] { "PART" }).Format.Names);
            yield return Table("playback.csv", PlaybackRow.Format.Names);
            yield return Table("surface.csv", new SurfaceLayout(new[] { "PART" }).Format.Names);
            yield return Table("Record", PlayRecorder.RecordColumns.Prepend("frame"));
        }

        private static TestCaseData Table(string heading, IEnumerable<string> columns) =>
            new TestCaseData(heading, columns.ToArray()).SetName($"ThePageHasTheColumnsThatAreWritten({heading})");

        [TestCaseSource(nameof(Tables))]
        public void ThePageHasTheColumnsThatAreWritten(string heading, string[] written) =>
            Assert.That(ColumnsUnder(heading, File.ReadAllText(Path.GetFullPath(Page))), Is.EqualTo(written));

        [Test]
        public void AColumnThatThePageLacksIsFound() =>
            Assert.That(
                ColumnsUnder("a.csv",
                    "## a.csv\n\n| Column | Meaning |\n|---|---|\n| `one`, `two` | `three` |\n| `four` | |\n\n## b.csv\n\n| Column | " +
                    "Meaning |\n|---|---|\n| `five` | |\n"),
                Is.EqualTo(new[] { "one", "two", "four" }));

        private static string[] ColumnsUnder(string heading, string page)
        {
            string section = Regex.Match(page, $@"^## {Regex.Escape(heading)}\n([\s\S]*?)(?=^## |\z)",
                RegexOptions.Multiline).Groups[1].Value;
            return Regex.Matches(section, @"^\| (`[^|]*)\|", RegexOptions.Multiline).Cast<Match>()
                .SelectMany(row => Regex.Matches(row.Groups[1].Value, "`([^`]+)`").Cast<Match>())
                .Select(name => name.Groups[1].Value).ToArray();
        }
    }
}
