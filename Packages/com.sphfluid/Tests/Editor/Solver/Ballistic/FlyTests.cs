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
            using (var solver = new FluidSolver(FluidRules.Derive(input), shaders, ParticleSets.Random(count, 0.1f * Vector3.one, 0f, 3)))
            {
                FluidParticle[] before = GpuTest.Read<FluidParticle>(solver.Particles, count);
                GpuTest.Run(cmd => solver.RecordSteps(cmd, 10));
                FluidParticle[] after = GpuTest.Read<FluidParticle>(solver.Particles, count);
                for (int i = 0; i < count; i++) Assert.That(after[i].Position.y - before[i].Position.y, Is.EqualTo(-0.5f * 9.81f * 0.01f).Within(1e-4f));
            }
            Object.DestroyImmediate(shaders);
        }
    }
}
