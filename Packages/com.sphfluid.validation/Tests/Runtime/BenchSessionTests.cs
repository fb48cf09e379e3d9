using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Laboratory;
using SphFluid.Validation;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A whole benchmark of the smallest size: its files, not its times.</summary>
    public sealed class BenchSessionTests
    {
        private readonly List<string> said = new List<string>();
        private string folder;

        [SetUp]
        public void SetUp()
        {
            GpuTest.Require();
            if (!SystemInfo.supportsGpuRecorder)
            {
                Assert.Ignore($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) has no GPU times.");
            }
            said.Clear();
            folder = TestFolder.Fresh();
        }

        [TearDown]
        public void TearDown() => TestFolder.Delete(folder);

        [UnityTest]
        public IEnumerator EveryRowHasItsSamples()
        {
            using (BenchSession session = Create("--particles", "128", "--grids", "8"))
            {
                while (session.Step()) yield return null;
            }
            string[] lines = File.ReadAllLines(Path.Combine(folder, "thesis.csv"));
            string[] head = lines[0].Split(',');
            int rows = MeasuredGeometrySurface.MissingSupport() == null ? 3 : 2;
            Assert.That(lines, Has.Length.EqualTo(1 + rows));
            for (int i = 1; i < lines.Length; i++)
            {
                // The device's name may have commas: count from the end.
                string[] cells = lines[i].Split(',');
                string Cell(string name) => cells[cells.Length - head.Length + Array.IndexOf(head, name)];
                Assert.That(Cell("samples"), Is.EqualTo("5"), lines[i]);
                Assert.That(Cell("particles"), Is.EqualTo("128"), lines[i]);
                Assert.That(int.Parse(Cell("frames")), Is.GreaterThanOrEqualTo(5), lines[i]);
                // 10 sorts and the 8 other blocks, 2 more for a surface.
                Assert.That(Cell("dispatches"), Is.EqualTo(Cell("grid") == "0" ? "18" : "20"), lines[i]);
            }
            Assert.That(said, Has.Some.Contains("about").And.Contains("5 samples of each"));
        }

        [UnityTest]
        public IEnumerator SolversAreMeasuredSizeBySize()
        {
            using (BenchSession session = Create("--table", "solver", "--particles", "128,250"))
            {
                while (session.Step()) yield return null;
            }
            string[][] lines = File.ReadAllLines(Path.Combine(folder, "solver.csv")).Select(CsvText.Split).ToArray();
            string Cell(string[] line, string name) => line[Array.IndexOf(lines[0], name)];
            double Number(string[] line, string name) => double.Parse(Cell(line, name), CultureInfo.InvariantCulture);
            Assert.That(lines, Has.Length.EqualTo(1 + 2 * 14));
            foreach (string[] line in lines.Skip(1))
            {
                string text = string.Join(",", line);
                Assert.That(Cell(line, "samples"), Is.EqualTo("5"), text);
                // 10 sorts, or one where its levels are fused, and the 8 other blocks of the thesis; the Standard method's never depend on
                // the size.
                var dispatches = new Dictionary<string, double> { { "thesis_27_fused", 9 }, { "standard", 5 }, { "standard_search", 5 },
                    { "standard_2.25", 5 }, { "standard_unordered", 4 }, { "standard_mesh", 9 }, { "robust", 12 }, { "robust_2.25", 12 } };
                string config = Cell(line, "config");
                double alone = dispatches.TryGetValue(config.Replace("_at_once", ""), out double own) ? own : 18;
                // A step of Robust sorts or not, by how long its lists serve.
                if (config.EndsWith("_at_once") || config.StartsWith("robust"))
                {
                    Assert.That(Number(line, "dispatches"), Is.InRange(2.0, alone), text);
                }
                else Assert.That(Number(line, "dispatches"), Is.EqualTo(alone), text);
                Assert.That(Number(line, "candidates_per_neighbour"), Is.GreaterThan(1.0), text);
                Assert.That(Number(line, "blocks_over_step"), Is.InRange(0.01, 1.1), text);
                Assert.That(Number(line, "roofline_fraction"), Is.InRange(0.0, 1.0), text);
                Assert.That(Cell(line, "growth_exponent") == "", Is.EqualTo(Cell(line, "particles") == "128"), text);
            }
            IEnumerable<string> compared = lines.Skip(1).Where(l => Cell(l, "kappa") == "2" && Cell(l, "particles") == "250")
                .Select(l => Cell(l, "neighbours_mean"));
            Assert.That(compared.Distinct().Count(), Is.EqualTo(1), "the same k for all");
        }

        [UnityTest]
        public IEnumerator SurfacesAreMeasuredOnTheSameParticles()
        {
            using (BenchSession session = Create("--table", "surface", "--particles", "250", "--grids", "8,16"))
            {
                while (session.Step()) yield return null;
            }
            string[][] lines = File.ReadAllLines(Path.Combine(folder, "surface.csv")).Select(CsvText.Split).ToArray();
            string Cell(string[] line, string name) => line[Array.IndexOf(lines[0], name)];
            double Number(string[] line, string name) => double.Parse(Cell(line, name), CultureInfo.InvariantCulture);
            bool hasGeometry = MeasuredGeometrySurface.MissingSupport() == null;
            Assert.That(lines, Has.Length.EqualTo(1 + (hasGeometry ? 14 : 12)));
            foreach (string[] line in lines.Skip(1))
            {
                string text = string.Join(",", line);
                bool sparse = Cell(line, "surface") == "marching-cubes" || Cell(line, "surface") == "marching-cubes+whitewater";
                Assert.That(Cell(line, "samples"), Is.EqualTo("5"), text);
                Assert.That(Number(line, "blocks_over_frame"), Is.InRange(0.01, 1.1), text);
                Assert.That(Number(line, "neighbours_ms"), Is.GreaterThan(0.0), text);
                Assert.That(Number(line, "triangles"), Is.GreaterThan(50.0), text);
                Assert.That(Cell(line, "blocks_active") != "", Is.EqualTo(sparse), text);
                bool halved = Cell(line, "field") == "thesis" && Cell(line, "grid") == "16";
                Assert.That(Cell(line, "over_half_grid") != "", Is.EqualTo(halved), text);
                Assert.That(Cell(line, "speedup_gs") != "", Is.EqualTo(hasGeometry && Cell(line, "field") == "thesis"), text);
            }
            foreach (IGrouping<string, string[]> rows in lines.Skip(1).Where(l => Cell(l, "field") == "thesis")
                .GroupBy(l => Cell(l, "grid")))
            {
                Assert.That(rows.Select(l => Cell(l, "triangles")).Distinct().Count(), Is.EqualTo(1), "one field, one mesh");
            }
        }

        [UnityTest]
        public IEnumerator StoppedEarlyLeavesAValidFile()
        {
            using (BenchSession session = Create("--particles", "128", "--grids", "none"))
            {
                // A short trial of the device comes first; the file is there when the table begins.
                for (int i = 0; i < 200 && !File.Exists(Path.Combine(folder, "thesis.csv")); i++)
                {
                    Assert.That(session.Step(), Is.True);
                    yield return null;
                }
            }
            string table = Path.Combine(folder, "thesis.csv");
            Assert.That(File.ReadAllLines(table), Has.Length.EqualTo(1));
            Assert.That(said, Has.Some.StartsWith("Stopped early."));

            File.AppendAllText(table, "an older row\n");
            using (BenchSession again = Create("--particles", "128", "--grids", "none"))
                for (int i = 0; i < 200 && File.ReadAllLines(table).Length > 1; i++)
                {
                    Assert.That(again.Step(), Is.True);
                    yield return null;
                }
            Assert.That(File.ReadAllLines(table), Has.Length.EqualTo(1), "what the same measurement wrote is replaced");
        }

        private BenchSession Create(params string[] flags)
        {
            var words = new List<string> { "player", "--", "--no-sweep", "--out", folder };
            words.AddRange(flags);
            return new BenchSession(BenchArguments.Parse(words), TestAssets.Water.Shaders,
                new SessionProgress(said.Add, null))
            { SampleMilliseconds = 2.0, PictureSize = new Vector2Int(64, 36) };
        }
    }
}
