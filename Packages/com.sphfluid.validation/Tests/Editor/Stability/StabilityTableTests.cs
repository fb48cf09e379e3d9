using System;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class StabilityTableTests
    {
        string folder;

        [SetUp]
        public void SetUp() => folder = Path.Combine(Path.GetTempPath(), "sphfluid-stability-" + Guid.NewGuid().ToString("N"));

        [TearDown]
        public void TearDown()
        {
            if (Directory.Exists(folder))
                Directory.Delete(folder, true);
        }

        [Test]
        public void ReadsItsOwnLines()
        {
            foreach (StabilityCause cause in StabilityCauses.All.Concat(new[] { StabilityCause.None }))
            {
                StabilityVerdict verdict = cause == StabilityCause.None ? StabilityVerdict.Stable : cause < StabilityCause.Restless ? StabilityVerdict.Failed : StabilityVerdict.Degraded;
                string line = Row(verdict, cause).ToLine();

                StabilityRow read = StabilityRow.FromLine(line);

                Assert.That(read.ToLine(), Is.EqualTo(line));
                Assert.That((read.Outcome.Verdict, read.Outcome.Cause, read.Clamps, read.Key), Is.EqualTo((verdict, cause, true, Run.Key)));
            }
            Assert.That(StabilityCauses.All.Select(StabilityCauses.Letter).Distinct().Count(), Is.EqualTo(10));
        }

        [Test]
        public void HasTheColumnsThatReadersKnow()
        {
            Assert.That(Row(StabilityVerdict.Failed, StabilityCause.Energy).ToLine(),
                Is.EqualTo("M2,thesis,0.005,1.5,3,failed,\"E, \"\"grew\"\"\",0.25,on,216,40,a device,2026-11-21,energy"));
            Assert.That(CsvText.Join(StabilityRow.Columns), Does.StartWith("map,method,x,y,seed,verdict,reason,time_to_failure_s,clamps,particles,steps,device,date"));
        }

        [Test]
        public void ComparesBordersWithTheory()
        {
            StabilityLimit limit = StabilityLimits.Of(CaseMethod.Find("thesis"), false).First();
            LimitRow Measured(double border)
            {
                Bisection search = limit.Search();
                while (!search.IsDone)
                    search.Add(search.Next <= border);
                return LimitRow.Of(limit, CaseMethod.Find("thesis"), search, "a device", "2026-11-21");
            }

            LimitRow inside = Measured(1.37);
            Assert.That(LimitRow.FromLine(inside.ToLine()).ToLine(), Is.EqualTo(inside.ToLine()));
            Assert.That(inside.IsWithin, Is.True);
            Assert.That(Measured(1.35 * 0.94).IsWithin, Is.False);
            Assert.That(Measured(1.40 * 1.06).IsWithin, Is.False);
            Assert.That(Measured(0.1).IsWithin, Is.False, "never stable");
            Assert.That(Measured(100.0).IsWithin, Is.False, "never unstable");
            Assert.That(LimitRow.FromLine(Measured(100.0).ToLine()).IsWithin, Is.False);
        }

        [Test]
        public void GoesOnWithTheFilesOfTheSameDevice()
        {
            var files = new StabilityFiles(folder, "a device");
            files.Add(Row(StabilityVerdict.Failed, StabilityCause.Energy));
            files.Add(Row(StabilityVerdict.Stable, StabilityCause.None));

            var again = new StabilityFiles(folder, "a device");

            Assert.That(again.Rows.Single().Outcome.Verdict, Is.EqualTo(StabilityVerdict.Stable), "the newer one of a run");
            Assert.That(again.Contains(Run), Is.True);
            Assert.That(() => new StabilityFiles(folder, "another"), Throws.TypeOf<CommandLineException>().With.Message.Contains("'a device'"));
            File.AppendAllText(Path.Combine(folder, "stability.csv"), "M1,broken\n");
            Assert.That(() => new StabilityFiles(folder, "a device"), Throws.TypeOf<CommandLineException>().With.Message.Contains("line 3"));
        }

        static StabilityRun Run => new StabilityRun
        {
            Map = StabilityMaps.All[1], Method = CaseMethod.Find("thesis"), X = 0.005, Y = 1.5, Seed = 3, Clamps = true,
        };

        static StabilityRow Row(StabilityVerdict verdict, StabilityCause cause) => StabilityRow.Of(Run,
            new StabilityOutcome { Verdict = verdict, Cause = cause, Reason = "E, \"grew\"", TimeToFailure = 0.25, Particles = 216, Steps = 40 }, "a device", "2026-11-21");
    }
}
