using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>LoadParticles on particles whose cells are known.</summary>
    public sealed class LoadParticlesTests
    {
        [Test]
        public void EachParticleIsTakenOverAndCountedInItsCell(
            [Values(0, 1, 255, 256, 257, 1009)] int count, [Values(1, 5)] int cellsAlong)
        {
            var counts = new Vector3Int(2 + cellsAlong, 3, 2 + cellsAlong);
            FluidSolverSettings settings = StandardStateRig.WithCells(counts);
            using (var rig = new StandardStateRig(settings, count))
            {
                CellRows cells = rig.State.Cells;
                var random = new System.Random(count);
                FluidParticle[] particles = ParticleSets.Random(count, Vector3.one, 1f, count);
                var cellOf = new int[count];
                for (int i = 0; i < count; i++)
                {
                    Vector3Int cell = StandardStateRig.RandomCell(cells, random);
                    particles[i].Position = StandardStateRig.Within(cells, cell, random);
                    particles[i].VelT1 = ParticleSets.RandomVector(random); // steps go on from VelT0
                    particles[i].Id = (uint)(5 * count - 5 * i);
                    cellOf[i] = StandardStateRig.Number(cells, cell);
                }

                Load(rig, particles);

                Vector4[] positions = GpuTest.Read<Vector4>(rig.State.Buffers.NewPositions, count);
                Vector4[] velocities = GpuTest.Read<Vector4>(rig.State.Buffers.NewVelocities, count);
                for (int i = 0; i < count; i++)
                {
                    Vector4 expectedPosition = StandardStateRig.WithW(particles[i].Position, 0f);
                    Assert.That(positions[i], Is.EqualTo(expectedPosition), $"position {i}");
                    Assert.That((Vector3)velocities[i], Is.EqualTo(particles[i].VelT0), $"velocity {i}");
                    Assert.That(StandardStateRig.ToBits(velocities[i].w), Is.EqualTo(particles[i].Id), $"id {i}");
                }

                var expected = new uint[cells.CellCount + 1];
                foreach (int cell in cellOf) expected[cell]++;
                Assert.That(rig.State.Buffers.CellCount.Read<uint>(expected.Length), Is.EqualTo(expected));
                StandardStateRig.AssertSums(rig.State, expected);
                uint[] ranks = rig.State.Buffers.Rank.Read<uint>(count);
                foreach (IGrouping<int, int> cell in Enumerable.Range(0, count).GroupBy(i => cellOf[i]))
                {
                    IEnumerable<int> ofCell = cell.Select(i => (int)ranks[i]).OrderBy(rank => rank);
                    Assert.That(ofCell, Is.EqualTo(Enumerable.Range(0, cell.Count())), $"ranks in cell {cell.Key}");
                }
            }
        }

        // Cells of the border stay empty, so that rows beside the domain's faces need no tests.
        [Test]
        public void OnAndBeyondAFaceParticlesBelongToTheCellsThere([Values(0.999f, 1f, 1.5f)] float beyond)
        {
            FluidSolverSettings settings = StandardStateRig.WithCells(new Vector3Int(6, 5, 7));
            settings.DomainSize = settings.SupportRadius * new Vector3(4f, 3f, 5f);
            using (var rig = new StandardStateRig(settings, 8))
            {
                CellRows cells = rig.State.Cells;
                Assert.That(cells.Counts, Is.EqualTo(new Vector3Int(6, 5, 7)));
                var particles = new FluidParticle[8];
                var expected = new uint[cells.CellCount + 1];
                for (uint i = 0; i < 8; i++)
                {
                    var high = new Vector3Int((int)i & 1, (int)i >> 1 & 1, (int)i >> 2);
                    Vector3 corner = 0.5f * Vector3.Scale(2 * high - Vector3Int.one, settings.DomainSize);
                    particles[i] = new FluidParticle(beyond * corner, Vector3.zero, i);
                    Vector3Int cell = Vector3Int.one + Vector3Int.Scale(high, cells.Counts - 3 * Vector3Int.one);
                    expected[StandardStateRig.Number(cells, cell)]++;
                }

                Load(rig, particles);
                Assert.That(rig.State.Buffers.CellCount.Read<uint>(expected.Length), Is.EqualTo(expected));
                StandardStateRig.AssertSums(rig.State, expected);
            }
        }

        private static void Load(StandardStateRig rig, FluidParticle[] particles)
        {
            StandardStateRig.Fill(rig.State.Published.Particles, particles);
            rig.State.Buffers.CellCount.SetData(Enumerable.Repeat(99u, StandardStateRig.Counted(rig.State)).ToArray());
            var pass = new LoadParticlesPass(rig.Shaders);
            GpuTest.Run(cmd => pass.Record(cmd, rig.State));
        }
    }
}
