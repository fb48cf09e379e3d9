using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Buffers of a method with a counting sort that a test fills by itself, to run one pass on them.</summary>
    internal abstract class CellStateRig<TState> : IDisposable where TState : CellState
    {
        protected CellStateRig(TState state)
        {
            Shaders = TestShaders.CreateSet();
            State = state;
            State.RequireList();
        }

        public FluidShaderSet Shaders { get; }

        public TState State { get; }

        /// <summary>Settings by rule for water of a depth of 0.3 m, κ = 2.25.</summary>
        public static FluidSolverSettings Water(Vector3 domain, float spacing, FluidAxes periodic = FluidAxes.None)
        {
            FluidSolverSettings settings = BodyRig.Water(domain, spacing, 0.3f);
            settings.Boundaries.Periodic = periodic;
            return settings;
        }

        /// <summary>Settings whose cells have those counts along the axes, the border included.</summary>
        public static FluidSolverSettings WithCells(Vector3Int counts)
        {
            FluidSolverSettings settings = Water(Vector3.one, 0.05f);
            settings.DomainSize = settings.SupportRadius * ((Vector3)counts - 2.5f * Vector3.one);
            Assert.That(new CellRows(FluidGrid.For(settings)).Counts, Is.EqualTo(counts));
            return settings;
        }

        /// <summary>A random place in a cell, a hundredth of its side or more from its faces.</summary>
        public static Vector3 Within(in CellRows cells, Vector3Int cell, System.Random random)
        {
            Vector3 part = 0.5f * Vector3.one + 0.98f * ParticleSets.RandomVector(random);
            return cells.Origin + Vector3.Scale(cell + part, cells.CellSize);
        }

        /// <summary>A random cell that is not of the border.</summary>
        public static Vector3Int RandomCell(in CellRows cells, System.Random random) => new Vector3Int(
            1 + random.Next(cells.Counts.x - 2),
            1 + random.Next(cells.Counts.y - 2),
            1 + random.Next(cells.Counts.z - 2));

        /// <summary>Number of a cell: x first, then y, then z.</summary>
        public static int Number(in CellRows cells, Vector3Int cell) =>
            cell.x + cells.Counts.x * (cell.y + cells.Counts.y * cell.z);

        /// <summary>Number of the cell of a position, in double precision.</summary>
        public static int CellOf(in CellRows cells, Vector3 position)
        {
            var cell = new Vector3Int();
            for (int axis = 0; axis < 3; axis++)
            {
                double at = ((double)position[axis] - cells.Origin[axis]) / cells.CellSize[axis];
                cell[axis] = (int)Math.Max(1.0, Math.Min(cells.Counts[axis] - 2, Math.Floor(at)));
            }

            return Number(cells, cell);
        }

        /// <summary>
        /// Fills positions, velocities and the first particle of each cell as a sort leaves them, those that left the
        /// domain last, and the cells' counts with zero.
        /// </summary>
        /// <returns>The particles in that order.</returns>
        public FluidParticle[] FillSorted(FluidParticle[] particles)
        {
            CellRows cells = State.Cells;
            int removed = cells.CellCount;
            int Cell(FluidParticle p) => p.IsRemoved ? removed : CellOf(cells, p.Position);
            FluidParticle[] sorted = particles.OrderBy(Cell).ToArray();
            var starts = new uint[removed + 2];
            foreach (FluidParticle p in sorted) starts[Cell(p) + 1]++;
            for (int i = 1; i < starts.Length; i++) starts[i] += starts[i - 1];
            if (State.Sparse.AreUsed)
            {
                Fill(State.Buffers.NewPositions, sorted.Select(p => WithW(p.Position, p.IsRemoved ? -1f : 0f)).ToArray());
                var rank = new RankCellsPass(Shaders);
                GpuTest.Run(cmd =>
                {
                    rank.RecordLoad(cmd, State);
                    rank.Record(cmd, State);
                });
            }
            else
            {
                State.Buffers.CellTable.SetData(starts);
                EmptyCells(State);
            }
            Fill(State.Buffers.Positions, sorted.Select(p => WithW(p.Position, 0f)).ToArray());
            Fill(State.Buffers.PositionTerms, sorted.Select(p => WithW(p.Position, 0f)).ToArray());
            Fill(State.Buffers.Velocities, sorted.Select(p => WithW(p.VelT0, FromBits(p.Id))).ToArray());
            return sorted;
        }

        /// <summary>
        /// Asserts that some particles are counted once each in the cell of their place, or after the last cell where w is
        /// not 0, with ranks of their own. Rounding may put a particle on a face of its cell into the next.
        /// </summary>
        /// <param name="state">The buffers.</param>
        /// <param name="positions">Places, w: below zero of those that left the domain.</param>
        /// <param name="counted">Indices of the particles that must be counted.</param>
        public static void AssertCounted(CellState state, Vector4[] positions, int[] counted)
        {
            CellRows cells = state.Cells;
            uint[] counts = state.Buffers.CellCount.Read<uint>(cells.CellCount + 1);
            uint[] ranks = state.Buffers.Rank.Read<uint>(state.ParticleCount);
            int[] sure = counted.Where(i => positions[i].w < 0f || !IsOnAFace(cells, positions[i])).ToArray();
            int unsure = counted.Length - sure.Length;
            Assert.That(unsure, Is.LessThan(1 + counted.Length / 50), "particles on faces of cells");
            Assert.That(counts.Sum(c => (long)c), Is.EqualTo(counted.Length), "all are counted once");
            AssertSums(state, counts);
            foreach (IGrouping<int, int> cell in sure.GroupBy(i =>
                positions[i].w < 0f ? cells.CellCount : CellOf(cells, positions[i])))
            {
                int count = (int)counts[cell.Key];
                Assert.That(count, Is.InRange(cell.Count(), cell.Count() + unsure), $"particles of cell {cell.Key}");
                if (cell.Key == cells.CellCount) continue;
                uint[] own = cell.Select(i => ranks[i]).ToArray();
                Assert.That(own, Is.Unique.And.All.LessThan(count), $"ranks in cell {cell.Key}");
            }
        }

        /// <summary>
        /// Asserts that behind the counts of the cells, and of what left, are their sums over 2,048 cells each, in 16 parts.
        /// </summary>
        public static void AssertSums(CellState state, uint[] counts)
        {
            uint[] parts = state.Buffers.CellCount.Read<uint>(Counted(state)).Skip(counts.Length).ToArray();
            Assert.That(parts.Length, Is.EqualTo(16 * ((counts.Length + 2047) / 2048)));
            for (int i = 0; i < parts.Length; i += 16)
            {
                long sum = counts.Skip(128 * i).Take(2048).Sum(c => (long)c);
                Assert.That(parts.Skip(i).Take(16).Sum(part => (long)part), Is.EqualTo(sum), $"sum from cell {128 * i} on");
            }
        }

        /// <summary>Empties the counts of the cells and their sums, as a sort does.</summary>
        public static void EmptyCells(CellState state) =>
            state.Buffers.CellCount.SetData(new uint[Counted(state)]);

        /// <summary>Numbers that a count of the particles fills: of the cells, and their sums.</summary>
        public static int Counted(CellState state) => state.Buffers.CellTotal + state.Buffers.SumCount;

        /// <summary>Gives the particles densities and p/ρ².</summary>
        public void SetTerms(Vector2[] terms)
        {
            int count = State.ParticleCount;
            Vector4[] places = GpuTest.Read<Vector4>(State.Buffers.PositionTerms, count);
            State.List.Densities.SetData(terms.Select(t => t.x).ToArray());
            State.Buffers.PositionTerms.SetData(places.Zip(terms, (p, t) => WithW(p, t.y)).ToArray());
        }

        /// <summary>
        /// Lists neighbours: those within R, or nobody, where each has more neighbours than the list holds, and searches.
        /// </summary>
        public void FillList(FluidParticle[] particles, bool listed)
        {
            FluidSolverSettings settings = State.Settings;
            int count = particles.Length, length = State.List.Length;
            var lists = new List<int>[count];
            for (int i = 0; i < count; i++)
            {
                lists[i] = new List<int>();
                for (int j = 0; j < count && listed; j++)
                {
                    double r = ThesisReference.Separation(particles[i], particles[j], settings.PeriodLength).Length;
                    if (j != i && r < 1.000001 * settings.SupportRadius) lists[i].Add(j);
                }
            }

            uint Count(List<int> list) => listed && list.Count <= length ? (uint)list.Count : (uint)length + 1u;
            State.List.Counts.SetData(lists.Select(Count).ToArray());
            State.List.Neighbours.SetData(ListColumns.Write(lists, length));
        }

        /// <summary>Densities and p/ρ² of the particles.</summary>
        public Vector2[] Terms()
        {
            int count = State.ParticleCount;
            return State.List.Densities.Read<float>(count)
                .Zip(GpuTest.Read<Vector4>(State.Buffers.PositionTerms, count), (density, place) => new Vector2(density, place.w))
                .ToArray();
        }

        /// <summary>Empties the list of contacts, as the density pass does before each step.</summary>
        public static void EmptyContacts(CellState state) => state.Walls.Contacts.SetData(new[] { 0u, 1u, 1u, 0u });

        /// <summary>The counters on the GPU.</summary>
        public uint[] Counters() => GpuTest.Read<uint>(State.Published.Counters, CounterReadback.Slots);

        /// <summary>Fills the first elements of a buffer; none of a liquid without particles.</summary>
        public static void Fill<T>(GraphicsBuffer buffer, T[] data) where T : struct
        {
            if (data.Length > 0) buffer.SetData(data);
        }

        /// <summary>A vector and a fourth number.</summary>
        public static Vector4 WithW(Vector3 v, float w) => new Vector4(v.x, v.y, v.z, w);

        /// <summary>The number of some bits: an id in a velocity's w.</summary>
        public static float FromBits(uint bits) => BitConverter.Int32BitsToSingle(unchecked((int)bits));

        /// <summary>The bits of a number.</summary>
        public static uint ToBits(float value) => unchecked((uint)BitConverter.SingleToInt32Bits(value));

        public void Dispose()
        {
            State.Dispose();
            UnityEngine.Object.DestroyImmediate(Shaders);
        }

        private static bool IsOnAFace(in CellRows cells, Vector3 position)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                double at = ((double)position[axis] - cells.Origin[axis]) / cells.CellSize[axis];
                if (Math.Abs(at - Math.Round(at)) < 1e-4) return true;
            }

            return false;
        }
    }
}
