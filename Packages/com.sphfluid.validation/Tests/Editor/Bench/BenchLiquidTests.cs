using System.Linq;
using NUnit.Framework;
using SphFluid.Laboratory;
using SphFluid.Validation;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>The measured liquid, and the count of its dispatches.</summary>
    public sealed class BenchLiquidTests
    {
        [TestCase(64)]
        [TestCase(4093)]
        [TestCase(16384)]
        [TestCase(65536)]
        public void BlockHasEveryParticleOnceInsideTheDomain(int count)
        {
            FluidParticle[] block = BenchLiquid.Block(count, false, out float spacing, out float height);

            Assert.That(block, Has.Length.EqualTo(count));
            Assert.That(count * spacing * spacing * spacing, Is.EqualTo(0.25f).Within(1e-4f), "a quarter of a cubic metre");
            Assert.That(height, Is.LessThan(BenchLiquid.Edge));
            Assert.That(block.Select(p => p.Position).Distinct().Count(), Is.EqualTo(count));
            float half = 0.5f * BenchLiquid.Edge - 0.49f * spacing;
            Assert.That(block.All(p => Mathf.Abs(p.Position.x) <= half && Mathf.Abs(p.Position.y) <= half &&
                Mathf.Abs(p.Position.z) <= half), Is.True);
            Assert.That(block.Max(p => p.Position.y), Is.EqualTo(height - 0.5f * BenchLiquid.Edge - 0.5f * spacing).Within(1e-4f));
        }

        [Test]
        public void SweepDoublesFromFourThousandToAMillion()
        {
            Assert.That(BenchSession.SweepParticles(),
                Is.EqualTo(new[] { 4096, 8192, 16384, 32768, 65536, 131072, 262144, 524288, 1048576 }));
        }

        [Test]
        public void EverySampleStartsFromOneState()
        {
            using (var liquid = new BenchLiquid(SurfaceTestScene.LoadShaders(), BenchSolver.ThesisOctant, 300))
            {
                while (Settle(liquid))
                {
                }
                liquid.Restore();
                FluidParticle[] first = StepAndRead(liquid, 3);
                StepAndRead(liquid, 5);
                liquid.Restore();
                FluidParticle[] second = StepAndRead(liquid, 3);

                Assert.That(liquid.State.NeighboursMean(liquid.Solver.Settings.SupportRadius), Is.InRange(10.0, 40.0));
                Assert.That(second.Select(p => p.Position), Is.EqualTo(first.Select(p => p.Position)));
            }
        }

        // 300 particles are padded to a block of 1,024 pairs: 10 sorts. 3,000 to 4 blocks: 2 levels of transpose, sort, transpose, sort
        // more.
        [TestCase(300, 10 + 8)]
        [TestCase(3000, 10 + 8 + 8)]
        public void DispatchesOfAStepAreCounted(int count, int expected)
        {
            using (var liquid = new BenchLiquid(SurfaceTestScene.LoadShaders(), BenchSolver.ThesisOctant, count))
            {
                long before = GpuLaboratory.DispatchesRecorded;
                GpuTest.Run(cmd => liquid.Solver.RecordSteps(cmd, 1));

                Assert.That(GpuLaboratory.DispatchesRecorded - before, Is.EqualTo(expected));
            }
        }

        [Test]
        public void BothDrawingsShowTheLiquid()
        {
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            using (var liquid = new BenchLiquid(shaders, BenchSolver.ThesisOctant, 512))
            using (var drawing = new BenchDrawing(shaders, new Vector2Int(320, 180)))
            {
                GpuTest.Run(cmd => liquid.Solver.RecordNeighbourSetup(cmd));
                GpuTest.Run(cmd => drawing.RecordParticles(cmd, liquid.Solver));
                Assert.That(BenchPicture.Covered(drawing.Target), Is.InRange(0.05, 0.5));
                if (MeasuredGeometrySurface.MissingSupport() != null) return;
                using (var surface = new GeometryBenchSurface(shaders, 16))
                    GpuTest.Run(cmd => surface.Record(cmd, liquid.Solver, drawing));
                Assert.That(BenchPicture.Covered(drawing.Target), Is.InRange(0.05, 0.5));
            }
        }

        private static bool Settle(BenchLiquid liquid)
        {
            using (var cmd = new CommandBuffer())
            {
                bool more = liquid.Settle(cmd, 60);
                Graphics.ExecuteCommandBuffer(cmd);
                return more;
            }
        }

        private static FluidParticle[] StepAndRead(BenchLiquid liquid, int steps)
        {
            GpuTest.Run(cmd => liquid.Solver.RecordSteps(cmd, steps));
            return GpuTest.Read<FluidParticle>(liquid.Solver.Particles, liquid.Solver.ParticleCount).OrderBy(p => p.Id).ToArray();
        }
    }
}
