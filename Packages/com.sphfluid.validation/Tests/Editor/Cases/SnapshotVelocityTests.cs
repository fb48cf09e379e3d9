using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A snapshot's velocities are those at the time of its positions, whatever the lengths of the steps.</summary>
    public sealed class SnapshotVelocityTests
    {
        private static readonly Vector3 Gravity = new Vector3(0.5f, -9.81f, 0);

        [TestCase(0, 1f)]
        [TestCase(1, 1f)]
        [TestCase(7, 1f)]
        [TestCase(7, 0.5f)]
        [TestCase(7, 3f)]
        public void OfAFallAreExact(int steps, float ratio)
        {
            FluidShaderSet shaders = TestShaders.CreateSet();
            FluidSolverSettings settings = TestSettings.ByRule(Vector3.one, 0.05f);
            settings.Gravity = Gravity;
            settings.TimeStep = 0.01f;
            var start = new Vector3(1, 2, -0.25f);
            using (var solver = new FluidSolver(settings, shaders, new[] { new FluidParticle(new Vector3(-0.3f, 0, 0.1f), start, 0) }))
            {
                GpuTest.Run(cmd => solver.RecordSteps(cmd, steps));
                GpuTest.Run(cmd => solver.RecordSteps(cmd, 3, ratio * settings.TimeStep));
                FluidSnapshot state = FluidSnapshot.Read(solver);
                float t = (float)solver.SimulatedTime;

                Assert.That(t, Is.EqualTo((steps + 3 * ratio) * 0.01f).Within(1e-6f));
                Assert.That(Vector3.Distance(state.Velocities[0], start + t * Gravity), Is.LessThan(3e-6f));
                Assert.That(Vector3.Distance(state.LocalPositions[0], new Vector3(-0.3f, 0, 0.1f) + t * start + 0.5f * t * t * Gravity),
                    Is.LessThan(0.0003f));
            }
            Object.DestroyImmediate(shaders);
        }

        [Test]
        public void OfAStoppedComponentAreZero()
        {
            var particle = new FluidParticle(Vector3.zero, new Vector3(3, 2, 1), 0) { VelT0 = new Vector3(0, 2.5f, 1) };
            Assert.That(CaseStates.State(new[] { particle }).Velocities[0], Is.EqualTo(new Vector3(0, 3, 1)));
        }
    }
}
