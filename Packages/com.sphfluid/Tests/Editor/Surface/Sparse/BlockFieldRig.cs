using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>A liquid, its blocks and their samples as read back.</summary>
    internal sealed class BlockFieldRig : IDisposable
    {
        private const int EnoughBlocks = 4096;

        private readonly FluidShaderSet shaders;

        public BlockFieldRig(FluidShaderSet shaders, in FluidSolverSettings settings, FluidParticle[] particles)
        {
            this.shaders = shaders;
            Solver = new FluidSolver(settings, shaders, particles);
            Passes = new SurfacePasses(shaders);
            Blocks = new SurfaceBlocks();
        }

        public FluidSolver Solver { get; }

        public SurfacePasses Passes { get; }

        public SurfaceBlocks Blocks { get; }

        public void Record(in SurfaceFieldSettings settings, SurfaceGrid grid, int capacity = EnoughBlocks,
            bool wallsClosed = true)
        {
            Blocks.Reserve(grid.Cells, Math.Min(capacity, Volume(SurfaceBlocks.CountsOver(grid.Cells))));
            SurfaceInput input = Input(settings, grid, wallsClosed);
            GpuTest.Run(cmd => Passes.RecordField(cmd, input));
        }

        /// <summary>Samples every block of the grid, whatever the particles marked.</summary>
        public void RecordAll(in SurfaceFieldSettings settings, SurfaceGrid grid)
        {
            int all = Volume(SurfaceBlocks.CountsOver(grid.Cells));
            Blocks.Reserve(grid.Cells, all);
            Record(settings, grid, all);
            var marks = new uint[all];
            Array.Fill(marks, uint.MaxValue);
            Blocks.Table.SetData(marks);
            Blocks.Counters.SetData(new uint[SurfaceCounters.Slots]);
            SurfaceInput input = Input(settings, grid, true);
            GpuTest.Run(cmd =>
            {
                new ListSurfaceBlocksPass(shaders).Record(cmd, Blocks);
                Passes.RecordSamples(cmd, input);
            });
        }

        public uint[] Counters() => GpuTest.Read<uint>(Blocks.Counters, SurfaceCounters.Slots);

        /// <summary>Samples of each listed block by the block's place.</summary>
        public Dictionary<Vector3Int, float[]> Read()
        {
            var counters = Counters();
            int count = (int)(counters[SurfaceCounters.RoundFirst] + counters[SurfaceCounters.RoundCount]);
            uint[] list = GpuTest.Read<uint>(Blocks.List, count);
            float[] samples = GpuTest.Read<float>(Blocks.Samples, count * SurfaceBlocks.SamplesPerBlock);
            var read = new Dictionary<Vector3Int, float[]>();
            for (int slot = 0; slot < count; slot++)
            {
                var values = new float[SurfaceBlocks.SamplesPerBlock];
                Array.Copy(samples, slot * values.Length, values, 0, values.Length);
                read.Add(BlockAt((int)list[slot]), values);
            }
            return read;
        }

        public Vector3Int BlockAt(int number) =>
            new Vector3Int(number % Blocks.Counts.x, number / Blocks.Counts.x % Blocks.Counts.y,
                number / (Blocks.Counts.x * Blocks.Counts.y));

        /// <summary>The grid vertex of a block's sample, by its index in the block.</summary>
        public static Vector3Int SampleAt(Vector3Int block, int index) =>
            block * SurfaceBlocks.CubesPerSide - Vector3Int.one + new Vector3Int(index % 9, index / 9 % 9, index / 81);

        /// <summary>
        /// Whether a cube of the block, those of the ring included, has corners on both sides of the surface.
        /// </summary>
        public static bool IsCrossed(Vector3Int block, float[] samples, float iso, Vector3Int cells)
        {
            for (int cube = 0; cube < 512; cube++)
            {
                var local = new Vector3Int(cube % 8, cube / 8 % 8, cube / 64);
                Vector3Int origin = block * 8 - Vector3Int.one + local;
                if (origin.x > cells.x || origin.y > cells.y || origin.z > cells.z) continue;
                int inside = 0;
                for (int corner = 0; corner < 8; corner++)
                {
                    Vector3Int at = local + new Vector3Int(corner & 1, corner >> 1 & 1, corner >> 2);
                    inside += samples[(at.z * 9 + at.y) * 9 + at.x] >= iso ? 1 : 0;
                }
                if (inside > 0 && inside < 8) return true;
            }
            return false;
        }

        public void Dispose()
        {
            Solver.Dispose();
            Passes.Dispose();
            Blocks.Dispose();
        }

        private SurfaceInput Input(in SurfaceFieldSettings settings, SurfaceGrid grid, bool wallsClosed) =>
            new SurfaceInput(Solver, settings, grid, wallsClosed ? SurfaceWalls.Closed : SurfaceWalls.Open, Blocks);

        private static int Volume(Vector3Int counts) => counts.x * counts.y * counts.z;
    }
}
