using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Triangles act within reach of the kernel only.</summary>
    public sealed class FarMeshTests
    {
        private const float Spacing = 0.05f;
        private const int Steps = 8;

        private static readonly Vector3[] Directions =
        {
            Vector3.right, Vector3.left, Vector3.up, Vector3.down, Vector3.forward, Vector3.back,
        };

        [Test]
        public void DropsOutOfReachOfAMeshFlyAsIfThereWereNone([ValueSource(nameof(Directions))] Vector3 direction)
        {
            FluidParticle[] start = Enumerable.Range(0, 3)
                .Select(i => new FluidParticle(new Vector3(0.4f * (i - 1), 0.3f, 0.1f * i), 0.5f * direction, (uint)i)).ToArray();
            FluidParticle[] free = Fly(start, false), beside = Fly(start, true);
            for (int i = 0; i < start.Length; i++)
            {
                Assert.That((beside[i].Position - free[i].Position).magnitude, Is.LessThan(1e-6f), $"particle {i}");
                Assert.That((beside[i].VelT0 - free[i].VelT0).magnitude, Is.LessThan(1e-6f), $"particle {i}");
                Assert.That(Vector3.Dot(free[i].Position - start[i].Position, direction), Is.GreaterThan(0f), "it flies");
            }
        }

        private static FluidParticle[] Fly(FluidParticle[] start, bool mesh)
        {
            FluidSolverSettings settings = BodyRig.Water(2f * Vector3.one, Spacing, 0.5f, 1f);
            settings.Gravity = Vector3.zero;
            using (var rig = new BodyRig(settings))
            {
                if (mesh) rig.AddBox(new Vector3(0.3f, 0.2f, 0.3f)).position = new Vector3(0.1f, -0.7f, -0.1f);
                rig.Start(start);
                rig.Frame(Steps);
                return rig.Particles().OrderBy(p => p.Id).ToArray();
            }
        }
    }
}
