using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Liquid that falls without end along a periodic axis gets faster than expected: steps that follow it stay stable.</summary>
    public sealed class AdaptiveTimeStepTests
    {
        private const int Frames = 40;

        private SimulationRig rig;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            rig.Profile.SoundSpeedMode = FluidSoundSpeedMode.FixedByRule;
        }

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator FastLiquidTakesMoreStepsAndNoneIsLongerThanAdvised()
        {
            FluidSimulation simulation = Falling();
            yield return null;
            simulation.StartSimulation();
            long early = 0, late = 0;
            for (int frame = 0; frame < Frames; frame++)
            {
                long steps = simulation.StepCount;
                double time = simulation.SimulatedTime;
                yield return null;
                early = frame == 0 ? simulation.StepCount - steps : early;
                late = simulation.StepCount - steps;
                Assert.That(simulation.SimulatedTime - time, Is.EqualTo(0.01).Within(1e-7), "the steps fill the frame");
                FluidSolver solver = simulation.Solver;
                double largest = FluidRules.Advise(solver.Settings, solver.ReadCountersNow().MaxSpeed).Largest;
                Assert.That(simulation.TimeStep, Is.LessThanOrEqualTo(largest), $"frame {frame}");
                Assert.That(late * simulation.TimeStep, Is.EqualTo(0.01).Within(1e-7));
            }
            Assert.That(simulation.Solver.Counters.MaxSpeed, Is.GreaterThan(3f * simulation.Solver.Settings.MaxSpeed),
                "faster than expected");
            Assert.That(late, Is.GreaterThan(2 * early));
            Assert.That(simulation.CapHits, Is.Zero);
        }

        [UnityTest]
        public IEnumerator TheCapSlowsTimeAndNeverLengthensTheSteps()
        {
            const int frames = 3 * Frames; // half a second of capped frames is reported
            FluidSimulation simulation = Falling();
            simulation.MaxSubstepsPerFrame = 6;
            LogAssert.Expect(LogType.Warning, new Regex("A frame of 10 ms needs .* steps of .* ms, but at most 6 are allowed"));
            yield return null;
            simulation.StartSimulation();
            for (int frame = 0; frame < frames; frame++)
            {
                yield return null;
                FluidSolver solver = simulation.Solver;
                double largest = FluidRules.Advise(solver.Settings, solver.ReadCountersNow().MaxSpeed).Largest;
                Assert.That(simulation.TimeStep, Is.LessThanOrEqualTo(largest), $"frame {frame}");
            }
            Assert.That(simulation.CapHits, Is.GreaterThan(0));
            Assert.That(simulation.SimulatedTime, Is.LessThan(0.95 * 0.01 * frames));
            Assert.That(simulation.StepCount, Is.LessThanOrEqualTo(6 * frames));
        }

        [UnityTest]
        public IEnumerator ResultsDoNotDependOnWhenTheReadBacksArrive()
        {
            yield return null;
            FluidParticle[][] ends = new FluidParticle[2][];
            long[] steps = new long[2];
            for (int turn = 0; turn < 2; turn++)
            {
                FluidSimulation simulation = Falling();
                simulation.StartSimulation();
                for (int frame = 0; frame < 12; frame++)
                {
                    yield return null;
                    if (turn == 1) AsyncGPUReadback.WaitAllRequests();
                }
                ends[turn] = SimulationRig.Read(simulation);
                steps[turn] = simulation.StepCount;
                Object.DestroyImmediate(simulation.gameObject);
            }
            Assert.That(steps[1], Is.EqualTo(steps[0]));
            Assert.That(ends[1].Select(p => p.Position), Is.EqualTo(ends[0].Select(p => p.Position)), "to the last bit");
        }

        [UnityTest]
        public IEnumerator TheModeChangesDuringPlay()
        {
            FluidSimulation simulation = rig.Create();
            yield return null;
            simulation.StartSimulation();
            yield return null;
            FluidSolver solver = simulation.Solver;
            Assert.That(simulation.TimeStep, Is.EqualTo(solver.Settings.TimeStep));
            simulation.TimeStepMode = FluidTimeStepMode.Adaptive;
            yield return null;
            double time = simulation.SimulatedTime;
            yield return null;
            Assert.That(simulation.SimulatedTime - time, Is.EqualTo(0.01).Within(1e-7));
            simulation.TimeStepMode = FluidTimeStepMode.Automatic;
            yield return null;
            Assert.That(simulation.TimeStep, Is.EqualTo(solver.Settings.TimeStep));
            Assert.That(simulation.Solver, Is.SameAs(solver));
        }

        // 0.4 s at 100 m/s² reach 40 m/s, where the fall within the box is expected to give 7.7 m/s.
        private FluidSimulation Falling()
        {
            FluidSimulation simulation = rig.Create();
            simulation.TimeStepMode = FluidTimeStepMode.Adaptive;
            simulation.Boundaries = new FluidBoundaries { Periodic = FluidAxes.X };
            simulation.UseSceneGravity = false;
            simulation.Gravity = new Vector3(100f, 0f, 0f);
            return simulation;
        }
    }
}
