using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>GradientMoments against sums over all pairs in double precision.</summary>
    public sealed class GradientMomentsTests
    {
        private const float Spacing = 0.05f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.5f, 0.35f);

        [Test]
        public void MomentsAreTheSumsOverAllPairsAndImages([Values(1, 63, 64, 65, 257)] int count,
            [Values(FluidAxes.None, FluidAxes.All)] FluidAxes periodic, [Values] bool listed)
        {
            FluidSolverSettings settings = CorrectionReference.Corrected(StandardStateRig.Water(Domain, Spacing, periodic));
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, 0.95f * Domain, 0f, 4));
                rig.FillList(particles, listed);
                var random = new System.Random(8);
                float[] densities = particles.Select(_ => settings.RestDensity * (0.9f + 0.25f * (float)random.NextDouble())).ToArray();
                rig.SetTerms(densities.Select(density => new Vector2(density, 0f)).ToArray());
                rig.State.RequireCarried(StandardForces.All);
                var pass = new GradientMomentsPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));
                float[] found = GpuTest.Read<float>(rig.State.ForceBuffers<GradientCorrectionBuffers>().Moments, 6 * count);
                for (int i = 0; i < count; i++)
                {
                    double[] expected = CorrectionReference.Moment(settings, particles, densities[i], i);
                    double error = 3e-5 * (0.1 + expected.Take(3).Sum());
                    for (int k = 0; k < 6; k++) Assert.That(found[6 * i + k], Is.EqualTo(expected[k]).Within(error), $"{k} of {i}");
                }
            }
        }

        [Test]
        public void NearTrianglesTheMomentIsThatOfALattice()
        {
            const int count = 65;
            FluidSolverSettings settings = CorrectionReference.Corrected(StandardStateRig.Water(Domain, Spacing));
            using (StandardStateRig rig = WalledStateRig.Create(settings, count, out CollisionBodies bodies))
            using (bodies)
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, 0.5f * Domain, 0f, 4));
                rig.FillList(particles, true);
                rig.SetTerms(Enumerable.Repeat(new Vector2(settings.RestDensity, 0f), count).ToArray());
                WalledStateRig.SetWalls(rig,
                    particles.Select(p => StoredWall.Pack(p.Position, false, 0.1f, null, (Vector3.up, Spacing))).ToList());
                rig.State.RequireCarried(StandardForces.All);
                var pass = new GradientMomentsPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));
                float[] found = GpuTest.Read<float>(rig.State.ForceBuffers<GradientCorrectionBuffers>().Moments, 6 * count);
                float moment = (float)WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing);
                Assert.That(found, Is.EqualTo(Enumerable.Range(0, 6 * count).Select(k => k % 6 < 3 ? moment : 0f)));
            }
        }

        [Test]
        public void ALatticeHasItsMomentInEveryDirection()
        {
            FluidSolverSettings settings =
                CorrectionReference.Corrected(StandardStateRig.Water(0.4f * Vector3.one, Spacing, FluidAxes.All));
            FluidParticle[] all = ParticleSets.Lattice(new Vector3Int(8, 8, 8), Spacing, 0f, 1);
            using (var rig = new StandardStateRig(settings, all.Length))
            {
                FluidParticle[] particles = rig.FillSorted(all);
                rig.FillList(particles, true);
                rig.SetTerms(Enumerable.Repeat(new Vector2(settings.RestDensity, 0f), all.Length).ToArray());
                rig.State.RequireCarried(StandardForces.All);
                var pass = new GradientMomentsPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));
                float[] found = GpuTest.Read<float>(rig.State.ForceBuffers<GradientCorrectionBuffers>().Moments, 6 * all.Length);
                double moment = WendlandKernel.LatticeMoment(settings.SupportRadius / settings.Spacing);
                Assert.That(found.Where((m, k) => k % 6 < 3), Is.All.EqualTo(moment).Within(1e-4));
                Assert.That(found.Where((m, k) => k % 6 >= 3), Is.All.EqualTo(0f).Within(1e-5f));
            }
        }
    }
}
