using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Laboratory;
using SphFluid.Validation;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A run shows a metric the solver's own states at the right times, and ends when it should.</summary>
    public sealed class CaseRunTests
    {
        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => UnityEngine.Object.DestroyImmediate(shaders);

        [Test]
        public void SamplesAreTheSolversStatesAtTheirTimes()
        {
            CaseSetup setup = CaseStates.Block(0.1, 0.03);
            double dt = setup.Settings.TimeStep;
            CaseResult result = Run(setup, out CaseStates.Recorder metric);

            var schedule = new CaseSchedule(0.1, 0.03, dt);
            Assert.That(result.Failure, Is.Null);
            Assert.That(result.Errors[0].Value, Is.EqualTo(5), "0, 0.03, 0.06, 0.09, 0.1 s");
            Assert.That(result.Steps, Is.EqualTo(schedule.LastStep));
            Assert.That(result.SimulatedSeconds, Is.EqualTo(schedule.LastStep * dt).Within(1e-9));
            Assert.That(result.Particles, Is.EqualTo(125));
            Assert.That(result.GpuMsPerSecond, Is.NaN);
            Assert.That(result.CpuMsPerSecond, Is.Positive);
            using (var solver = new FluidSolver(setup.Settings, shaders, setup.Particles))
            {
                long step = 0;
                for (int sample = 0; sample < metric.Times.Count; sample++)
                {
                    Assert.That(metric.Times[sample], Is.EqualTo(step * dt).Within(1e-9));
                    Assert.That(metric.States[sample].Hash, Is.EqualTo(FluidSnapshot.Read(solver).Hash), $"sample {sample}");
                    int missing = (int)(schedule.Next(step) - step);
                    GpuTest.Run(cmd => solver.RecordSteps(cmd, missing));
                    step += missing;
                }
            }
        }

        [Test]
        public void WhatIsTimedIsTheWorkOfTheStepsAndAllOfIt()
        {
            CaseSetup setup = CaseStates.Block(1, 1);
            long before = 0;
            long Dispatches()
            {
                long count = GpuLaboratory.DispatchesRecorded - before;
                before += count;
                return count;
            }

            using (var solver = new FluidSolver(setup.Settings, shaders, setup.Particles))
            using (var stepper = new CaseStepper(solver, false))
            {
                FluidSnapshot.Read(solver);
                Dispatches();
                stepper.Step(1);
                long step = Dispatches();
                FluidSnapshot.Read(solver);
                Assert.That(Dispatches(), Is.Zero, "a sample finds the neighbours of the last step");
                stepper.Step(1);
                Assert.That(Dispatches(), Is.EqualTo(step), "a step after a sample does no less");
                long steps = solver.StepCount;
                stepper.Step(1000);
                Assert.That(Dispatches(), Is.EqualTo((solver.StepCount - steps) * step));
                Assert.That(solver.StepCount - steps,
                    Is.EqualTo(CaseStepper.MostAtOnce(setup.Settings, setup.Particles.Length, FluidSupport.IsSoftwareDevice)),
                    "by no clock");
                Assert.That(step, Is.EqualTo(10 + 8), "10 sorts and the 8 other blocks");
            }
        }

        [TestCase(0, 2.0, true, 250)]
        [TestCase(249000, 2.0, true, 1)]
        [TestCase(24000, 2.0, true, 10)]
        [TestCase(24000, 1.7, true, 10)]
        [TestCase(24000, 4.0, true, 1)]
        [TestCase(10000000, 2.0, true, 1)]
        [TestCase(24000, 2.0, false, 320)]
        [TestCase(500, 2.0, false, 512)]
        public void ASubmissionHasWorkOfAQuarterOfASecondOrOneStep(int particles, double supportRatio, bool software, int steps)
        {
            FluidSolverSettings settings = default;
            settings.Spacing = 0.5f;
            settings.SupportRadius = (float)(0.5 * supportRatio);

            Assert.That(CaseStepper.MostAtOnce(settings, particles, software), Is.EqualTo(steps));
        }

        [Test]
        public void EqualSeedsGiveEqualRuns()
        {
            Run(CaseStates.Block(0.06, 1), out CaseStates.Recorder first);
            Run(CaseStates.Block(0.06, 1), out CaseStates.Recorder second);

            Assert.That(second.States.Last().Hash, Is.EqualTo(first.States.Last().Hash));
        }

        // The block starts 0.2 m above the middle of the box, where the obstacle's top is at 0.1 m.
        [TestCase(true)]
        [TestCase(false)]
        public void ObstaclesStopTheLiquid(bool there)
        {
            CaseSetup setup = CaseStates.Block(0.4, 0.4);
            if (there) setup.Obstacles = new[] { CaseStates.BoxCorners(new Vector3(0, 0.05f, 0), new Vector3(0.9f, 0.1f, 0.9f)) };
            Run(setup, out CaseStates.Recorder metric);

            float lowest = metric.States.Last().LocalPositions.Min(p => p.y);
            Assert.That(lowest, there ? Is.InRange(0.09f, 0.15f) : Is.LessThan(0f));
        }

        [Test]
        public void OpenAndHalfObstaclesAreErrors()
        {
            CaseSetup setup = CaseStates.Block(1, 1);
            Vector3[] box = CaseStates.BoxCorners(Vector3.zero, 0.1f * Vector3.one);
            setup.Obstacles = new[] { box.Skip(3).ToArray() };
            Assert.That(() => Run(setup, out _), Throws.ArgumentException.With.Message.Contains("not closed"));
            setup.Obstacles = new[] { box.Skip(1).ToArray() };
            Assert.That(() => Run(setup, out _), Throws.ArgumentException.With.Message.Contains("three a triangle"));
        }

        [Test]
        public void TheMetricEndsTheRun()
        {
            CaseResult result = Run(CaseStates.Block(0.1, 0.03), out CaseStates.Recorder metric, 2);

            Assert.That(result.Failed);
            Assert.That(result.Failure, Does.StartWith("the cup is empty, at 0.0"));
            Assert.That(metric.Times, Has.Count.EqualTo(3));
            Assert.That(result.SimulatedSeconds, Is.EqualTo(0.06).Within(0.002));
            Assert.That(result.Errors, Is.Empty);
        }

        [Test]
        public void AStartWithNumbersThatAreNoneIsNotRun()
        {
            CaseSetup setup = CaseStates.Block(0.5, 0.5);
            setup.Particles[11].VelT0 = new Vector3(float.NaN, 0, 0);
            CaseResult result = Run(setup, out CaseStates.Recorder metric);

            Assert.That(result.Failure, Does.Contain("particle 11"));
            Assert.That(metric.Times, Is.Empty, "no metric sees such a state");
            Assert.That(result.Steps, Is.Zero);
        }

        [Test]
        public void CountedNumbersThatAreNoneEndTheRunBetweenSamples()
        {
            CaseSetup setup = CaseStates.Block(0.5, 0.5);
            setup.Settings.Viscosity = 1e38f; // times the kernel's constant it is infinite
            CaseResult result = Run(setup, out CaseStates.Recorder metric);

            Assert.That(result.Failure, Does.Contain("were not finite"));
            Assert.That(metric.Times, Has.Count.EqualTo(1));
            Assert.That(result.SimulatedSeconds, Is.LessThan(0.5));
        }

        [Test]
        public void ATimedRunCannotEndAtOnce()
        {
            using (var run = new CaseRun(CaseStates.Block(1, 1), new CaseStates.Recorder(), shaders, true))
                Assert.That(() => run.RunToEnd(), Throws.InvalidOperationException.With.Message.Contains("Run"));
        }

        [UnityTest]
        public IEnumerator GpuTimesAreThoseOfTheSteps()
        {
            if (!SystemInfo.supportsGpuRecorder)
            {
                Assert.Ignore($"{SystemInfo.graphicsDeviceName} ({SystemInfo.graphicsDeviceType}) has no GPU times.");
            }
            CaseSetup setup = CaseStates.Block(0.1, 0.02);
            using (var run = new CaseRun(setup, new CaseStates.Recorder(), shaders, true))
            {
                var work = new SessionWork(run.Run());
                while (work.Step()) yield return null;
                Assert.That(run.Result.Failure, Is.Null);
                Assert.That(run.Result.Errors[0].Value, Is.EqualTo(6));
                Assert.That(run.Result.GpuMsPerSecond, Is.Positive.And.Not.EqualTo(double.PositiveInfinity));
                Assert.That(run.Result.CpuMsPerSecond, Is.Positive);
            }
        }

        private CaseResult Run(CaseSetup setup, out CaseStates.Recorder metric, int failAt = -1)
        {
            metric = new CaseStates.Recorder { FailAt = failAt };
            using (var run = new CaseRun(setup, metric, shaders))
                return run.RunToEnd();
        }
    }
}
