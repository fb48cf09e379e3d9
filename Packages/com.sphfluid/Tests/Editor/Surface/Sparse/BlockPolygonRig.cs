using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>
    /// The polygoniser of the sparse surface on samples that are written by hand into every block of a grid.
    /// </summary>
    internal sealed class BlockPolygonRig : IDisposable
    {
        private const float Iso = 0.5f;
        private const int Plenty = 1 << 20;

        private readonly SurfaceGrid grid;
        private readonly SurfaceWalls walls;
        private readonly SurfacePasses passes;

        /// <summary>
        /// Fills the blocks that are active, all by default, from the field's values at grid vertices; the ring around
        /// the grid is empty.
        /// </summary>
        public BlockPolygonRig(FluidShaderSet shaders, SurfaceGrid grid, Func<Vector3Int, float> value,
            Predicate<Vector3Int> isActive = null, SurfaceWalls walls = SurfaceWalls.Closed)
        {
            this.grid = grid;
            this.walls = walls;
            passes = new SurfacePasses(shaders);
            Triangles.Reserve(Plenty, Plenty);
            Blocks = new SurfaceBlocks();
            Vector3Int counts = SurfaceBlocks.CountsOver(grid.Cells);
            Blocks.Reserve(grid.Cells, counts.x * counts.y * counts.z);
            Upload(value, isActive ?? (_ => true));
        }

        public SurfaceBlocks Blocks { get; }

        public SurfaceTriangles Triangles { get; } = new SurfaceTriangles();

        // Without particles: the samples are there.
        private SurfaceInput Input =>
            new SurfaceInput(null, SurfaceFieldSettings.Thesis(default, grid, Iso), grid, walls, Blocks);

        public void RecordCount(CommandBuffer cmd) => passes.RecordCount(cmd, Input);

        public void RecordEmit(CommandBuffer cmd) => passes.RecordTriangles(cmd, Input, Triangles);

        public SurfaceStatus Status() => new SurfaceStatus(GpuTest.Read<uint>(Blocks.Counters, SurfaceCounters.Slots));

        /// <summary>Counts, emits and reads the mesh back.</summary>
        public SurfaceMesh Polygonise()
        {
            GpuTest.Run(cmd =>
            {
                RecordCount(cmd);
                RecordEmit(cmd);
            });
            return Triangles.Read(Blocks, Status());
        }

        public void Dispose()
        {
            passes.Dispose();
            Triangles.Dispose();
            Blocks.Dispose();
        }

        private void Upload(Func<Vector3Int, float> value, Predicate<Vector3Int> isActive)
        {
            Vector3Int counts = Blocks.Counts;
            var table = new uint[Blocks.BlockCount];
            var list = new uint[Blocks.BlockCount];
            var samples = new float[Blocks.BlockCount * SurfaceBlocks.SamplesPerBlock];
            uint slots = 0;
            for (int number = 0; number < table.Length; number++)
            {
                var block = new Vector3Int(number % counts.x, number / counts.x % counts.y,
                    number / (counts.x * counts.y));
                if (!isActive(block)) continue;
                for (int i = 0; i < SurfaceBlocks.SamplesPerBlock; i++)
                {
                    samples[slots * SurfaceBlocks.SamplesPerBlock + i] = Sample(BlockFieldRig.SampleAt(block, i),
                        value);
                }
                list[slots] = (uint)number;
                table[number] = ++slots;
            }
            var counters = new uint[SurfaceCounters.Slots];
            counters[SurfaceCounters.BlocksRequested] = slots;
            counters[SurfaceCounters.BlocksListed] = slots;
            counters[SurfaceCounters.RoundCount] = slots;
            Blocks.Table.SetData(table);
            Blocks.List.SetData(list);
            Blocks.Samples.SetData(samples);
            Blocks.Counters.SetData(counters);
            Blocks.RoundArguments.SetData(new[] { slots, 1u, 1u });
        }

        private float Sample(Vector3Int s, Func<Vector3Int, float> value)
        {
            bool inGrid = s == Vector3Int.Max(Vector3Int.zero, Vector3Int.Min(s, grid.Cells));
            return inGrid ? value(s) : 0f;
        }
    }
}
