using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Bricks of cells whose particles fall asleep and wake together, and what keeps them awake
    /// (Shaders/Solver/Cells/Sleep/SleepParticles.compute).
    /// </summary>
    internal sealed class SleepBricks : BufferSet
    {
        /// <summary>BRICK_WORDS, BRICK_STATE, BRICK_ASLEEP and BRICK_SOFTNESS in SleepParticles.compute.</summary>
        public const int Words = 11, State = 6, Asleep = 2, Softness = 10;

        /// <summary>Boxes that keep bricks awake; what there is more is in the last.</summary>
        public const int MostBoxes = 64;

        // Cells of a brick's side: less than four are a few layers, whose means tremble. In large domains bricks are larger.
        private const int LeastSide = 4;
        private const long MostBricks = 1 << 18;

        /// <summary>For each brick <see cref="Words"/>.</summary>
        public readonly FluidBuffer Bricks;

        /// <summary>Lower and upper corner of each box [m]; the first w is their number.</summary>
        public readonly FluidBuffer AwakeBoxes;

        /// <summary>Which groups of particles sleep as a whole.</summary>
        public readonly AwakeGroups Groups;

        private readonly Vector4[] corners = new Vector4[2 * MostBoxes];

        /// <param name="cells">The cells, with a border that no brick has.</param>
        /// <param name="isPlanned">Whether only its size is asked for.</param>
        public SleepBricks(in CellRows cells, bool isPlanned = false) : base(isPlanned)
        {
            Vector3Int inner = cells.Counts - 2 * Vector3Int.one;
            Side = LeastSide;
            while (CountOf(inner, Side) > MostBricks) Side++;
            Counts = new Vector3Int(Parts(inner.x, Side), Parts(inner.y, Side), Parts(inner.z, Side));
            Total = Counts.x * Counts.y * Counts.z;
            Bricks = Add("SleepBricks", (long)Total * Words, sizeof(uint));
            AwakeBoxes = Add("AwakeBoxes", 2 * MostBoxes, 4 * sizeof(float));
            AwakeBoxes.SetData(corners);
            Groups = new AwakeGroups(Add("SleepArguments", AwakeGroups.ArgumentWords, sizeof(uint), Arguments));
        }

        /// <summary>Cells of a brick's side.</summary>
        public int Side { get; }

        /// <summary>Bricks along each axis.</summary>
        public Vector3Int Counts { get; }

        /// <summary>Those, and the side.</summary>
        public int[] Shape => new[] { Counts.x, Counts.y, Counts.z, Side };

        /// <summary>Bricks in all.</summary>
        public int Total { get; }

        /// <summary>When they sleep.</summary>
        public SleepRule Rule { get; set; }

        /// <summary>Time that the steps since the last sort took [s].</summary>
        public float SinceSort { get; set; }

        /// <summary>Whether all are to wake with the next pass.</summary>
        public bool AllWake { get; private set; } = true;

        /// <summary>Whether those or the ones that are kept awake are.</summary>
        public bool WakesNow { get; private set; } = true;

        /// <summary>The square of the speed of sound at the last sort [m²/s²].</summary>
        public float Stiffness { get; private set; }

        /// <summary>Whether some may be softer or stiffer than the rest.</summary>
        public bool IsSoft { get; private set; }

        /// <summary>Takes over the square of the speed of sound.</summary>
        /// <returns>What it was over what it is.</returns>
        public float TakeStiffness(float now)
        {
            float ratio = Stiffness > 0f ? Stiffness / now : 1f;
            (Stiffness, IsSoft) = (now, IsSoft || ratio != 1f);
            return ratio;
        }

        /// <summary>Bricks wake with the next pass.</summary>
        /// <param name="all">All, or those that are kept awake.</param>
        public void Wake(bool all)
        {
            (AllWake, WakesNow) = (AllWake || all, true);
            if (all) SinceSort = 0f;
        }

        /// <summary>They have.</summary>
        public void Woke() => AllWake = WakesNow = false;

        /// <summary>Takes over where liquid is kept awake.</summary>
        /// <param name="boxes">In simulation space [m].</param>
        public void SetBoxes(IReadOnlyList<Bounds> boxes)
        {
            if (boxes.Count == 0 && corners[0].w == 0f) return;
            for (int i = 0; i < boxes.Count; i++)
            {
                int place = 2 * Math.Min(i, MostBoxes - 1);
                bool joins = i >= MostBoxes;
                corners[place] = joins ? Vector4.Min(corners[place], boxes[i].min) : (Vector4)boxes[i].min;
                corners[place + 1] = joins ? Vector4.Max(corners[place + 1], boxes[i].max) : (Vector4)boxes[i].max;
            }
            corners[0].w = Math.Min(boxes.Count, MostBoxes);
            AwakeBoxes.SetData(corners);
        }

        /// <summary>The bricks that sleep, in simulation space [m]; waits for the GPU.</summary>
        /// <param name="cells">The cells.</param>
        public List<Bounds> ReadAsleep(in CellRows cells)
        {
            var words = new uint[Total * Words];
            Bricks.GetData(words);
            var asleep = new List<Bounds>();
            Vector3 size = Side * cells.CellSize, first = cells.Origin + cells.CellSize + 0.5f * size;
            for (int i = 0; i < Total; i++)
            {
                if (words[i * Words + State] != Asleep) continue;
                var place = new Vector3(i % Counts.x, i / Counts.x % Counts.y, i / (Counts.x * Counts.y));
                asleep.Add(new Bounds(first + Vector3.Scale(place, size), size));
            }
            return asleep;
        }

        private static int Parts(int cells, int side) => (cells + side - 1) / side;

        private static long CountOf(Vector3Int cells, int side) =>
            (long)Parts(cells.x, side) * Parts(cells.y, side) * Parts(cells.z, side);
    }
}
