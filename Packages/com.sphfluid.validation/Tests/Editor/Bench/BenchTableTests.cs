using System;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>The benchmark's arithmetic and files; times themselves are no matter of tests.</summary>
    public sealed class BenchTableTests
    {
        [TestCase(new[] { 4.0 }, 4.0, 4.0, 4.0)]
        [TestCase(new[] { 3.0, 1.0, 2.0 }, 2.0, 1.0, 3.0)]
        [TestCase(new[] { 3.0, 1.0, 2.0, 10.0 }, 2.5, 1.0, 10.0)]
        public void MedianLeastAndGreatest(double[] samples, double median, double minimum, double maximum)
        {
            SampleStatistics statistics = SampleStatistics.Of(samples);

            Assert.That(statistics.Median, Is.EqualTo(median));
            Assert.That(statistics.Minimum, Is.EqualTo(minimum));
            Assert.That(statistics.Maximum, Is.EqualTo(maximum));
        }

        [Test]
        public void NoSampleHasNoMedian() => Assert.That(() => SampleStatistics.Of(new double[0]), Throws.ArgumentException);

        [Test]
        public void BlocksAreSharedOutOverTheFrames()
        {
            BenchTimes times = new BenchTimes(2, 10.0, new[] { 3.0, 5.0 }).Plus(new BenchTimes(3, 30.0, new[] { 7.0, 21.0 }));

            Assert.That(times.Frames, Is.EqualTo(5));
            Assert.That(times.Frame, Is.EqualTo(8.0));
            Assert.That(times.Block(0), Is.EqualTo(2.0));
            Assert.That(times.Block(1), Is.EqualTo(5.2));
            Assert.That(times.BlocksOverTotal, Is.EqualTo(36.0 / 40.0));
        }

        [Test]
        public void RowsAreWrittenWithTheContractsColumns()
        {
            BenchColumns table = Table();
            string[] lines = table.Lines().ToArray();

            Assert.That(lines, Has.Length.EqualTo(2), "rows without samples are left out");
            Assert.That(lines[0],
                Is.EqualTo("table,device,config,method,surface,particles,grid,spacing,support,neighbours_mean,dispatches," +
                "gpu_ms_median,gpu_ms_min,gpu_ms_max,pass_stamps,gpu_ms_stamped,steps_per_s,mpsteps_per_s,gpu_ms.First,gpu_ms.Second," +
                "blocks_over_step,samples,frames,date,driver,processor,commit,clock_mhz,published_fps_gtx_580,published_fps_gtx_430,note"));
            Assert.That(lines[1],
                Is.EqualTo("thesis,\"A \"\"fast\"\" one, with 2 cores\",sph_mc,thesis,marching-cubes-gs,16384,64,0.025,0.05,30.5,36," +
                "4,2,8,0,5,250,4.096,1,2,0.6,3,6,2026-11-21,,,,1980,314,277,graphics-limited"));
        }

        [Test]
        public void FilesAreReplacedWhole()
        {
            string folder = TestFolder.Fresh();
            try
            {
                new ThesisLayout("thesis", new[] { "First" }).Format.Write(folder, new BenchRow[0]);
                BenchColumns table = Table();
                table.Format.Write(folder, table.Rows.Take(1));

                Assert.That(File.ReadAllLines(Path.Combine(folder, "thesis.csv")), Has.Length.EqualTo(2));
                Assert.That(Directory.GetFiles(folder), Has.Length.EqualTo(1));
            }
            finally
            {
                TestFolder.Delete(folder);
            }
        }

        // Corners of tables 3 and 4, and one in the middle.
        [TestCase(0, 16384, 920, 835)]
        [TestCase(1, 65536, 860, 755)]
        [TestCase(32, 32768, 524, 463)]
        [TestCase(128, 65536, 49, 44)]
        [TestCase(256, 65536, 7, 4)]
        public void PublishedFigures(int grid, int particles, int system1, int system2)
        {
            BenchConfig config = Config(grid);

            Assert.That(PublishedTables.System1(config, particles), Is.EqualTo(system1));
            Assert.That(PublishedTables.System2(config, particles), Is.EqualTo(system2));
        }

        [TestCase(0, 16383)]
        [TestCase(48, 16384)]
        public void NothingElseWasPublished(int grid, int particles)
        {
            Assert.That(PublishedTables.System1(Config(grid), particles), Is.Null);
            Assert.That(PublishedTables.System2(Config(grid), particles), Is.Null);
        }

        // Every figure of both tables in one number each, added up by hand from the thesis.
        [Test]
        public void PublishedTablesAreWhole()
        {
            int sum1 = 0, sum2 = 0;
            foreach (int grid in new[] { 0, 1, 32, 64, 128, 256 })
            {
                foreach (int particles in new[] { 16384, 32768, 65536 })
                {
                    sum1 += PublishedTables.System1(Config(grid), particles).Value;
                    sum2 += PublishedTables.System2(Config(grid), particles).Value;
                }
            }
            Assert.That(sum1, Is.EqualTo(7941));
            Assert.That(sum2, Is.EqualTo(7044));
        }

        [Test]
        public void ProgressTellsShareTimeAndWhat()
        {
            Assert.That(SessionProgress.Text(0.5, TimeSpan.FromSeconds(125), "row", false), Is.EqualTo(" 50 %  2:05 left  row"));
            Assert.That(SessionProgress.Text(0.0, null, "row", false), Is.EqualTo("  0 %  row"));
            Assert.That(SessionProgress.Text(0.5, TimeSpan.Zero, "row", true), Does.StartWith(new string('█', 12) + new string('░', 12)));
        }

        // 0: SPH only, 1: with particles, else marching cubes on that grid.
        private static BenchConfig Config(int grid) => grid == 0 ? BenchConfig.SphOnly : grid == 1 ? BenchConfig.SphParticles
            : BenchConfig.SphMarchingCubes(grid);

        private static BenchColumns Table()
        {
            var row = new BenchRow(BenchConfig.SphMarchingCubes(64), 16384)
            {
                Spacing = 0.025,
                Support = 0.05,
                NeighboursMean = 30.5,
                Dispatches = 36,
                Note = "graphics-limited",
            };
            row.Add(new BenchTimes(1, 8.0, new[] { 2.0, 4.0 }));
            row.Add(new BenchTimes(4, 16.0, new[] { 4.0, 8.0 }));
            row.Add(new BenchTimes(1, 2.0, new[] { 0.5, 1.0 }));
            row.Passes = new BenchTimes(2, 10.0, new[] { 2.0, 4.0 });
            row.Clock = 1980.0;
            var table = new BenchColumns(new ThesisLayout("thesis", new[] { "First", "Second" }), "A \"fast\" one, with 2 cores",
                "2026-11-21");
            table.Add(row);
            table.Add(new BenchRow(BenchConfig.SphOnly, 16384));
            return table;
        }
    }
}
