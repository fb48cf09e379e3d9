using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Block 6.2.2 on particles whose cells are known.</summary>
    public sealed class CalculateParticleCellValueTests
    {
        private static readonly Vector3 Domain = new Vector3(1.1f, 0.7f, 0.9f);

        [Test]
        public void EachParticleIsPairedWithItsCellAndTheRestSortsBehind(
            [Values(0, 1, 255, 256, 257, 1009, 1025)] int count, [Values] bool octant)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.03f);
            settings.OctantSearch = octant;
            FluidGrid grid = FluidGrid.For(settings);
            var random = new System.Random(count);
            var particles = new FluidParticle[count];
            var expected = new uint[count];
            for (int i = 0; i < count; i++)
            {
                var cell = new Vector3Int(
                    random.Next(grid.Counts.x), random.Next(grid.Counts.y), random.Next(grid.Counts.z));
                Vector3 part = 0.5f * Vector3.one + 0.98f * ParticleSets.RandomVector(random);
                Vector3 position = grid.Origin + Vector3.Scale(cell + part, grid.CellSize);
                particles[i] = new FluidParticle(position, Vector3.zero, (uint)(7 * i));
                expected[i] = Number(grid, cell);
            }

            AssertPairs(settings, particles, expected);
        }

        // The domain is a whole number of cells: on its upper faces, and beyond, a particle belongs to the last cell.
        [Test]
        public void OnAndBeyondAFaceParticlesBelongToTheCellsThere([Values(1f, 1.01f, 30f)] float beyond)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.03f);
            settings.DomainSize = 2f * settings.SupportRadius * new Vector3(4f, 3f, 5f);
            FluidGrid grid = FluidGrid.For(settings);
            Assert.That(grid.Counts, Is.EqualTo(new Vector3Int(4, 3, 5)));
            var particles = new FluidParticle[8];
            var expected = new uint[8];
            for (uint i = 0; i < 8; i++)
            {
                var high = new Vector3Int((int)i & 1, (int)i >> 1 & 1, (int)i >> 2);
                Vector3 side = 2 * high - Vector3Int.one;
                Vector3 corner = 0.5f * Vector3.Scale(side, settings.DomainSize);
                particles[i] = new FluidParticle(beyond * corner, Vector3.zero, i);
                expected[i] = Number(grid, Vector3Int.Scale(high, grid.Counts - Vector3Int.one));
            }

            AssertPairs(settings, particles, expected);
        }

        private static void AssertPairs(in FluidSolverSettings settings, FluidParticle[] particles, uint[] cells)
        {
            using (var rig = new ThesisRig(settings, particles))
            {
                int padded = rig.State.Buffers.PaddedCount;
                rig.State.Buffers.Grid.SetData(Enumerable.Repeat(12345u, 2 * padded).ToArray());
                var pass = new CalculateParticleCellValuePass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));
                uint[] pairs = GpuTest.Read<uint>(rig.State.Buffers.Grid, 2 * padded);
                for (int i = 0; i < padded; i++)
                {
                    uint cell = i < cells.Length ? cells[i] : uint.MaxValue;
                    if (pairs[2 * i] != cell || pairs[2 * i + 1] != i)
                    {
                        Assert.Fail($"pair {i} is ({pairs[2 * i]}, {pairs[2 * i + 1]}), not ({cell}, {i})");
                    }
                }
            }
        }

        private static uint Number(in FluidGrid grid, Vector3Int cell) =>
            (uint)(cell.x + grid.Counts.x * (cell.y + grid.Counts.y * cell.z));
    }
}
