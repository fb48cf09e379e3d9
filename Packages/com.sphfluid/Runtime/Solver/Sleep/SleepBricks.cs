using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Bricks of cells whose particles sleep together, Shaders/Solver/Sleep/SleepParticles.compute.</summary>
    internal sealed class SleepBricks : BufferSet
    {
        /// <summary>BRICK_WORDS.</summary>
        public const int Words = 8;

        private const int LeastSide = 4;
        private const long MostBricks = 1 << 18;

        public SleepBricks(in CellRows cells)
        {
            Side = LeastSide;
            while (CountOf(cells, Side, out Vector3Int counts) > MostBricks) Side++;
            Total = (int)CountOf(cells, Side, out Vector3Int fitting);
            Counts = fitting;
            Bricks = Add("Bricks", (long)Total * Words, sizeof(uint));
            AwakeBoxes = Add("AwakeBoxes", 2 * MostBoxes, 4 * sizeof(float));
        }

        public const int MostBoxes = 64;
        public readonly FluidBuffer Bricks;
        public readonly FluidBuffer AwakeBoxes;
        public int Side { get; }
        public Vector3Int Counts { get; }
        public int Total { get; }

        public SleepRule Rule { get; set; }
        public float SinceSort { get; set; }
        public bool IsNew { get; set; } = true;
        public int BoxCount { get; private set; }

        public void SetBoxes(IReadOnlyList<Bounds> boxes)
        {
            var corners = new Vector4[2 * MostBoxes];
            BoxCount = boxes.Count;
            for (int i = 0; i < BoxCount; i++)
            {
                corners[2 * i] = boxes[i].min;
                corners[2 * i + 1] = boxes[i].max;
            }
            AwakeBoxes.SetData(corners);
        }

        private static long CountOf(in CellRows cells, int side, out Vector3Int counts)
        {
            Vector3Int inner = cells.Counts - 2 * Vector3Int.one;
            counts = new Vector3Int((inner.x + side - 1) / side, (inner.y + side - 1) / side, (inner.z + side - 1) / side);
            return (long)counts.x * counts.y * counts.z;
        }
    }
}
