using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>ScatterParticles on ranks that the test makes: particles of a cell by their ranks, or ids.</summary>
    public sealed class ScatterParticlesTests
    {
        private const float ListTime = 0.05f; // s

        [Test]
        public void ParticlesOfACellFollowEachOther(
            [Values(0, 1, 255, 256, 257, 1009)] int count, [Values] bool stable, [Values(1, 5)] int cellsAlong)
        {
            var counts = new Vector3Int(2 + cellsAlong, 2 + cellsAlong, 3);
            FluidSolverSettings settings = StandardStateRig.WithCells(counts);
            settings = settings.WithOwn((ref StandardSettings own) => own.StableOrder = stable);
            using (var rig = new StandardStateRig(settings, count))
            {
                CellRows cells = rig.State.Cells;
                var random = new System.Random(count);
                var cellOf = new int[count];
                var ids = Enumerable.Range(0, count).Select(i => 3u * (uint)i).OrderBy(_ => random.Next()).ToArray();
                var positions = new Vector4[count];
                var velocities = new Vector4[count];
                for (int i = 0; i < count; i++)
                {
                    bool hasLeft = random.Next(11) == 0;
                    Vector3Int cell = StandardStateRig.RandomCell(cells, random);
                    cellOf[i] = hasLeft ? cells.CellCount : StandardStateRig.Number(cells, cell);
                    Vector3 position = StandardStateRig.Within(cells, cell, random);
                    Vector3 velocity = ParticleSets.RandomVector(random);
                    positions[i] = StandardStateRig.WithW(position, hasLeft ? -1f : 1000f + i);
                    velocities[i] = StandardStateRig.WithW(velocity, StandardStateRig.FromBits(ids[i]));
                }

                // Ranks in any order, as atomics give them; expected: the particle of each place.
                int[] byRank = Enumerable.Range(0, count).OrderBy(i => cellOf[i]).ThenBy(_ => random.Next()).ToArray();
                uint[] starts = Starts(cellOf, cells.CellCount);
                var ranks = new uint[count];
                for (int place = 0; place < count; place++) ranks[byRank[place]] = (uint)place - starts[cellOf[byRank[place]]];
                int[] byId = Enumerable.Range(0, count).OrderBy(i => cellOf[i]).ThenBy(i => ids[i]).ToArray();

                CellBuffers buffers = rig.State.Buffers;
                StandardStateRig.Fill(buffers.NewPositions, positions);
                StandardStateRig.Fill(buffers.NewVelocities, velocities);
                buffers.Rank.SetData(ranks);
                buffers.CellTable.SetData(starts);
                int counted = buffers.CellTotal + buffers.SumCount;
                buffers.CellCount.SetData(Enumerable.Range(0, counted).Select(i => i < buffers.CellTotal ? 0u : 9u).ToArray());
                rig.State.List.Counts.SetData(Enumerable.Range(0, count).Select(i => i % 3 == 0 ? 40u : 30u).ToArray());
                rig.State.ListTime = ListTime;
                var pass = new ScatterParticlesPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));

                uint[] sums = buffers.CellCount.Read<uint>(counted);
                Assert.That(sums, Is.All.Zero, "the scan's sums are cleared for the next count");
                Vector4[] sortedPositions = GpuTest.Read<Vector4>(buffers.Positions, count);
                Vector4[] terms = GpuTest.Read<Vector4>(buffers.PositionTerms, count);
                Vector4[] sortedVelocities = GpuTest.Read<Vector4>(buffers.Velocities, count);
                int live = (int)starts[cells.CellCount];
                for (int place = 0; place < live; place++)
                {
                    int source = stable ? byId[place] : byRank[place];
                    Assert.That((Vector3)sortedPositions[place], Is.EqualTo((Vector3)positions[source]), $"position at {place}");
                    Assert.That(terms[place].w, Is.EqualTo(positions[source].w), $"density before at {place}");
                    // Every third had many neighbours at the last sort.
                    float radius = rig.State.Settings.SupportRadius;
                    float reach = source % 3 == 0 ? -16f * radius * radius
                        : 4f * radius * Mathf.Min(((Vector3)velocities[source]).magnitude * ListTime, radius);
                    Assert.That(sortedPositions[place].w, Is.EqualTo(reach).Within(1e-3).Percent, $"reach at {place}");
                    Vector4 velocity = sortedVelocities[place];
                    Assert.That((Vector3)velocity, Is.EqualTo((Vector3)velocities[source]), $"velocity at {place}");
                    Assert.That(StandardStateRig.ToBits(velocity.w), Is.EqualTo(ids[source]), $"id at {place}");
                }
            }
        }

        private static uint[] Starts(int[] cellOf, int cellCount)
        {
            var starts = new uint[cellCount + 2];
            foreach (int cell in cellOf) starts[cell + 1]++;
            for (int i = 1; i < starts.Length; i++) starts[i] += starts[i - 1];
            return starts;
        }
    }
}
