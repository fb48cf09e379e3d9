using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>How lists of neighbours are put together of runs.</summary>
    public sealed class ListRunsTests
    {
        private const float Spacing = 0.05f;

        // Compressed by 10 %, which no calm liquid is, and by 3 % where there are the most runs: at triangles and where axes wrap.
        [Test]
        public void NobodyOfALiquidSearchesAgain(
            [Values(FluidAxes.None, FluidAxes.X, FluidAxes.Y, FluidAxes.Z, FluidAxes.X | FluidAxes.Z)] FluidAxes periodic,
            [Values] bool walled)
        {
            var counts = new Vector3Int(14, 13, 15);
            float spacing = Spacing * Mathf.Pow(walled && periodic != FluidAxes.None ? 1.03f : 1.1f, -1f / 3f);
            FluidSolverSettings settings = StandardStateRig.Water(spacing * (Vector3)counts, Spacing, periodic);
            FluidParticle[] lattice = ParticleSets.Lattice(counts, spacing, 0.05f * Spacing, 5);
            for (int i = 0; i < lattice.Length; i++)
            {
                Vector3 half = 0.499f * settings.DomainSize;
                lattice[i].Position = Vector3.Max(Vector3.Min(lattice[i].Position, half), -half);
            }

            CollisionBodies bodies = null;
            using (StandardStateRig rig = walled
                       ? WalledStateRig.Create(settings, lattice.Length, out bodies)
                       : new StandardStateRig(settings, lattice.Length))
            using (bodies)
            {
                rig.State.List.WallSlot.SetData(new uint[lattice.Length]);
                FluidParticle[] sorted = rig.FillSorted(lattice);
                uint[] listed = Record(rig, out uint[] words);

                Assert.That(listed.Max(), Is.InRange(50u, (uint)rig.State.List.Length), "all are listed, and some lists are long");
                for (int i = 0; i < sorted.Length; i += 7)
                {
                    AssertNear(sorted, i, ListColumns.Read(words, i, rig.State.List.Length), listed[i], settings);
                }
            }
        }

        // Over 65,535 particles a slab of cells: what 16 bits do not reach begins a run.
        [Test]
        public void NeighboursFarAheadBeginARun()
        {
            var counts = new Vector3Int(259, 257, 2);
            FluidSolverSettings settings = StandardStateRig.Water(2.2f * Spacing * (Vector3)counts, Spacing);
            FluidParticle[] sparse = ParticleSets.Lattice(counts, 2.1f * Spacing, 0f, 1); // R is 2.25 spacings
            using (var rig = new StandardStateRig(settings, sparse.Length))
            {
                FluidParticle[] sorted = rig.FillSorted(sparse);
                uint[] listed = Record(rig, out uint[] words);

                Assert.That(listed.Min(), Is.EqualTo(3u), "in a corner");
                Assert.That(listed.Max(), Is.EqualTo(5u));
                int far = 0;
                for (int i = 0; i < sorted.Length; i += 3)
                {
                    List<int> found = ListColumns.Read(words, i, rig.State.List.Length);
                    AssertNear(sorted, i, found, listed[i], settings);
                    far += found.Zip(found.Skip(1), (j, k) => k - j > 0xffff ? 1 : 0).Sum();
                }

                Assert.That(far, Is.GreaterThan(sorted.Length / 10), "neighbours that 16 bits do not reach");
            }
        }

        private static uint[] Record(StandardStateRig rig, out uint[] words)
        {
            NeighbourList list = rig.State.List;
            int count = rig.State.ParticleCount;
            GpuTest.Run(cmd => new StandardDensityPass(rig.Shaders).Record(cmd, rig.State));
            words = GpuTest.Read<uint>(list.Neighbours, (count + 31) / 32 * 32 * NeighbourList.ColumnWords(list.Length));
            return list.Counts.Read<uint>(count);
        }

        private static void AssertNear(FluidParticle[] particles, int i, List<int> found, uint count, in FluidSolverSettings settings)
        {
            Assert.That(found.Count, Is.EqualTo(count), $"neighbours of {i}");
            Assert.That(found.Distinct().Count(), Is.EqualTo(found.Count), $"each of {i} once");
            foreach (int j in found)
            {
                Assert.That(j, Is.Not.EqualTo(i));
                double r = ThesisReference.Separation(particles[i], particles[j], settings.PeriodLength).Length;
                Assert.That(r, Is.LessThan(1.00001 * settings.SupportRadius), $"{i} and {j}");
            }
        }
    }
}
