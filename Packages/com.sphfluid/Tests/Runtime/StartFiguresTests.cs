using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What a start derives from the scene.</summary>
    public sealed class StartFiguresTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        [Test]
        public void LiquidThatStartsFastHasAFasterSound([Values(FluidMethodKind.Standard, FluidMethodKind.Thesis)] FluidMethodKind method)
        {
            float slow = Start(method, Vector3.zero).Solver.Settings.SoundSpeed;
            FluidSolverSettings fast = Start(method, new Vector3(3f, 0f, 4f)).Solver.Settings;
            Assert.That(fast.SoundSpeed, Is.GreaterThanOrEqualTo(5f * rig.Profile.SoundSpeedRatio).And.GreaterThan(slow));
        }

        [Test]
        public void MemoryCountsCollidersBesidesTheSolver([Values(FluidMethodKind.Standard, FluidMethodKind.Thesis)] FluidMethodKind method)
        {
            GameObject floor = GameObject.CreatePrimitive(PrimitiveType.Cube);
            floor.layer = SimulationRig.Layer;
            floor.transform.localScale = new Vector3(0.3f, 0.05f, 0.3f);
            floor.transform.position = new Vector3(0f, -0.15f, 0f);
            try
            {
                FluidSimulation simulation = Start(method, Vector3.zero);
                Assert.That(simulation.GpuBytes, Is.GreaterThan(simulation.Solver.GpuBytes));
            }
            finally
            {
                Object.DestroyImmediate(floor);
            }
        }

        [Test]
        public void TheAccelerationLimitIsTheSameDisplacementInAStepOfAnyLength([Values(0.5f, 0.1f)] float part)
        {
            FluidSolverSettings byRule = Start(FluidMethodKind.Thesis, Vector3.zero).Solver.Settings;
            FluidSolverSettings given = Start(FluidMethodKind.Thesis, Vector3.zero, part * byRule.TimeStep).Solver.Settings;
            Assert.That(given.TimeStep, Is.EqualTo(part * byRule.TimeStep));
            double displacement = byRule.Own<ThesisSettings>().AccelerationLimit * (double)byRule.TimeStep * byRule.TimeStep;
            Assert.That(given.Own<ThesisSettings>().AccelerationLimit * (double)given.TimeStep * given.TimeStep,
                Is.EqualTo(displacement).Within(0.01).Percent);
        }

        private FluidSimulation Start(FluidMethodKind method, Vector3 velocity, float timeStep = 0f)
        {
            FluidSimulation simulation = rig.Create($"{method} {velocity.magnitude} {timeStep}", false);
            simulation.Method = method;
            if (timeStep > 0f)
            {
                simulation.TimeStepMode = FluidTimeStepMode.Fixed;
                simulation.FixedTimeStep = timeStep;
            }
            rig.AddVolume(simulation).InitialVelocity = velocity;
            Assert.That(simulation.StartSimulation(), simulation.StatusMessage);
            return simulation;
        }
    }
}
