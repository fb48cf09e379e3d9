using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>LimitVelocities at awkward numbers of particles.</summary>
    public sealed class LimitVelocitiesTests
    {
        [TestCase(1)]
        [TestCase(63)]
        [TestCase(64)]
        [TestCase(65)]
        [TestCase(1009)]
        public void FastParticlesKeepTheirDirectionAndSlowOnesTheirVelocity(int count)
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(0.4f, 0.5f, 0.3f), 0.05f, 0.3f);
            FluidShaderSet shaders = TestShaders.CreateSet();
            using (var state = new StandardState(settings, count))
            {
                Vector4[] before = Enumerable.Range(0, count).Select(i => new Vector4(0.006f * i, 0f, -0.008f * i, i)).ToArray();
                state.Buffers.NewVelocities.SetData(before);
                GpuTest.Run(cmd => new LimitVelocitiesPass(shaders).Record(cmd, state, 2f));
                Vector4[] after = GpuTest.Read<Vector4>(state.Buffers.NewVelocities, count);
                for (int i = 0; i < count; i++)
                {
                    float speed = Mathf.Min(2f, 0.01f * i);
                    Assert.That(Vector3.Distance(after[i], speed * new Vector3(0.6f, 0f, -0.8f)), Is.LessThan(1e-6f), $"velocity of {i}");
                    Assert.That(after[i].w, Is.EqualTo((float)i));
                }
            }
            Object.DestroyImmediate(shaders);
        }
    }
}
