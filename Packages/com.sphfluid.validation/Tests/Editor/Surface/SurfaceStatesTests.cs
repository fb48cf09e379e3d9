using System;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The states, flags and table of the surface measurement.</summary>
    public sealed class SurfaceStatesTests
    {
        private static readonly SurfaceScale scale = new SurfaceScale();

        [Test]
        public void StatesAreTheSameAtEveryCallAndLieInTheirDomains()
        {
            var quick = new SurfaceScale(true);
            foreach (SurfaceStateEntry states in SurfaceStateEntry.All)
            {
                SurfaceState state = states.Build(quick), again = states.Build(quick);
                if (state.Prepare != null) continue;
                Vector3 half = 0.5f * state.Settings.DomainSize;
                Assert.That(state.Frames.Select(f => f.Length).Distinct().Count(), Is.EqualTo(1), states.Name);
                for (int i = 0; i < state.Frames.Count; i++)
                {
                    Assert.That(state.Frames[i], Is.EqualTo(again.Frames[i]), states.Name);
                    Assert.That(state.Frames[i].All(p => Vector3.Max(-half, Vector3.Min(half, p)) == p), states.Name);
                }
            }
        }

        [Test]
        public void CellsDivideTheDomainsEvenly()
        {
            foreach (SurfaceStateEntry states in SurfaceStateEntry.All)
            {
                SurfaceState state = states.Build(scale);
                foreach (float cell in new[] { 0.5f, 0.75f, 1f })
                {
                    Vector3 cells = state.Settings.DomainSize / (cell * state.Spacing);
                    for (int axis = 0; axis < 3; axis++)
                    {
                        Assert.That(cells[axis], Is.EqualTo(Mathf.Round(cells[axis])).Within(1e-3), $"{states.Name}, cells of {cell} dx");
                    }
                }
            }
        }

        [Test]
        public void PackedParticlesLieAboutASpacingApart()
        {
            Vector3[] places = ParticlePacking.Box(new Vector3Int(10, 8, 10), 5).ToArray();
            double[] nearest = places.Select((p, i) => (double)places.Where((_, j) => j != i).Min(q => (q - p).magnitude)).ToArray();

            Assert.That(places.Length, Is.EqualTo(800));
            Assert.That(nearest.Average(), Is.InRange(0.85, 1.0));
            Assert.That(nearest.Min(), Is.GreaterThan(0.5));
        }

        [Test]
        public void QuickTakesFewerVariants()
        {
            SurfaceArguments all = SurfaceArguments.Parse(new[] { "--", "--state", "drops", "sphere" });
            SurfaceArguments quick = SurfaceArguments.Parse(new[] { "--", "--quick", "--out", "a" });

            Assert.That(all.States.Select(s => s.Name), Is.EqualTo(new[] { "drops", "sphere" }));
            Assert.That(all.Variants.Count, Is.EqualTo(SurfaceVariantEntry.All.Count));
            Assert.That(quick.Variants.Count, Is.InRange(1, SurfaceVariantEntry.All.Count - 1));
            Assert.That((quick.States.Count, quick.OutputFolder), Is.EqualTo((SurfaceStateEntry.All.Count, "a")));
        }

        [TestCase("--state", "sea")]
        [TestCase("--variant", "tetrahedra")]
        [TestCase("--grid", "3")]
        public void WrongFlagsAreNamed(string flag, string value)
        {
            var exception = Assert.Throws<CommandLineException>(() => SurfaceArguments.Parse(new[] { "--", flag, value }));

            Assert.That(exception.Message, Does.Contain(flag));
        }

        [Test]
        public void WritesALineForEachVariant()
        {
            string folder = TestFolder.Fresh();
            try
            {
                var table = new ResultTable<SurfaceQuality>(SurfaceQuality.Format, folder, "a device");
                table.Add(new SurfaceQuality { State = "drops", Variant = "thesis-1", Triangles = 12.5, OpenEdges = 3 });
                table.Add(new SurfaceQuality { State = "drops", Variant = "thesis-0.5" });

                string[] lines = File.ReadAllLines(Path.Combine(folder, "surface-quality.csv"));
                string[] columns = CsvText.Split(lines[0]), cells = CsvText.Split(lines[1]);
                Assert.That((lines.Length, cells.Length), Is.EqualTo((3, columns.Length)));
                Assert.That(cells[Array.IndexOf(columns, "triangles")], Is.EqualTo("12.5"));
                Assert.That(cells[Array.IndexOf(columns, "open_edges")], Is.EqualTo("3"));
                Assert.That(cells[Array.IndexOf(columns, "flicker_dx")], Is.Empty, "it was not measured");
            }
            finally
            {
                TestFolder.Delete(folder);
            }
        }
    }
}
