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
        public void GridWithTooManyEdgesToNameIsRefusedWithTheCure()
        {
            // 3 x 1127^3 is just below 2^32, 3 x 1128^3 above.
            Assert.AreEqual(1124, new SurfaceGrid(Vector3.zero, Vector3.one, Vector3Int.one * 1124).Cells.x);
            var thrown = Assert.Throws<ArgumentOutOfRangeException>(() => new SurfaceGrid(Vector3.zero, Vector3.one,
                Vector3Int.one * 1125));
            StringAssert.Contains("1125 x 1125 x 1125", thrown.Message);
            thrown = Assert.Throws<ArgumentOutOfRangeException>(() => SurfaceGrid.OverDomain(Vector3.one * 4f, 1e-3f));
            StringAssert.Contains("Choose larger cells or a smaller domain", thrown.Message);
            Assert.AreEqual(40_000, SurfaceGrid.OverDomain(new Vector3(40f, 0.1f, 0.1f), 1e-3f).Cells.x,
                "a long domain is no trouble");
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
