using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Fly at awkward numbers of particles.</summary>
    public sealed class FlyTests
    {
        [TestCase(1)]
        [TestCase(255)]
        [TestCase(257)]
        [TestCase(1009)]
        public void AFallFromRestIsHalfOfGravityTimesTheSquareOfTime(int count)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = FluidMethodKind.Ballistic;
            input.DomainSize = 10f * Vector3.one;
            input.Spacing = 0.1f;
            input.FixedTimeStep = 0.01f;
            FluidShaderSet shaders = TestShaders.CreateSet();
            FluidParticle[] start = ParticleSets.Random(count, 0.1f * Vector3.one, 0f, 3);
            using (var solver = new FluidSolver(FluidRules.Derive(input), shaders, start))
            {
                GpuTest.Run(cmd => solver.RecordSteps(cmd, 10));
                FluidParticle[] after = GpuTest.Read<FluidParticle>(solver.Particles, count);
                for (int i = 0; i < count; i++)
                {
                    Vector3 way = after[i].Position - start[i].Position;
                    Assert.That(Vector3.Distance(way, new Vector3(0f, -0.5f * 9.81f * 0.01f, 0f)), Is.LessThan(1e-4f), $"way of {i}");
                }
            }
            Object.DestroyImmediate(shaders);
        }
    }
}
