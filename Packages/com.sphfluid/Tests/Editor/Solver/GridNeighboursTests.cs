using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The neighbour loop finds every pair within h, once, from both sides.</summary>
    public sealed class GridNeighboursTests
    {
        private static readonly Vector3 Domain = new Vector3(0.5f, 0.37f, 0.43f);

        [TestCase(1, true)]
        [TestCase(257, true)]
        [TestCase(2003, true)]
        [TestCase(2003, false)]
        public void PairsAgreeWithBruteForce(int count, bool octant)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.025f);
            settings.OctantSearch = octant;
            using (var rig = new ThesisRig(settings, ParticleSets.Random(count, Domain, 0f, count)))
            {
                rig.RunNeighbourSetup();
                NeighbourPairs.Check(rig);
            }
        }

        [Test]
        public void PairsAcrossEveryHalfCellAgreeWithBruteForce([Values] bool octant)
        {
            // A lattice of h/2 puts particles on cell faces and half-cell planes.
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.025f);
            settings.OctantSearch = octant;
            FluidParticle[] lattice = ParticleSets.Lattice(new Vector3Int(19, 14, 16), 0.5f * settings.SupportRadius, 1e-7f, 9);
            using (var rig = new ThesisRig(settings, lattice))
            {
                rig.RunNeighbourSetup();
                NeighbourPairs.Check(rig);
            }
        }

        [TestCase(1)]
        [TestCase(2003)]
        public void BothSearchesGiveTheSameDensitiesAndForces(int count)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.025f);
            FluidParticle[] start = ParticleSets.Random(count, Domain, 2f, 3);
            Dictionary<uint, Vector4> octant = DensityAndForce(settings, start);
            settings.OctantSearch = false;
            Dictionary<uint, Vector4> rows = DensityAndForce(settings, start);
            double largest = octant.Values.Max(v => ((Vector3)v).magnitude);
            foreach (uint id in octant.Keys)
            {
                Assert.That(rows[id].w, Is.EqualTo(octant[id].w).Within(2e-5).Percent.Or.EqualTo(octant[id].w).Within(0.02),
                    $"density of {id}");
                Assert.That((rows[id] - octant[id]).magnitude, Is.LessThan(1e-5 * largest + 0.02), $"force on {id}");
            }
        }

        [Test]
        public void EightCellsOfTheWrongSizeLosePairs()
        {
            // The octant rule on cells of h: the kernel searches 8, the grid is that of 27.
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.025f);
            settings.OctantSearch = false;
            using (var rig = new ThesisRig(settings, ParticleSets.Random(1009, Domain, 0f, 8)))
            {
                FluidSolverSettings wrong = settings;
                wrong.OctantSearch = true;
                rig.State.Settings = wrong;
                rig.RunNeighbourSetup();
                NeighbourPairs.Count(rig, out int pairs, out int missing, out int oneWay);
                Assert.That(missing, Is.GreaterThan(pairs / 20), "pairs lost");
                Assert.That(oneWay, Is.GreaterThan(0), "the force on one of them has no counterforce");
            }
        }

        private static Dictionary<uint, Vector4> DensityAndForce(in FluidSolverSettings settings, FluidParticle[] start)
        {
            using (var rig = new ThesisRig(settings, start))
            {
                rig.RunNeighbourSetup();
                var pass = new CalculateForcePass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));
                FluidParticle[] particles = rig.ReadParticles();
                float[] density = rig.ReadDensity();
                Vector4[] force = rig.ReadForce();
                return Enumerable.Range(0, particles.Length).ToDictionary(i => particles[i].Id,
                    i => new Vector4(force[i].x, force[i].y, force[i].z, density[i]));
            }
        }
    }
}
