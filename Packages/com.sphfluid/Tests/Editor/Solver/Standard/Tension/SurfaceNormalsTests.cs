using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>SurfaceNormals against sums over all pairs in double precision.</summary>
    public sealed class SurfaceNormalsTests
    {
        private const float Spacing = 0.05f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.5f, 0.35f);

        [Test]
        public void NormalsAreTheSumsOverAllPairs([Values(1, 63, 64, 65, 257, 1009)] int count,
            [Values(FluidAxes.None, FluidAxes.Y, FluidAxes.All)] FluidAxes periodic, [Values] bool listed)
        {
            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing, periodic).WithOwn((ref StandardSettings own) =>
            {
                own.SurfaceTension = 5f;
                own.ContactAngle = 116f;
            });
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, 0.95f * Domain, 0f, 4));
                rig.FillList(particles, listed);
                rig.State.RequireForce(new SurfaceTensionForce());
                var pass = new SurfaceNormalsPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));
                Vector4[] found = GpuTest.Read<Vector4>(rig.State.ForceBuffers<TensionBuffers>().SurfaceNormals, count);
                Double3[] expected = TensionReference.Normals(settings, particles, 0.9);
                double largest = expected.Max(n => n.Length) + 0.1;
                for (int i = 0; i < count; i++)
                {
                    Assert.That(((Double3)(Vector3)found[i] - expected[i]).Length, Is.LessThan(2e-4 * largest), $"normal of {i}");
                }
            }
        }
    }
}
