using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>PublishCells: the ranges of the cells without their border.</summary>
    public sealed class PublishCellsTests
    {
        [TestCase(3, 3, 3)]
        [TestCase(8, 8, 4)]
        [TestCase(5, 7, 11)]
        public void EachCellHasTheRangeOfItsPlaceWithinTheBorder(int x, int y, int z)
        {
            var grid = new FluidGrid(new Vector3(x, y, z), 1f);
            var cells = new CellRows(grid);
            var starts = Enumerable.Range(0, cells.CellCount + 2).Select(i => 3u * (uint)i).ToArray();
            var untouched = new Vector2Int(-1, -1);
            FluidShaderSet shaders = TestShaders.CreateSet();
            var kernel = shaders.Kernel("PublishParticles", "PublishCells");
            int stride = 2 * sizeof(uint);
            using (var cellStart = new GraphicsBuffer(GraphicsBuffer.Target.Structured, starts.Length, sizeof(uint)))
            using (var ranges = new GraphicsBuffer(GraphicsBuffer.Target.Structured, grid.CellCount + 1, stride))
            {
                cellStart.SetData(starts);
                ranges.SetData(Enumerable.Repeat(untouched, ranges.count).ToArray());
                GpuTest.Run(cmd =>
                {
                    CellBindings.SetCells(cmd, kernel, cells);
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_CellTable"), cellStart);
                    GridNeighbours.SetGrid(cmd, kernel, grid);
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_GridIndicesOut"), ranges);
                    kernel.DispatchThreads(cmd, grid.CellCount);
                });
                Vector2Int[] read = GpuTest.Read<Vector2Int>(ranges, ranges.count);
                for (int i = 0; i < grid.CellCount; i++)
                {
                    var cell = new Vector3Int(i % x, i / x % y, i / (x * y)) + Vector3Int.one;
                    int number = cell.x + (x + 2) * (cell.y + (y + 2) * cell.z);
                    Assert.That(read[i], Is.EqualTo(new Vector2Int(3 * number, 3 * number + 3)), $"cell {cell}");
                }
                Assert.That(read[grid.CellCount], Is.EqualTo(untouched), "threads behind the last cell write nothing");
            }
            Object.DestroyImmediate(shaders);
        }
    }
}
