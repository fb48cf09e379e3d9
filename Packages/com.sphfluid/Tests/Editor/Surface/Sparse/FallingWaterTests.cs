using System;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Water that falls, as two samples have it after 1.5 s: drawn as water, not as spray. FallingWater/*.bytes: what fell in the scenes of
    /// 493deaee and around it, seven numbers of 16 bits a particle: place [dx / 256], velocity [mm/s], and 1 where it was in free fall
    /// for a twentieth of a second.
    /// </summary>
    public sealed class FallingWaterTests
    {
        private const string Folder = "Packages/com.sphfluid/Tests/Editor/Surface/Sparse/FallingWater";
        private static readonly Vector3 Domain = new Vector3(1.5f, 1.5f, 1.5f);

        [TestCase("WaterWheel", 0.014f)]
        [TestCase("Fountain", 0.025f)]
        public void MostOfItLiesWithinTheSurface(string scene, float spacing)
        {
            FluidParticle[] recorded = Read(scene, spacing, out bool[] falls);
            FluidSolverSettings settings = TestSettings.ByRule(Domain, spacing);
            settings.OctantSearch = false;
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings).WithSpray(true);
            SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, field.CellSize);
            using (var rig = new BlockFieldRig(SurfaceTestScene.LoadShaders(), settings, recorded))
            {
                rig.Record(field, grid);
                Assert.AreEqual(0u, rig.Counters()[SurfaceCounters.OpenFaces]);
                FluidParticle[] particles = GpuTest.Read<FluidParticle>(rig.Solver.Particles, recorded.Length);
                Vector2[] spray = GpuTest.Read<Vector2>(rig.Passes.Spray.Spray, recorded.Length); // y: another number's bits
                var blocks = rig.Read();
                int falling = 0, within = 0, leaving = 0;
                for (int i = 0; i < particles.Length; i++)
                {
                    if (!falls[particles[i].Id]) continue;
                    falling++;
                    leaving += spray[i].x == 1f ? 1 : 0;
                    Vector3 place = particles[i].Position - grid.Minimum;
                    place = new Vector3(place.x / grid.CellSize.x, place.y / grid.CellSize.y, place.z / grid.CellSize.z);
                    Vector3Int cell = Vector3Int.FloorToInt(place);
                    bool isSampled = blocks.TryGetValue(Block(cell), out float[] samples);
                    within += isSampled && Value(samples, cell, place - cell) >= field.IsoValue ? 1 : 0;
                }
                TestContext.WriteLine($"{scene}: {falling} fall, {100 * within / falling} % within, {100 * leaving / falling} % spray");
                Assert.That(falling, Is.GreaterThan(250));
                Assert.That(within, Is.GreaterThan(0.6 * falling));
            }
        }

        private static Vector3Int Block(Vector3Int sample) => new Vector3Int((sample.x + 1) / 8, (sample.y + 1) / 8, (sample.z + 1) / 8);

        private static float Value(float[] samples, Vector3Int cell, Vector3 part)
        {
            Vector3Int local = cell + Vector3Int.one - 8 * Block(cell);
            float sum = 0f;
            for (int corner = 0; corner < 8; corner++)
            {
                var at = new Vector3Int(corner & 1, corner >> 1 & 1, corner >> 2);
                float weight = Part(at.x, part.x) * Part(at.y, part.y) * Part(at.z, part.z);
                sum += weight * samples[((local.z + at.z) * 9 + local.y + at.y) * 9 + local.x + at.x];
            }
            return sum;
        }

        private static float Part(int upper, float part) => upper == 1 ? part : 1f - part;

        private static FluidParticle[] Read(string scene, float spacing, out bool[] falls)
        {
            byte[] bytes = File.ReadAllBytes(Path.GetFullPath($"{Folder}/{scene}.bytes"));
            var numbers = new short[bytes.Length / 2];
            Buffer.BlockCopy(bytes, 0, numbers, 0, bytes.Length);
            int count = numbers.Length / 7;
            falls = Enumerable.Range(0, count).Select(i => numbers[7 * i + 6] == 1).ToArray();
            return Enumerable.Range(0, count).Select(i => new FluidParticle(spacing / 256f * At(numbers, 7 * i),
                0.001f * At(numbers, 7 * i + 3), (uint)i)).ToArray();
        }

        private static Vector3 At(short[] numbers, int first) => new Vector3(numbers[first], numbers[first + 1], numbers[first + 2]);
    }
}
