using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Normals at the rim of the active blocks, whichever these are: of all samples that an active block holds, and of
    /// no other.
    /// </summary>
    public sealed class BlockGradientTests
    {
        private const float Iso = 0.5f;

        private static readonly Vector3Int Cells = new Vector3Int(30, 29, 31); // 4 x 4 x 5 blocks

        private Vector3Int counts;
        private float[] values;
        private HashSet<Vector3Int> active;

        [TestCase(1, 0.5)]
        [TestCase(2, 0.3)]
        [TestCase(3, 0.7)]
        public void VerticesHaveTheNormalOfAllSamplesThatAreKnown(int seed, double share)
        {
            var random = new System.Random(seed);
            counts = SurfaceBlocks.CountsOver(Cells);
            // A cell is 1 m wide and the first vertex at 0: positions are grid coordinates.
            var grid = new SurfaceGrid(Vector3.zero, Cells, Cells);
            values = new float[grid.VertexCount];
            for (int i = 0; i < values.Length; i++) values[i] = (float)random.NextDouble();
            active = new HashSet<Vector3Int>();
            for (int i = 0; i < counts.x * counts.y * counts.z; i++)
                if (random.NextDouble() < share)
                {
                    active.Add(new Vector3Int(i % counts.x, i / counts.x % counts.y, i / (counts.x * counts.y)));
                }
            using (var rig = new BlockPolygonRig(SurfaceTestScene.LoadShaders(), grid, Value, active.Contains))
            {
                uint[] table = GpuTest.Read<uint>(rig.Blocks.Table, rig.Blocks.BlockCount);
                GpuTest.Run(rig.RecordCount);
                // Where the surface leaves a block, the count has listed the next one for a late round, which is not
                // run here.
                rig.Blocks.Table.SetData(table);
                uint[] counters = GpuTest.Read<uint>(rig.Blocks.Counters, SurfaceCounters.Slots);
                counters[SurfaceCounters.BlocksRequested] = (uint)active.Count;
                rig.Blocks.Counters.SetData(counters);
                GpuTest.Run(rig.RecordEmit);
                PackedSurfaceVertex[] vertices = GpuTest.Read<PackedSurfaceVertex>(rig.Triangles.Vertices,
                    (int)rig.Status().Vertices);
                int compared = 0, atTheRim = 0;
                foreach (PackedSurfaceVertex vertex in vertices)
                {
                    if (!TryFindEdge(vertex.Position, out Vector3Int a, out Vector3Int b)) continue;
                    float t = (Iso - Value(a)) / (Value(b) - Value(a));
                    t = Mathf.Clamp(t, 0.01f, 0.99f);
                    Vector3 slope = Vector3.Lerp(Gradient(a, out bool wholeA), Gradient(b, out bool wholeB), t);
                    Assert.Less((vertex.Normal + slope.normalized).magnitude, 2e-3f, $"between {a} and {b}");
                    compared++;
                    atTheRim += wholeA && wholeB ? 0 : 1;
                }
                Assert.Greater(compared, 1000);
                Assert.Greater(atTheRim, 100);
            }
        }

        private float Value(Vector3Int s) => values[(s.z * (Cells.y + 1) + s.y) * (Cells.x + 1) + s.x];

        // The edge of the grid that a vertex is on; false in the ring.
        private static bool TryFindEdge(Vector3 p, out Vector3Int a, out Vector3Int b)
        {
            a = b = Vector3Int.FloorToInt(p + 1e-3f * Vector3.one);
            int axes = 0;
            for (int axis = 0; axis < 3; axis++)
            {
                if (p[axis] < 0.5f || p[axis] > Cells[axis] - 0.5f) return false;
                if (Mathf.Abs(p[axis] - Mathf.Round(p[axis])) < 1e-3f) continue;
                b[axis]++;
                axes++;
            }
            Assert.AreEqual(1, axes, $"{p} is on an edge");
            return true;
        }

        private Vector3 Gradient(Vector3Int s, out bool isWhole)
        {
            Vector3 gradient = default;
            isWhole = true;
            for (int axis = 0; axis < 3; axis++)
            {
                Vector3Int step = Vector3Int.zero;
                step[axis] = 1;
                Vector3Int above = IsKnown(s + step) ? s + step : s, below = IsKnown(s - step) ? s - step : s;
                isWhole &= above != s && below != s;
                gradient[axis] = (Value(above) - Value(below)) / Mathf.Max(above[axis] - below[axis], 1);
            }
            return gradient;
        }

        // Block b holds the samples 8 b - 1 to 8 b + 7 along each axis: 7 is in blocks 0 and 1.
        private bool IsKnown(Vector3Int s)
        {
            if (s != Vector3Int.Max(Vector3Int.zero, Vector3Int.Min(s, Cells))) return false;
            for (int k = 0; k < 8; k++)
            {
                Vector3Int shared = default;
                bool exists = true;
                for (int axis = 0; axis < 3; axis++)
                {
                    int behind = k >> axis & 1;
                    shared[axis] = (s[axis] + 1) / 8 - behind;
                    exists &= behind == 0 || (s[axis] + 1) % 8 == 0;
                }
                if (exists && active.Contains(shared)) return true;
            }
            return false;
        }
    }
}
