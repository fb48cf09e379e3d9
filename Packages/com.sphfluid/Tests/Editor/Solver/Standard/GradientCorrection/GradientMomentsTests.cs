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
        public void MomentsAreTheSumsOverAllPairsAndWalls([Values(1, 63, 64, 65, 257)] int count,
            [Values(FluidAxes.None, FluidAxes.All)] FluidAxes periodic, [Values] bool listed)
        {
            FluidSolverSettings settings = CorrectionReference.Corrected(StandardStateRig.Water(Domain, Spacing, periodic));
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, 0.95f * Domain, 0f, 4));
                rig.FillList(particles, listed);
                rig.State.RequireCarried();
                var pass = new GradientMomentsPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));
                float[] found = GpuTest.Read<float>(rig.State.ForceBuffers<GradientCorrectionBuffers>().Moments, 6 * count);
                for (int i = 0; i < count; i++)
                {
                    double[] expected = CorrectionReference.Moment(settings, particles, i);
                    double error = 3e-5 * (0.1 + expected.Take(3).Sum());
                    for (int k = 0; k < 6; k++) Assert.That(found[6 * i + k], Is.EqualTo(expected[k]).Within(error), $"{k} of {i}");
                }
            }
        }

        [Test]
        public void ALatticeHasItsMomentInEveryDirection()
        {
            FluidSolverSettings settings = CorrectionReference.Corrected(StandardStateRig.Water(0.4f * Vector3.one, Spacing, FluidAxes.All));
            FluidParticle[] all = ParticleSets.Lattice(new Vector3Int(8, 8, 8), Spacing, 0f, 1);
            using (var rig = new StandardStateRig(settings, all.Length))
            {
                FluidParticle[] particles = rig.FillSorted(all);
                rig.FillList(particles, true);
                rig.State.RequireCarried();
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
