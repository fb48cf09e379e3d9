using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Cells over a box, without a GPU.</summary>
    public sealed class SurfaceGridTests
    {
        [TestCase(0.25f, 4, 2, 2)]
        [TestCase(0.3f, 4, 2, 1)]
        [TestCase(0.1f, 10, 5, 3)]
        [TestCase(5f, 1, 1, 1)]
        public void CellsDivideTheDomainAndAreNoLongerThanAsked(float edge, int x, int y, int z)
        {
            var domain = new Vector3(1f, 0.5f, 0.26f);
            SurfaceGrid grid = SurfaceGrid.OverDomain(domain, edge);
            Assert.AreEqual(new Vector3Int(x, y, z), grid.Cells);
            Assert.AreEqual(-0.5f * domain, grid.Position(0, 0, 0));
            Assert.Less((0.5f * domain - grid.Position(x, y, z)).magnitude, 1e-6f);
        }

        [Test]
        public void VerticesAreNumberedXFirst()
        {
            var grid = new SurfaceGrid(Vector3.zero, Vector3.one, new Vector3Int(2, 3, 4));
            Assert.AreEqual(3 * 4 * 5, grid.VertexCount);
            Assert.AreEqual(4 * 5 * 6, grid.CubeCount);
            int next = 0;
            for (int z = 0; z <= 4; z++)
            {
                for (int y = 0; y <= 3; y++)
                {
                    for (int x = 0; x <= 2; x++) Assert.AreEqual(next++, grid.Index(x, y, z));
                }
            }
        }

        [Test]
        public void GridWithTooManyBlocksIsRefusedWithTheCure()
        {
            // 812^3 blocks of 8 cubes, two of them of the ring, are just below 2^29, 813^3 above.
            Assert.AreEqual(6494, new SurfaceGrid(Vector3.zero, Vector3.one, Vector3Int.one * 6494).Cells.x);
            var thrown = Assert.Throws<ArgumentOutOfRangeException>(() => new SurfaceGrid(Vector3.zero, Vector3.one,
                Vector3Int.one * 6495));
            StringAssert.Contains("6495 x 6495 x 6495", thrown.Message);
            thrown = Assert.Throws<ArgumentOutOfRangeException>(() => SurfaceGrid.OverDomain(Vector3.one * 40f, 1e-3f));
            StringAssert.Contains("Choose larger cells or a smaller domain", thrown.Message);
            Assert.AreEqual(40_000, SurfaceGrid.OverDomain(new Vector3(40f, 0.1f, 0.1f), 1e-3f).Cells.x,
                "a long domain is no trouble");
        }

        // 100 m at the default quality, 0.75 spacings of 0.05 m: a table of 30 MB, and more vertices than an index names.
        [Test]
        public void ALevelHasASurface()
        {
            SurfaceGrid grid = SurfaceGrid.OverDomain(new Vector3(100f, 20f, 100f), 0.0375f);
            Assert.AreEqual(new Vector3Int(2667, 534, 2667), grid.Cells);
            Vector3Int blocks = SurfaceBlocks.CountsOver(grid.Cells);
            Assert.That(4L * blocks.x * blocks.y * blocks.z, Is.LessThan(31_000_000L));
            Assert.Throws<OverflowException>(() => _ = grid.VertexCount);
        }

        [TestCase(0f)]
        [TestCase(-1f)]
        [TestCase(float.NaN)]
        [TestCase(float.PositiveInfinity)]
        public void LengthsArePositive(float length)
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => SurfaceGrid.OverDomain(Vector3.one, length));
            Assert.Throws<ArgumentOutOfRangeException>(() => SurfaceGrid.OverDomain(new Vector3(1f, length, 1f), 0.1f));
            Assert.Throws<ArgumentOutOfRangeException>(() => new SurfaceGrid(Vector3.zero, new Vector3(1f, 1f, length),
                8));
        }

        [TestCase(0, 1, 1)]
        [TestCase(1, -1, 1)]
        public void EveryAxisHasACell(int x, int y, int z) =>
            Assert.Throws<ArgumentOutOfRangeException>(() => new SurfaceGrid(Vector3.zero, Vector3.one,
                new Vector3Int(x, y, z)));
    }
}
