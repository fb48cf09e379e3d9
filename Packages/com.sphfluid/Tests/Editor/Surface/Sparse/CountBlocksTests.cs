using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>CountBlocks against a count over the samples on the CPU.</summary>
    public sealed class CountBlocksTests
    {
        private const float Iso = 0.5f;

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp() => shaders = SurfaceTestScene.LoadShaders();

        // 1, 2, 7 and 30 blocks; cells that fill the last block, leave one cube in it, or leave none to spare.
        [TestCase(1, 1, 1)]
        [TestCase(6, 6, 6)]
        [TestCase(7, 6, 5)]
        [TestCase(54, 6, 6)]
        [TestCase(22, 14, 38)]
        [TestCase(23, 13, 37)]
        public void EachBlockHasItsVerticesAndIndices(int x, int y, int z)
        {
            foreach (SurfaceWalls walls in new[] { SurfaceWalls.Closed, SurfaceWalls.Open })
            {
                var grid = new SurfaceGrid(Vector3.zero, Vector3.one, new Vector3Int(x, y, z));
                MarchingCubesReference reference = Noise(grid, walls, 1, out float[] values);
                using (var rig = new BlockPolygonRig(shaders, grid,
                    s => values[grid.Index(s.x, s.y, s.z)], walls: walls))
                {
                    GpuTest.Run(rig.RecordCount);
                    AssertCounted(rig, reference, Blocks(rig).ToArray());
                    Assert.AreEqual(rig.Blocks.BlockCount, rig.Status().Blocks, "no block is listed late");
                    Assert.AreEqual(0, rig.Status().OpenFaces);
                }
            }
        }

        [TestCase(0.0, 1)]
        [TestCase(0.3, 2)]
        [TestCase(0.7, 3)]
        public void BlocksThatTheSurfaceReachesAreListedLate(double share, int seed)
        {
            var grid = new SurfaceGrid(Vector3.zero, Vector3.one, new Vector3Int(30, 29, 31)); // 4 x 4 x 5 blocks
            MarchingCubesReference reference = Noise(grid, SurfaceWalls.Closed, seed, out float[] values);
            var random = new System.Random(seed);
            HashSet<Vector3Int> active = Blocks(SurfaceBlocks.CountsOver(grid.Cells)).Where(_ => random.NextDouble() < share).ToHashSet();
            using (var rig = new BlockPolygonRig(shaders, grid, s => values[grid.Index(s.x, s.y, s.z)],
                active.Contains))
            {
                GpuTest.Run(rig.RecordCount);
                Vector3Int[] slots = Blocks(rig).Where(active.Contains).ToArray();
                AssertCounted(rig, reference, slots);
                Vector3Int[] late = slots.SelectMany(b => CrossedNeighbours(rig.Blocks, reference, b))
                    .Where(b => !active.Contains(b)).Distinct().ToArray();
                Assert.AreEqual(active.Count + late.Length, rig.Status().Blocks);
                uint[] list = GpuTest.Read<uint>(rig.Blocks.List, rig.Status().Blocks);
                CollectionAssert.AreEquivalent(late.Select(b => Number(rig.Blocks, b)), list.Skip(active.Count));
                uint[] table = GpuTest.Read<uint>(rig.Blocks.Table, rig.Blocks.BlockCount);
                for (int slot = 0; slot < list.Length; slot++)
                {
                    Assert.AreEqual(slot + 1, (int)table[list[slot]], $"slot of block {list[slot]}");
                }
            }
        }

        // The late round lists no more: where the surface leaves its blocks for one without a slot, it is open.
        [TestCase(0.3, 4)]
        [TestCase(0.7, 5)]
        public void FacesWithoutANeighbourAreOpenInTheLateRound(double share, int seed)
        {
            var grid = new SurfaceGrid(Vector3.zero, Vector3.one, new Vector3Int(30, 29, 31));
            MarchingCubesReference reference = Noise(grid, SurfaceWalls.Closed, seed, out float[] values);
            var random = new System.Random(seed);
            HashSet<Vector3Int> active = Blocks(SurfaceBlocks.CountsOver(grid.Cells)).Where(_ => random.NextDouble() < share).ToHashSet();
            using (var rig = new BlockPolygonRig(shaders, grid, s => values[grid.Index(s.x, s.y, s.z)],
                active.Contains))
            {
                const uint first = 3u;
                uint[] counters = GpuTest.Read<uint>(rig.Blocks.Counters, SurfaceCounters.Slots);
                counters[SurfaceCounters.RoundFirst] = first;
                counters[SurfaceCounters.RoundCount] -= first;
                rig.Blocks.Counters.SetData(counters);
                rig.Blocks.RoundArguments.SetData(new[] { counters[SurfaceCounters.RoundCount], 1u, 1u });
                GpuTest.Run(rig.RecordCount);
                IEnumerable<Vector3Int> late = Blocks(rig).Where(active.Contains).Skip((int)first);
                int open = late.Sum(b => CrossedNeighbours(rig.Blocks, reference, b).Count(n => !active.Contains(n)));
                Assert.Greater(open, 0);
                Assert.AreEqual(open, rig.Status().OpenFaces);
                Assert.AreEqual(active.Count, rig.Status().Blocks, "nothing is listed");
            }
        }

        // Ranges may come in any order, but follow each other without a gap.
        private static void AssertCounted(BlockPolygonRig rig, MarchingCubesReference reference, Vector3Int[] slots)
        {
            uint[] ranges = GpuTest.Read<uint>(rig.Blocks.Ranges, 4 * slots.Length);
            long vertices = 0, indices = 0;
            for (int slot = 0; slot < slots.Length; slot++)
            {
                Vector3Int origin = 8 * slots[slot] - Vector3Int.one;
                Vector3Int first = Vector3Int.Max(origin, reference.FirstCube);
                Vector3Int end = Vector3Int.Min(origin + 8 * Vector3Int.one, reference.EndCube);
                bool isEmpty = end.x <= first.x || end.y <= first.y || end.z <= first.z;
                Assert.AreEqual(isEmpty ? 0 : reference.CutEdges(first, end), (int)ranges[4 * slot + 1],
                    $"vertices of block {slots[slot]}");
                Assert.AreEqual(isEmpty ? 0 : reference.Corners(first, end), (int)ranges[4 * slot + 3],
                    $"indices of block {slots[slot]}");
                vertices += ranges[4 * slot + 1];
                indices += ranges[4 * slot + 3];
            }
            IEnumerable<int> all = Enumerable.Range(0, slots.Length);
            AssertContiguous(all.Select(slot => (ranges[4 * slot], ranges[4 * slot + 1])));
            AssertContiguous(all.Select(slot => (ranges[4 * slot + 2], ranges[4 * slot + 3])));
            Assert.AreEqual(vertices, rig.Status().Vertices);
            Assert.AreEqual(indices, 3 * rig.Status().Triangles);
        }

        private static void AssertContiguous(IEnumerable<(uint First, uint Count)> ranges)
        {
            uint end = 0;
            foreach ((uint first, uint count) in ranges.Where(range => range.Count > 0).OrderBy(range => range.First))
            {
                Assert.AreEqual(end, first);
                end = first + count;
            }
        }

        // Neighbours across faces that have polygonised samples on both sides of the surface.
        private static IEnumerable<Vector3Int> CrossedNeighbours(SurfaceBlocks blocks, MarchingCubesReference reference,
            Vector3Int block)
        {
            Vector3Int origin = 8 * block - Vector3Int.one;
            Vector3Int first = Vector3Int.Max(origin, reference.FirstCube);
            Vector3Int last = Vector3Int.Min(origin + 8 * Vector3Int.one, reference.EndCube);
            for (int face = 0; face < 6; face++)
            {
                int axis = face / 2, step = face % 2 == 0 ? -1 : 1;
                Vector3Int neighbour = block, low = first, high = last;
                neighbour[axis] += step;
                if (neighbour[axis] < 0 || neighbour[axis] >= blocks.Counts[axis]) continue;
                low[axis] = high[axis] = step < 0 ? origin[axis] : origin[axis] + 8;
                int inside = 0, count = 0;
                foreach (Vector3Int s in MarchingCubesReference.Box(low, high + Vector3Int.one))
                {
                    inside += reference.IsInside(s) ? 1 : 0;
                    count++;
                }
                if (inside > 0 && inside < count) yield return neighbour;
            }
        }

        private static MarchingCubesReference Noise(SurfaceGrid grid, SurfaceWalls walls, int seed, out float[] values)
        {
            var random = new System.Random(seed);
            float[] noise = Enumerable.Range(0, grid.VertexCount).Select(_ => (float)random.NextDouble()).ToArray();
            values = noise;
            return new MarchingCubesReference(grid, s => noise[grid.Index(s.x, s.y, s.z)], Iso, walls);
        }

        private static uint Number(SurfaceBlocks blocks, Vector3Int b) =>
            (uint)((b.z * blocks.Counts.y + b.y) * blocks.Counts.x + b.x);

        private static IEnumerable<Vector3Int> Blocks(BlockPolygonRig rig) => Blocks(rig.Blocks.Counts);

        // In the order of their numbers, which is that of the rig's slots.
        private static IEnumerable<Vector3Int> Blocks(Vector3Int counts) => MarchingCubesReference.Box(Vector3Int.zero, counts);
    }
}
