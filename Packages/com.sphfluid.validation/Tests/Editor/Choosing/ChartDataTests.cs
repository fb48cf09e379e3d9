using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>Which chart answers.</summary>
    public sealed class ChartDataTests
    {
        private string project;

        [SetUp]
        public void SetUp() => project = TestFolder.Fresh();

        [TearDown]
        public void TearDown() => TestFolder.Delete(project);

        [Test]
        public void TheNewestOfTheDeviceThatHasTheCaseAnswers()
        {
            Write("benchmarks/accuracy/old", "2026-11-21", MadeUpChart.Device);
            Write("benchmarks/accuracy/new", "2026-11-23", MadeUpChart.Device);
            Write("Build/chart", "2026-11-22", MadeUpChart.Device);
            Write("benchmarks/accuracy/other", "2026-11-24", "another device");

            Assert.That(ChartData.Newest(project, MadeUpChart.Device, "flat").Folder, Does.EndWith("new"));
            Assert.That(ChartData.Newest(project, MadeUpChart.Device, null).Folder, Does.EndWith("new"));
            Assert.That(ChartData.Newest(project, "another device", "flat").Date, Is.EqualTo("2026-11-24"));
        }

        [Test]
        public void WithoutAChartOfTheDeviceOneIsToBeMeasured()
        {
            Assert.That(() => ChartData.Newest(project, "a card", "flat"), Throws.TypeOf<CommandLineException>()
                .With.Message.Contains("There is no chart of a card").And.Message.Contains("./run chart --quick"));
            Write("Build/chart", "2026-11-22", MadeUpChart.Device);
            Assert.That(() => ChartData.Newest(project, MadeUpChart.Device, "waves"), Throws.TypeOf<CommandLineException>()
                .With.Message.Contains("has the case waves").And.Message.Contains("./run chart --case waves"));
        }

        [Test]
        public void AFolderWithoutAChartIsRefused()
        {
            Directory.CreateDirectory(project);
            Assert.That(() => ChartData.Read(project),
                Throws.TypeOf<CommandLineException>().With.Message.Contains("--chart").And.Message.Contains("accuracy.csv"));
            File.WriteAllLines(Path.Combine(project, "accuracy.csv"), new[] { ChartRow.Format.FirstLine });
            Assert.That(() => ChartData.Read(project), Throws.TypeOf<CommandLineException>().With.Message.Contains("no runs"));
            File.WriteAllLines(Path.Combine(project, "accuracy.csv"), new[] { ChartRow.Format.FirstLine, "broken" });
            Assert.That(() => ChartData.Read(project), Throws.TypeOf<CommandLineException>().With.Message.Contains("line 2"));
        }

        [Test]
        public void WithoutTimedStepsTheCasesTimesAreFitted()
        {
            var chart = new MadeUpChart();
            chart.Sweep("standard", 2.0, 5.0, 6, 8, 12, 18);
            var data = new ChartData("made up", chart.Rows, new StepCostRow[0]);

            Assert.That(data.CostOf(CaseMethod.Find("standard")), Is.Null, "a case that the catalogue has not");
            foreach (string method in new[] { "standard", "standard-corrected" }) // two of one kind
            {
                Assert.That(chart.Data().CostOf(CaseMethod.Find(method)).At(2000, 2.0),
                    Is.EqualTo(MadeUpChart.StepTimeOf(method, 2.0, 2000)).Within(1e-3));
            }
        }

        [Test]
        public void EveryWordNamesOneCase()
        {
            string[] names = ChooseArguments.Charted().SelectMany(c => c.Words.Prepend(c.Name)).ToArray();

            Assert.That(names, Is.Unique);
            foreach (string word in new[] { "splash", "pool", "waves", "channel", "impact" })
            {
                Assert.That(ChooseArguments.Find(word), Is.Not.Null, word);
            }
        }

        [TestCase("5%", 0.05)]
        [TestCase("0.05", 0.05)]
        [TestCase("2.5 %", 0.025)]
        [TestCase("150%", 1.5)]
        public void AnErrorIsAPartOrPerCent(string word, double expected) =>
            Assert.That(ChooseArguments.Parse(new[] { "player", "--", "--error", word }).Question.Error,
                Is.EqualTo(expected).Within(1e-12));

        private void Write(string folder, string date, string device)
        {
            var chart = new MadeUpChart();
            chart.Sweep("standard", 2.0, 5.0, 6, 12);
            foreach (ChartRow row in chart.Rows) (row.Device, row.Date) = (device, date);
            ChartRow.Format.Write(Path.Combine(project, folder), chart.Rows);
        }
    }
}
