using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Blocks 6.2.2 to 6.2.6 together: each particle is in the range of its cell, and empty cells have empty ranges.</summary>
    public sealed class NeighbourSetupTests
    {
        private static readonly Vector3 Domain = new Vector3(1.1f, 0.7f, 0.9f);

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(257)]
        [TestCase(1024)]
        [TestCase(5003)]
        public void RangesAgreeWithBruteForce(int count)
        {
            Check(ParticleSets.Random(count, Domain, 1f, count));
        }

        [Test]
        public void CellsOfTheSupportRadiusAgreeWithBruteForce()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.03f);
            settings.OctantSearch = false;
            using (var rig = new ThesisRig(settings, ParticleSets.Random(1024, Domain, 1f, 4)))
            {
                rig.RunNeighbourSetup();
                Assert.That(rig.State.Grid.CellSize, Is.EqualTo(settings.SupportRadius * Vector3.one));
                CheckRanges(rig);
            }
        }

        [Test]
        public void AllParticlesInOneCell()
        {
            Check(ParticleSets.Random(300, 0.01f * Vector3.one, 1f, 3).Select(p => Moved(p, new Vector3(0.05f, 0.02f, 0.03f))).ToArray());
        }

        [Test]
        public void CornersOfTheDomainBelongToTheCornerCells()
        {
            FluidParticle[] corners = Enumerable.Range(0, 8).Select(i => new FluidParticle(
                0.5f * Vector3.Scale(Domain, new Vector3((i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2) * 2 - 1)), Vector3.zero, (uint)i))
                .ToArray();
            Check(corners);
        }

        [Test]
        public void RangesOfEarlierPositionsAreCleared()
        {
            using (var rig = new ThesisRig(TestSettings.ByRule(Domain, 0.03f), ParticleSets.Random(500, Domain, 1f, 5)))
            {
                rig.RunNeighbourSetup();
                rig.State.Published.Particles.SetData(ParticleSets.Random(500, 0.2f * Domain, 1f, 6));
                rig.RunNeighbourSetup();
                CheckRanges(rig);
            }
        }

        private static void Check(FluidParticle[] particles)
        {
            using (var rig = new ThesisRig(TestSettings.ByRule(Domain, 0.03f), particles))
            {
                rig.RunNeighbourSetup();
                CheckRanges(rig);
                FluidParticle[] byId = rig.ReadParticles().OrderBy(p => p.Id).ToArray();
                Assert.That(byId, Is.EqualTo(particles.OrderBy(p => p.Id).ToArray()), "the same particles");
            }
        }

        private static void CheckRanges(ThesisRig rig)
        {
            FluidGrid grid = rig.State.Grid;
            FluidParticle[] sorted = rig.ReadParticles();
            int[] cells = sorted.Select(p => Cell(grid, p.Position)).ToArray();
            uint[] ranges = GpuTest.Read<uint>(rig.State.Published.GridIndices, 2 * grid.CellCount);
            for (int cell = 0; cell < grid.CellCount; cell++)
            {
                int first = System.Array.IndexOf(cells, cell);
                int count = cells.Count(c => c == cell);
                uint start = ranges[2 * cell];
                uint end = ranges[2 * cell + 1];
                Assert.That(end - start, Is.EqualTo((uint)count), $"particles in cell {cell}");
                if (count > 0) Assert.That(start, Is.EqualTo((uint)first), $"first particle of cell {cell}");
            }
        }

        private static int Cell(in FluidGrid grid, Vector3 position)
        {
            Vector3 p = position - grid.Origin;
            p = new Vector3(p.x / grid.CellSize.x, p.y / grid.CellSize.y, p.z / grid.CellSize.z);
            int x = Mathf.Clamp(Mathf.FloorToInt(p.x), 0, grid.Counts.x - 1);
            int y = Mathf.Clamp(Mathf.FloorToInt(p.y), 0, grid.Counts.y - 1);
            int z = Mathf.Clamp(Mathf.FloorToInt(p.z), 0, grid.Counts.z - 1);
            return x + grid.Counts.x * (y + grid.Counts.y * z);
        }

        private static FluidParticle Moved(FluidParticle particle, Vector3 by)
        {
            particle.Position += by;
            return particle;
        }
    }
}
