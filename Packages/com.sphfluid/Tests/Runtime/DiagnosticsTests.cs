using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>The diagnostics component beside a running simulation.</summary>
    public sealed class DiagnosticsTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator MeasuresTheStartAndThenEveryFewFrames()
        {
            FluidDiagnostics diagnostics = Watch(rig.Create(), 3);
            var measured = new List<FluidStatistics>();
            diagnostics.Measured += measured.Add;
            Assert.That(diagnostics.MeasurementCount, Is.Zero);
            yield return Frames(diagnostics, 12);
            Assert.That(measured.Count, Is.InRange(3, 5));
            Assert.That(measured[0].Step, Is.Zero, "the start is measured");
            Assert.That(measured[0].ParticleCount, Is.EqualTo(64));
            Assert.That(measured[1].Time - measured[0].Time, Is.EqualTo(0.03).Within(0.005), "three frames of 10 ms");
            Assert.That(measured[2].KineticEnergy, Is.Positive);
            Assert.That(measured[2].Energy - measured[0].Energy, Is.Zero.Within(0.01 * measured[2].KineticEnergy), "a fall");
            Assert.That(diagnostics.MeasurementCount, Is.EqualTo(measured.Count));
            Assert.That(diagnostics.Statistics, Is.EqualTo(measured.Last()));
        }

        [UnityTest]
        public IEnumerator HealthyLiquidIsNotWarnedAbout()
        {
            FluidSimulation simulation = rig.Create();
            FluidDiagnostics diagnostics = Watch(simulation, 2);
            yield return Frames(diagnostics, 40);
            Assert.That(diagnostics.MeasurementCount, Is.GreaterThan(10));
            Assert.That(simulation.Messages.Select(m => m.ToString()), Is.Empty);
            Assert.That(diagnostics.Findings.Select(f => f.Failure), Is.EqualTo(new[] { FluidFailure.NumericalViscosity }),
                "true of thin liquids, shown but no warning");
        }

        [UnityTest]
        public IEnumerator FailureIsReportedOnceWithItsCure()
        {
            FluidSimulation simulation = rig.Create();
            simulation.Method = FluidMethodKind.Thesis;
            rig.Profile.ViscosityRatio = 0f;
            var reported = new List<FluidMessage>();
            var found = new List<FluidFinding>();
            simulation.Reported += reported.Add;
            FluidDiagnostics diagnostics = Watch(simulation, 1);
            diagnostics.Found += found.Add;
            LogAssert.Expect(LogType.Warning,
                new System.Text.RegularExpressions.Regex("'Fluid': The kinematic viscosity .*Viscosity Ratio"));
            yield return Frames(diagnostics, 8);
            Assert.That(found.Select(f => f.Failure), Is.EqualTo(new[] { FluidFailure.KernelMismatch }));
            FluidMessage message = reported.Single();
            Assert.That(message.Issue, Is.EqualTo(FluidIssue.Diagnosis));
            Assert.That(message.Severity, Is.EqualTo(FluidSeverity.Warning));
            Assert.That(message.Cure, Does.Contain("Viscosity Ratio"));
            Assert.That(diagnostics.Findings.Count, Is.EqualTo(1));

            rig.Profile.ViscosityRatio = 0.01f;
            yield return Frames(diagnostics, 5);
            Assert.That(diagnostics.Findings.Select(f => f.Failure), Has.No.Member(FluidFailure.KernelMismatch), "the cure helps at once");
        }

        [UnityTest]
        public IEnumerator MovedColliderDoesWork()
        {
            FluidSimulation simulation = rig.Create();
            simulation.UseSceneGravity = false;
            simulation.Gravity = Vector3.zero;
            simulation.ExpectedSpeed = 1f;
            GameObject pusher = rig.NewObject("Pusher");
            pusher.AddComponent<BoxCollider>().size = new Vector3(0.05f, 0.4f, 0.4f);
            pusher.transform.position = new Vector3(-0.16f, 0f, 0f);
            FluidDiagnostics diagnostics = Watch(simulation, 1);
            yield return Frames(diagnostics, 3);
            double energy = diagnostics.Statistics.Energy;
            for (int frame = 0; frame < 20; frame++)
            {
                pusher.transform.position += new Vector3(0.006f, 0f, 0f);
                yield return null;
                AsyncGPUReadback.WaitAllRequests();
                Assert.That(diagnostics.Findings.Select(f => f.Failure), Has.No.Member(FluidFailure.EnergyGrowth));
            }
            double mass = simulation.ParticleCount * (double)simulation.Solver.Settings.ParticleMass;
            Assert.That(diagnostics.Statistics.Energy - energy, Is.GreaterThan(2.0 * FluidGrowth(simulation, mass)),
                "it would count if nothing had moved");
        }

        [UnityTest]
        public IEnumerator RestartStopAndDestroyAreFollowed()
        {
            FluidSimulation simulation = rig.Create();
            FluidDiagnostics diagnostics = Watch(simulation, 1);
            yield return Frames(diagnostics, 5);
            Assert.That(diagnostics.Statistics.Step, Is.Positive);

            simulation.ResetSimulation();
            yield return null;
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(diagnostics.MeasurementCount, Is.EqualTo(1), "of the new run");

            simulation.StopSimulation();
            yield return null;
            AsyncGPUReadback.WaitAllRequests();
            Assert.That(diagnostics.MeasurementCount, Is.Zero);
            Assert.That(diagnostics.Findings, Is.Empty);

            simulation.StartSimulation();
            yield return Frames(diagnostics, 3);
            Assert.That(diagnostics.MeasurementCount, Is.Positive);
            diagnostics.enabled = false;
            Assert.That(diagnostics.MeasurementCount, Is.Zero);
            diagnostics.enabled = true;
            yield return null;
            Object.DestroyImmediate(simulation.gameObject);
            AsyncGPUReadback.WaitAllRequests();
            yield return null;
        }

        [UnityTest]
        public IEnumerator EachSimulationHasItsOwn()
        {
            FluidSimulation still = rig.Create("Still");
            still.UseSceneGravity = false;
            still.Gravity = Vector3.zero;
            FluidDiagnostics first = Watch(still, 1);
            FluidSimulation falling = rig.Create("Falling", position: new Vector3(3f, 0f, 0f));
            falling.Spacing = 0.04f;
            FluidDiagnostics second = Watch(falling, 1);
            yield return Frames(first, 8);
            Assert.That(first.Statistics.ParticleCount, Is.EqualTo(64));
            Assert.That(second.Statistics.ParticleCount, Is.EqualTo(125));
            Assert.That(second.Statistics.KineticEnergy, Is.GreaterThan(10.0 * first.Statistics.KineticEnergy));
        }

        [UnityTest]
        public IEnumerator MissingShaderIsReportedAndTheLiquidRuns()
        {
            FluidSimulation simulation = rig.Create();
            FluidShaderSet set = TestShaders.Without(rig.Profile.Shaders, "MeasureStatistics");
            rig.Profile.Shaders = set;
            FluidDiagnostics diagnostics = Watch(simulation, 1);
            LogAssert.Expect(LogType.Warning, new System.Text.RegularExpressions.Regex("MeasureStatistics.*without diagnostics"));
            yield return Frames(diagnostics, 5);
            Assert.That(simulation.IsRunning);
            Assert.That(simulation.StepCount, Is.Positive);
            Assert.That(simulation.Messages.Count, Is.EqualTo(1));
            Assert.That(diagnostics.MeasurementCount, Is.Zero);
            Object.DestroyImmediate(set);
        }

        [TestCase(true, false, false, true)]
        [TestCase(false, true, false, true)]
        [TestCase(false, false, false, false)]
        [TestCase(false, false, true, true)]
        public void ReleasePlayersMeasureWhereAskedTo(bool editor, bool development, bool requested, bool runs)
        {
            Assert.That(FluidDiagnostics.RunsIn(editor, development, requested), Is.EqualTo(runs));
        }

        // Half of the limit: a twentieth of nothing, and motion at a fiftieth of the speed of sound.
        private static double FluidGrowth(FluidSimulation simulation, double mass)
        {
            double quiet = 0.02 * simulation.Solver.Settings.SoundSpeed;
            return 0.25 * mass * quiet * quiet;
        }

        private static FluidDiagnostics Watch(FluidSimulation simulation, int interval)
        {
            var diagnostics = simulation.gameObject.AddComponent<FluidDiagnostics>();
            diagnostics.Interval = interval;
            return diagnostics;
        }

        private static IEnumerator Frames(FluidDiagnostics diagnostics, int count)
        {
            Assert.That(diagnostics.Runs, Is.True, "in the Editor");
            for (int frame = 0; frame < count; frame++)
            {
                yield return null;
                AsyncGPUReadback.WaitAllRequests();
            }
        }
    }
}
