using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class StabilityTableTests : FolderTests
    {
        [Test]
        public void ReadsItsOwnLines()
        {
            foreach (StabilityCause cause in StabilityLegend.Causes.Concat(new[] { StabilityCause.None }))
            {
                StabilityVerdict verdict = cause == StabilityCause.None ? StabilityVerdict.Stable : cause < StabilityCause.Restless
                    ? StabilityVerdict.Failed : StabilityVerdict.Degraded;
                string line = StabilityRow.Format.Line(Row(verdict, cause));

                var read = new StabilityRow();
                StabilityRow.Format.Read(line, read);

                Assert.That(StabilityRow.Format.Line(read), Is.EqualTo(line));
                Assert.That((read.Outcome.Verdict, read.Outcome.Cause, read.Clamps, read.Key), Is.EqualTo((verdict, cause, true, Run.Key)));
            }
            Assert.That(StabilityLegend.Causes.Select(StabilityLegend.Letter).Distinct().Count(), Is.EqualTo(10));
        }

        [Test]
        public void HasTheColumnsThatReadersKnow()
        {
            Assert.That(StabilityRow.Format.Line(Row(StabilityVerdict.Failed, StabilityCause.Energy)),
                Is.EqualTo("M2,thesis,0.005,1.5,3,failed,\"E, \"\"grew\"\"\",0.25,on,216,40,a device,2026-11-21,energy"));
            Assert.That(StabilityRow.Format.FirstLine,
                Does.StartWith("map,method,x,y,seed,verdict,reason,time_to_failure_s,clamps,particles,steps,device,date"));
        }

        [Test]
        public void ComparesBordersWithTheory()
        {
            StabilityLimit limit = StabilityLimit.Of(CaseMethod.Find("thesis"), false).First();
            LimitRow Measured(double border)
            {
                Bisection search = limit.Search();
                while (!search.IsDone) search.Add(search.Next <= border);
                return new LimitRow(limit, CaseMethod.Find("thesis"), search) { Device = "a device", Date = "2026-11-21" };
            }

            LimitRow inside = Measured(1.37);
            Assert.That(LimitRow.Format.Line(Read(inside)), Is.EqualTo(LimitRow.Format.Line(inside)));
            Assert.That(inside.IsWithin, Is.True);
            Assert.That(Measured(1.35 * 0.94).IsWithin, Is.False);
            Assert.That(Measured(1.40 * 1.06).IsWithin, Is.False);
            Assert.That(Measured(0.1).IsWithin, Is.False, "never stable");
            Assert.That(Measured(100.0).IsWithin, Is.False, "never unstable");
            Assert.That(Read(Measured(100.0)).IsWithin, Is.False);
        }

        [Test]
        public void ResumesTheFileOfTheSameDevice()
        {
            ResultTable<StabilityRow> table = Resume("a device");
            table.Add(Row(StabilityVerdict.Failed, StabilityCause.Energy));
            table.Add(Row(StabilityVerdict.Stable, StabilityCause.None));

            ResultTable<StabilityRow> again = Resume("a device");

            Assert.That(again.Rows.Single().Outcome.Verdict, Is.EqualTo(StabilityVerdict.Stable), "the newer one of a run");
            Assert.That(again.Contains(Run.Key), Is.True);
            Assert.That(() => Resume("another"), Throws.TypeOf<CommandLineException>().With.Message.Contains("'a device'"));
            File.AppendAllText(Path.Combine(folder, "stability.csv"), "M1,broken\n");
            Assert.That(() => Resume("a device"), Throws.TypeOf<CommandLineException>().With.Message.Contains("line 3"));
        }

        private ResultTable<StabilityRow> Resume(string device) =>
            ResultTable<StabilityRow>.Resume(StabilityRow.Format, folder, device, () => new StabilityRow());

        private static LimitRow Read(LimitRow written)
        {
            var row = new LimitRow();
            LimitRow.Format.Read(LimitRow.Format.Line(written), row);
            return row;
        }

        private static StabilityRun Run => new StabilityRun
        {
            Map = StabilityMap.All[1], Method = CaseMethod.Find("thesis"), X = 0.005, Y = 1.5, Seed = 3, Clamps = true,
        };

        private static StabilityRow Row(StabilityVerdict verdict, StabilityCause cause) => new StabilityRow(Run,
            new StabilityOutcome
            {
                Verdict = verdict, Cause = cause, Reason = "E, \"grew\"", TimeToFailure = 0.25, Particles = 216,
                Steps = 40
            })
        { Device = "a device", Date = "2026-11-21" };
    }
}
