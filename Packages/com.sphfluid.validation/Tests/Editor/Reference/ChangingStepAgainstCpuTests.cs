using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Steps of changing length on the GPU against the same steps on the CPU.</summary>
    public sealed class ChangingStepAgainstCpuTests
    {
        [Test]
        public void BothSolversTakeTheSameSteps()
        {
            FluidSolverSettings settings = TestSettings.ByRule(0.4f * Vector3.one, 0.02f);
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(7, 6, 7), 0.018f, 1e-3f, 2);
            FluidShaderSet shaders = TestShaders.CreateSet();
            float dt = settings.TimeStep;
            using (var gpu = new FluidSolver(settings, shaders, start))
            using (var cpu = new CpuFluidSolver(settings, start))
            {
                foreach (float part in new[] { 1f, 0.5f, 0.8f, 1.2f, 0.1f })
                {
                    GpuTest.Run(cmd => gpu.RecordSteps(cmd, 2, part * dt));
                    cpu.Step(2, part * dt);
                }

                Double3[] expected = cpu.ToFloat().OrderBy(p => p.Id).Select(p => (Double3)p.Position).ToArray();
                foreach (FluidParticle p in GpuTest.Read<FluidParticle>(gpu.Particles, start.Length))
                {
                    Assert.That(((Double3)p.Position - expected[p.Id]).Length, Is.LessThan(5e-5 * 0.02), $"particle {p.Id}");
                }

                Assert.That(gpu.SimulatedTime, Is.EqualTo(cpu.SimulatedTime).Within(1e-12));
            }
            Object.DestroyImmediate(shaders);
        }
    }
}
