using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The table of the cells with particles, the order that it gives and what readers see, against counts of all cells.</summary>
    public sealed class RankCellsTests
    {
        private static readonly Vector3Int Counts = new Vector3Int(37, 29, 41); // 43,993 cells: 43 words, the last with a part of a strip

        public enum Places
        {
            Anywhere,
            OneCell,
            Corners,
            Row,
        }

        [Test]
        public void EachCellBeginsAsInATableOfAll([Values(0, 1, 63, 64, 65, 257, 1009)] int count, [Values] Places places)
        {
            using (new ForcedCells(true))
            using (var rig = new StandardStateRig(StandardStateRig.WithCells(Counts), count))
            {
                CellRows cells = rig.State.Cells;
                CellBuffers buffers = rig.State.Buffers;
                var random = new System.Random(count);
                var cellOf = new int[count];
                var positions = new Vector4[count];
                for (int i = 0; i < count; i++)
                {
                    bool hasLeft = random.Next(11) == 0;
                    Vector3Int cell = At(places, cells, random);
                    cellOf[i] = hasLeft ? -1 : StandardStateRig.Number(cells, cell);
                    positions[i] = StandardStateRig.WithW(StandardStateRig.Within(cells, cell, random), hasLeft ? -1f : 1000f);
                }
                uint[] ids = Enumerable.Range(0, count).Select(i => 3u * (uint)i).OrderBy(_ => random.Next()).ToArray();
                StandardStateRig.Fill(buffers.NewPositions, positions);
                StandardStateRig.Fill(buffers.NewVelocities, ids.Select(id => StandardStateRig.WithW(Vector3.zero,
                    StandardStateRig.FromBits(id))).ToArray());
                uint born = (uint)Math.Min(count, 3);
                // What a sort before left: the head, and rubbish behind it.
                var table = Enumerable.Repeat(0xfffffff0u, buffers.CellTable.Count).ToArray();
                new[] { (uint)rig.State.Sparse.Words, (uint)count - born, 77u, born }.CopyTo(table, 0);
                buffers.CellTable.SetData(table);
                rig.State.List.Counts.SetData(new uint[Math.Max(count, 1)]);
                var rank = new RankCellsPass(rig.Shaders);
                var scatter = new ScatterParticlesPass(rig.Shaders);
                GpuTest.Run(cmd =>
                {
                    rank.Record(cmd, rig.State);
                    scatter.Record(cmd, rig.State);
                    rank.RecordPublish(cmd, rig.State);
                });

                // Where all cells begin.
                var starts = new uint[cells.CellCount + 1];
                foreach (int cell in cellOf.Where(cell => cell >= 0)) starts[cell + 1]++;
                for (int i = 1; i < starts.Length; i++) starts[i] += starts[i - 1];
                table = GpuTest.Read<uint>(buffers.CellTable, table.Length);
                int filled = cellOf.Where(cell => cell >= 0).Distinct().Count();
                int strips = cellOf.Where(cell => cell >= 0).Select(cell => cell / 32).Distinct().Count();
                uint live = starts[cells.CellCount];
                var head = new[] { (uint)rig.State.Sparse.Words, live, (uint)count, 0u, (uint)strips, (uint)filled };
                Assert.That(table.Take(6), Is.EqualTo(head));
                var sparse = new StoredCells(table);
                for (int cell = 0; cell < cells.CellCount; cell++)
                {
                    if (sparse.Start(cell) != starts[cell]) Assert.Fail($"cell {cell} begins at {sparse.Start(cell)}, not {starts[cell]}");
                }
                int[] inOrder = cellOf.Where(cell => cell >= 0).Distinct().OrderBy(cell => cell).ToArray();
                Assert.That(Enumerable.Range(0, filled).Select(sparse.NumberOf), Is.EqualTo(inOrder), "numbers of the stored cells");
                uint[] ranks = buffers.Rank.Read<uint>(count);
                int[] stays = Enumerable.Range(0, count).Where(i => cellOf[i] >= 0).ToArray();
                foreach (IGrouping<int, int> cell in stays.GroupBy(i => cellOf[i]))
                {
                    Assert.That(cell.Select(i => (int)ranks[i]), Is.EquivalentTo(Enumerable.Range(0, cell.Count())),
                        $"ranks in {cell.Key}");
                }
                int[] sorted = stays.OrderBy(i => cellOf[i]).ThenBy(i => ids[i]).ToArray();
                Assert.That(GpuTest.Read<Vector4>(buffers.Velocities, sorted.Length).Select(v => StandardStateRig.ToBits(v.w)),
                    Is.EqualTo(sorted.Select(i => ids[i])), "the order of the particles");

                FluidGrid grid = rig.State.Grid;
                var published = new PublishedCells(rig.State);
                for (int i = 0; i < grid.CellCount; i++)
                {
                    int row = i / grid.Counts.x;
                    var at = new Vector3Int(i % grid.Counts.x, row % grid.Counts.y, row / grid.Counts.y);
                    int number = StandardStateRig.Number(cells, at + Vector3Int.one);
                    var expected = new Vector2Int((int)starts[number], (int)starts[number + 1]);
                    if (published.Range(number) != expected) Assert.Fail($"cell {at} has {published.Range(number)}, not {expected}");
                }
            }
        }

        // More strips and cells than a group of a scan takes, and more words.
        [Test]
        public void ScansOfManyGroupsAgree()
        {
            const int count = 5003;
            using (new ForcedCells(true))
            using (var rig = new StandardStateRig(StandardStateRig.WithCells(new Vector3Int(171, 121, 131)), count))
            {
                CellRows cells = rig.State.Cells;
                Assert.That(rig.State.Sparse.Words, Is.GreaterThan(CellRows.CellsPerScanGroup));
                var random = new System.Random(5);
                Vector3Int[] places = Enumerable.Range(0, count).Select(_ => StandardStateRig.RandomCell(cells, random)).ToArray();
                rig.State.Buffers.NewPositions.SetData(places.Select(cell =>
                    StandardStateRig.WithW(StandardStateRig.Within(cells, cell, random), 0f)).ToArray());
                var rank = new RankCellsPass(rig.Shaders);
                GpuTest.Run(cmd =>
                {
                    rank.RecordLoad(cmd, rig.State);
                    rank.Record(cmd, rig.State);
                });
                int[] numbers = places.Select(cell => StandardStateRig.Number(cells, cell)).OrderBy(number => number).ToArray();
                var sparse = new StoredCells(GpuTest.Read<uint>(rig.State.Buffers.CellTable, rig.State.Buffers.CellCount.Begin));
                for (int i = 0; i < count; i++)
                {
                    int first = Array.FindIndex(numbers, number => number == numbers[i]);
                    Assert.That(sparse.Start(numbers[i]), Is.EqualTo(first), $"cell {numbers[i]}");
                    int end = Array.FindLastIndex(numbers, number => number == numbers[i]) + 1;
                    Assert.That(sparse.Start(numbers[i] + 1), Is.EqualTo(end), $"cell {numbers[i] + 1}");
                    if (numbers[i] > 40) Assert.That(sparse.Start(numbers[i] - 40), Is.EqualTo(numbers.Count(n => n < numbers[i] - 40)));
                }
            }
        }

        private static Vector3Int At(Places places, in CellRows cells, System.Random random)
        {
            Vector3Int last = cells.Counts - 2 * Vector3Int.one;
            switch (places)
            {
                case Places.OneCell:
                    return new Vector3Int(20, 11, 5);
                case Places.Corners:
                    int End(int far) => random.Next(2) == 0 ? 1 : far;
                    return new Vector3Int(End(last.x), End(last.y), End(last.z));
                case Places.Row:
                    return new Vector3Int(1 + random.Next(last.x), 7, last.z);
                default:
                    return StandardStateRig.RandomCell(cells, random);
            }
        }
    }
}
