using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>All 256 cases of the tables, without a GPU.</summary>
    public sealed class MarchingCubesTablesTests
    {
        private const int Edges = 12;

        [Test]
        public void CutEdgesAreThoseWhoseCornersLieOnBothSides()
        {
            for (int index = 0; index < MarchingCubesTables.CaseCount; index++)
            {
                for (int edge = 0; edge < Edges; edge++)
                {
                    bool cut = Outside(index, edge, 0) != Outside(index, edge, 1);
                    Assert.AreEqual(cut, (MarchingCubesTables.EdgeTable[index] >> edge & 1) != 0,
                        $"case {index}, edge {edge}");
                }
            }
        }

        [Test]
        public void TrianglesUseExactlyTheCutEdges()
        {
            for (int index = 0; index < MarchingCubesTables.CaseCount; index++)
            {
                int used = Row(index).Aggregate(0, (flags, edge) => flags | 1 << edge);
                Assert.AreEqual(MarchingCubesTables.EdgeTable[index], used, $"case {index}");
            }
        }

        [Test]
        public void RowsHoldWholeTrianglesAndEndInMinusOne()
        {
            for (int index = 0; index < MarchingCubesTables.CaseCount; index++)
            {
                List<int> row = Row(index);
                Assert.AreEqual(0, row.Count % 3, $"case {index}");
                Assert.LessOrEqual(row.Count, 15, $"case {index}");
                for (int slot = row.Count; slot < MarchingCubesTables.RowLength; slot++)
                {
                    Assert.AreEqual(-1, MarchingCubesTables.TriangleTable[index * MarchingCubesTables.RowLength + slot],
                        $"case {index}, slot {slot}");
                }
            }
        }

        // Inside a cube every side of a triangle is met by another triangle in the opposite direction; the sides that
        // are left lie in faces.
        [Test]
        public void OpenSidesOfTrianglesLieInFacesOfTheCube()
        {
            for (int index = 0; index < MarchingCubesTables.CaseCount; index++)
            {
                foreach ((int from, int to) in OpenSides(index))
                {
                    Assert.IsTrue(InCommonFace(from, to), $"case {index}, edges {from} and {to}");
                }
            }
        }

        // The cube next door sees the face's four signs and nothing else: over all cases with these signs the joints
        // must be the same.
        [Test]
        public void FacesAreJoinedByTheirOwnFourSignsAlone()
        {
            for (int axis = 0; axis < 3; axis++)
            {
                var joints = new Dictionary<int, string>();
                for (int index = 0; index < MarchingCubesTables.CaseCount; index++)
                {
                    CompareJoints(joints, index, axis, 0, 1);
                    CompareJoints(joints, index, axis, 1, -1);
                }
            }
        }

        [Test]
        public void TrianglesFaceOutOfTheLiquid()
        {
            for (int corner = 0; corner < 8; corner++)
            {
                int onlyCornerInside = 255 & ~(1 << corner);
                List<int> row = Row(onlyCornerInside);
                Assert.AreEqual(3, row.Count);
                Vector3 normal = Vector3.Cross(Midpoint(row[1]) - Midpoint(row[0]),
                    Midpoint(row[2]) - Midpoint(row[0]));
                Vector3 outwards = Midpoint(row[0]) - SurfaceGrid.CornerOffset(corner);
                Assert.Greater(Vector3.Dot(normal, outwards), 0f, $"corner {corner}");
            }
        }

        [Test]
        public void EdgesRunFromTheLowerCornerAlongOneAxis()
        {
            for (int edge = 0; edge < Edges; edge++)
            {
                Vector3Int along = Corner(edge, 1) - Corner(edge, 0);
                Assert.AreEqual(1, along.x + along.y + along.z, $"edge {edge}");
                Assert.AreEqual(1, along.sqrMagnitude, $"edge {edge}");
            }
        }

        [Test]
        public void PackedTablesLieWhereTheShaderLooks()
        {
            int[] packed = MarchingCubesTables.Pack();
            Assert.AreEqual(256 + 4096 + 24 + 256, packed.Length);
            Assert.AreEqual(MarchingCubesTables.EdgeTable[255 - 1], packed[254]);
            Assert.AreEqual(MarchingCubesTables.TriangleTable[254 * 16], packed[256 + 254 * 16]);
            Assert.AreEqual(MarchingCubesTables.EdgeCorners[23], packed[4352 + 23]);
            for (int index = 0; index < MarchingCubesTables.CaseCount; index++)
            {
                Assert.AreEqual(Row(index).Count, packed[4376 + index], $"case {index}");
            }
        }

        private static void CompareJoints(Dictionary<int, string> joints, int index, int axis, int side, int direction)
        {
            int signs = 0;
            for (int corner = 0; corner < 8; corner++)
            {
                Vector3Int offset = SurfaceGrid.CornerOffset(corner);
                if (offset[axis] == side && (index >> corner & 1) != 0) signs |= 1 << (offset[(axis + 1) % 3] + 2 * offset[(axis + 2) % 3]);
            }
            var found = new List<string>();
            foreach ((int from, int to) in OpenSides(index))
            {
                if (Doubled(from)[axis] != 2 * side || Doubled(to)[axis] != 2 * side) continue;
                found.Add(direction > 0
                    ? Flat(from, axis) + ">" + Flat(to, axis)
                    : Flat(to, axis) + ">" + Flat(from, axis));
            }
            found.Sort(string.CompareOrdinal);
            string all = string.Join(" ", found);
            if (joints.TryGetValue(signs, out string known))
                Assert.AreEqual(known, all, $"case {index}, axis {axis}, side {side}, signs {signs}");
            else
                joints.Add(signs, all);
        }

        private static List<(int from, int to)> OpenSides(int index)
        {
            List<int> row = Row(index);
            var sides = new List<(int from, int to)>();
            for (int i = 0; i < row.Count; i++)
            {
                int next = i % 3 == 2 ? i - 2 : i + 1;
                if (!sides.Remove((row[next], row[i]))) sides.Add((row[i], row[next]));
            }
            return sides;
        }

        private static List<int> Row(int index) =>
            MarchingCubesTables.TriangleTable.Skip(index * MarchingCubesTables.RowLength).Take(MarchingCubesTables.RowLength)
                .TakeWhile(edge => edge >= 0).ToList();

        private static Vector3Int Corner(int edge, int end) =>
            SurfaceGrid.CornerOffset(MarchingCubesTables.EdgeCorners[2 * edge + end]);

        private static Vector3Int Doubled(int edge) => Corner(edge, 0) + Corner(edge, 1);

        private static Vector3 Midpoint(int edge) => (Vector3)Doubled(edge) * 0.5f;

        private static string Flat(int edge, int axis) => $"{Doubled(edge)[(axis + 1) % 3]}{Doubled(edge)[(axis + 2) % 3]}";

        private static bool Outside(int index, int edge, int end) =>
            (index >> MarchingCubesTables.EdgeCorners[2 * edge + end] & 1) != 0;

        private static bool InCommonFace(int a, int b)
        {
            Vector3Int p = Doubled(a);
            Vector3Int q = Doubled(b);
            return p.x == q.x && p.x != 1 || p.y == q.y && p.y != 1 || p.z == q.z && p.z != 1;
        }
    }
}
