using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Laboratory;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The rows and columns of the table of surfaces, from made-up rows and from small liquids.</summary>
    public sealed class SurfaceTableTests
    {
        private static readonly string[] Parts = { "field", "draw" };

        [Test]
        public void EveryGridHasTheThesisADenseAndASparseSurface()
        {
            BenchPlan plan = BenchPlan.Surface(new[] { 1000 }, new[] { 8, 512 }, null);

            Assert.That(plan.Configs.Select(c => $"{c.Name} {c.Grid} {c.Field}"), Is.EqualTo(new[]
            {
                "gs 8 thesis", "dense 8 thesis", "sparse 8 thesis", "sparse 512 thesis", "sparse_cheap 0 cheap", "sparse_default 0 default",
                "sparse_high 0 high",
                "water_fast 0 default", "water_balanced 0 default", "water_fine 0 default", "water_fine_spray 0 default",
                "sparse_whitewater 0 default",
            }));
            Assert.That(plan.Configs.Any(c => c.HasStep), Is.False);
            Assert.That(plan.LeftOut, Is.Null);
        }

        [Test]
        public void WithoutGeometryShadersTheirRowsAreLeftOut()
        {
            BenchPlan plan = BenchPlan.Surface(new[] { 1000 }, new[] { 8 }, "The device has none.");

            Assert.That(plan.Configs.Select(c => c.Kind), Has.No.Member(BenchSurfaceKind.Geometry));
            Assert.That(plan.LeftOut, Does.StartWith("The device has none. ").And.Contain("left out"));
        }

        [Test]
        public void WhatIsAskedForIsMeasuredOnEveryDevice()
        {
            BenchPlan plan = BenchPlan.Surface(new[] { 262144 }, new[] { 256 }, null);

            Assert.That(plan.ConfigsOf(262144).Select(c => c.Name), Has.Member("gs"));
        }

        [Test]
        public void RowsAreHeldAgainstTheSameGridAndHalfOfIt()
        {
            BenchColumns table = Table((BenchConfig.GeometrySurface(64), 1000, 90.0), (BenchConfig.DenseSurface(64), 1000, 60.0),
                (BenchConfig.SparseSurface(64), 1000, 10.0),
                (BenchConfig.SparseSurface(128), 1000, 45.0), (BenchConfig.SparseSurface(64), 4000, 20.0),
                (BenchConfig.SparseSurface(FluidSurfaceQuality.High), 1000, 5.0));

            Assert.That(table.Column("speedup_gs"), Is.EqualTo(new[] { "1", "1.5", "9", "", "", "" }));
            Assert.That(table.Column("speedup_dense"), Is.EqualTo(new[] { "0.666667", "1", "6", "", "", "" }));
            Assert.That(table.Column("over_half_grid"), Is.EqualTo(new[] { "", "", "", "4.5", "", "" }));
            Assert.That(table.Column("gpu_ms.field"), Is.EqualTo(new[] { "22.5", "15", "2.5", "11.25", "5", "1.25" }));
            Assert.That(table.Column("neighbours_ms"), Is.EqualTo(Enumerable.Repeat("3", 6)));
        }

        [Test]
        public void TrianglesOfTheGeometryShaderAreThoseOfTheDenseSurface()
        {
            BenchColumns table = Table((BenchConfig.GeometrySurface(64), 1000, 90.0), (BenchConfig.DenseSurface(64), 1000, 60.0));
            table.Rows[1].Surface = BenchSurfaceFacts.Dense(64, 5000, 300);

            Assert.That(table.Column("triangles"), Is.EqualTo(new[] { "100", "100" }));
            Assert.That(table.Column("vertices"), Is.EqualTo(new[] { "300", "300" }));
            Assert.That(table.Column("gpu_bytes"), Is.EqualTo(new[] { "1000", "5000" }));
            Assert.That(table.Column("blocks_active"), Is.EqualTo(new[] { "", "" }));
        }

        [Test]
        public void WhitewaterIsMeasuredOnTopOfTheDefaultSurface()
        {
            const int count = 1009;
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            using (var liquid = new BenchLiquid(shaders, BenchSolver.ThesisOctant, count))
            using (var drawing = new BenchDrawing(shaders, new Vector2Int(320, 180)))
            using (var surface = new WhitewaterBenchSurface(shaders, BenchConfig.Whitewater, liquid.Solver))
            {
                while (!surface.HasCapacity)
                {
                    GpuTest.Run(cmd => liquid.Solver.RecordNeighbourSetup(cmd));
                    GpuTest.Run(cmd => surface.RecordTrial(cmd, liquid.Solver));
                    surface.TakeTrial();
                }
                long without = GpuLaboratory.DispatchesRecorded;
                GpuTest.Run(cmd => surface.Record(cmd, liquid.Solver, drawing));
                Assert.That(GpuLaboratory.DispatchesRecorded - without, Is.GreaterThan(9), "the surface's passes and nine of whitewater");
                Assert.That(surface.Facts.GpuBytes, Is.GreaterThan(2 * 48 * count));
            }
        }

        [Test]
        public void TheDenseSurfaceDrawsTheMeshOfTheComputeTwin()
        {
            const int cells = 13;
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            using (var liquid = new BenchLiquid(shaders, BenchSolver.ThesisOctant, 1009))
            using (var drawing = new BenchDrawing(shaders, new Vector2Int(320, 180)))
            using (var surface = new DenseBenchSurface(shaders, cells))
            using (var field = new SurfaceField(shaders, BenchLiquid.SurfaceGrid(cells)))
            using (var twin = new SurfacePolygoniser(shaders))
            {
                Assert.That(surface.HasCapacity, Is.False);
                GpuTest.Run(cmd => surface.RecordTrial(cmd, liquid.Solver));
                surface.TakeTrial();
                Assert.That(surface.HasCapacity, Is.True);
                GpuTest.Run(cmd => surface.Record(cmd, liquid.Solver, drawing));
                GpuTest.Run(cmd => field.Record(cmd, liquid.Solver));

                Assert.That(surface.Facts.Triangles,
                    Is.EqualTo(twin.Polygonise(field, BenchDrawing.IsoValue).TriangleCount).And.GreaterThan(100));
                Assert.That(BenchPicture.Covered(drawing.Target), Is.InRange(0.05, 0.5));
            }
        }

        [Test]
        public void EverySurfaceShowsTheSameLiquid()
        {
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            if (MeasuredGeometrySurface.MissingSupport() != null) Assert.Ignore(MeasuredGeometrySurface.MissingSupport());
            using (var liquid = new BenchLiquid(shaders, BenchSolver.ThesisOctant, 1009))
            using (var drawing = new BenchDrawing(shaders, new Vector2Int(320, 180)))
            {
                Color[][] pictures = Surfaces(shaders, liquid.Solver.Settings, 17)
                    .Select(s => Picture(s, liquid.Solver, drawing)).ToArray();

                foreach (Color[] picture in pictures)
                {
                    Assert.That(Differing(pictures[0], picture), Is.LessThan(0.001), "part of the picture");
                }
            }
        }

        // The picture is the floor seen through the water: blue where it is, and finer qualities bend it elsewhere.
        [Test]
        public void EveryLookOfWaterDrawsTheSameLiquid()
        {
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            using (var liquid = new BenchLiquid(shaders, BenchSolver.ThesisOctant, 1009))
            using (var drawing = new BenchDrawing(shaders, new Vector2Int(320, 180)))
            {
                Color[][] pictures = new[] { FluidWaterQuality.Fast, FluidWaterQuality.Balanced, FluidWaterQuality.Fine }
                    .Select(quality => BenchConfig.WaterSurface(new BenchWaterLook(quality, 0)))
                    .Append(BenchConfig.WaterSurface(new BenchWaterLook(FluidWaterQuality.Fine, 14)))
                    .Select(config => Picture(new WaterBenchSurface(shaders, config, liquid.Solver.Settings), liquid.Solver, drawing))
                    .ToArray();
                foreach (Color[] picture in pictures)
                {
                    double water = picture.Count(colour => colour.b > 0.1f && colour.b > 1.3f * colour.r) / (double)picture.Length;
                    Assert.That(water, Is.InRange(0.05, 0.5), "part of the picture");
                }
                Assert.That(Differing(pictures[0], pictures[2]), Is.InRange(0.005, 0.5), "fine against fast");
                Assert.That(Differing(pictures[2], pictures[3]), Is.LessThan(0.2), "spray");
            }
        }

        private static IEnumerable<IBenchSurface> Surfaces(FluidShaderSet shaders, FluidSolverSettings settings, int cells)
        {
            yield return new GeometryBenchSurface(shaders, cells);
            yield return new DenseBenchSurface(shaders, cells);
            yield return new SparseBenchSurface(shaders, BenchConfig.SparseSurface(cells), settings);
        }

        private static Color[] Picture(IBenchSurface surface, FluidSolver solver, BenchDrawing drawing)
        {
            using (surface)
            {
                while (!surface.HasCapacity)
                {
                    GpuTest.Run(cmd => surface.RecordTrial(cmd, solver));
                    surface.TakeTrial();
                }
                GpuTest.Run(cmd => surface.Record(cmd, solver, drawing));
                return BenchPicture.Pixels(drawing.Target);
            }
        }

        private static double Differing(Color[] a, Color[] b) =>
            a.Where((colour, i) => ((Vector4)(colour - b[i])).magnitude > 0.05f).Count() / (double)a.Length;

        // Two frames a sample; with the passes timed a quarter of each in the first part, half in the second.
        private static BenchColumns Table(params (BenchConfig Config, int Particles, double Milliseconds)[] rows)
        {
            var table = new BenchColumns(new SurfaceLayout(Parts), "device", "2026-11-22");
            foreach ((BenchConfig config, int particles, double milliseconds) in rows)
            {
                var row =
                    new BenchRow(config, particles) { Surface = BenchSurfaceFacts.Dense(config.Quality.HasValue ? 64 : config.Grid, 1000) };
                row.Add(new BenchTimes(2, 2.0 * milliseconds, new[] { 0.0, 0.0 }));
                row.Passes = new BenchTimes(2, 2.0 * milliseconds, new[] { 0.5 * milliseconds, milliseconds });
                row.AddNeighbourSetup(3.0);
                table.Add(row);
            }
            return table;
        }
    }
}
