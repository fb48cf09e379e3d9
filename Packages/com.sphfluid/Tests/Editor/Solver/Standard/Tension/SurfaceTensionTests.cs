using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>SurfaceTension against sums over all pairs in double precision.</summary>
    public sealed class SurfaceTensionTests
    {
        private const float Spacing = 0.05f;
        private const float TimeStep = 1e-3f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.5f, 0.35f);

        [Test]
        public void VelocitiesChangeByTheSumsOverAllPairs([Values(1, 63, 64, 65, 257, 1009)] int count,
            [Values(FluidAxes.None, FluidAxes.Y, FluidAxes.All)] FluidAxes periodic, [Values] bool listed)
        {
            FluidSolverSettings settings = Settings(periodic);
            using (var rig = new StandardStateRig(settings, count))
            {
                Double3[] change = Change(rig, 0.95f * Domain, listed, out FluidParticle[] particles, out Double3[] normals);
                double pull = 1.28 * 5.0 / Spacing, normalPull = 0.93 * 5.0 / (1000.0 * Spacing * Spacing);
                Double3[] expected = TensionReference.Accelerations(settings, particles, normals, pull, normalPull, 0.9);
                double largest = expected.Max(a => a.Length) + 0.1;
                for (int i = 0; i < count; i++)
                {
                    Assert.That((change[i] / (0.75 * TimeStep) - expected[i]).Length, Is.LessThan(3e-4 * largest), $"acceleration of {i}");
                }
            }
        }

        // Pairs pull equally and oppositely.
        [Test]
        public void MomentumStays()
        {
            const int count = 1009;
            using (var rig = new StandardStateRig(Settings(FluidAxes.None), count))
            {
                Double3[] change = Change(rig, 0.4f * Domain, true, out _, out _); // no wall in reach
                Double3 sum = change.Aggregate(Double3.Zero, (a, b) => a + b);
                Assert.That(sum.Length, Is.LessThan(1e-5 * change.Sum(v => v.Length)));
            }
        }

        private static FluidSolverSettings Settings(FluidAxes periodic) =>
            StandardStateRig.Water(Domain, Spacing, periodic).WithOwn((ref StandardSettings own) =>
        {
            own.SurfaceTension = 5f;
            own.ContactAngle = 116f;
        });

        private static Double3[] Change(StandardStateRig rig, Vector3 part, bool listed, out FluidParticle[] particles,
            out Double3[] normals)
        {
            int count = rig.State.ParticleCount;
            FluidParticle[] start = rig.FillSorted(ParticleSets.Random(count, part, 0f, 4));
            rig.FillList(start, listed);
            rig.State.RequireForce(new SurfaceTensionForce());
            var normalsPass = new SurfaceNormalsPass(rig.Shaders);
            var pass = new SurfaceTensionPass(rig.Shaders);
            GpuTest.Run(cmd =>
            {
                normalsPass.Record(cmd, rig.State);
                pass.Record(cmd, rig.State, new FluidStep(TimeStep, 0.5f * TimeStep, false));
            });
            particles = start;
            normals = GpuTest.Read<Vector4>(rig.State.ForceBuffers<TensionBuffers>().SurfaceNormals, count)
                .Select(n => (Double3)(Vector3)n).ToArray();
            Vector4[] velocities = GpuTest.Read<Vector4>(rig.State.Buffers.Velocities, count);
            Assert.That(velocities.Select(v => StandardStateRig.ToBits(v.w)), Is.EqualTo(start.Select(p => p.Id)));
            return velocities.Select(v => (Double3)(Vector3)v).ToArray();
        }
    }
}
