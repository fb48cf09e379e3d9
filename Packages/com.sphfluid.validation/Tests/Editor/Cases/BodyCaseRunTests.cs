using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Runs with bodies that move, and what their metrics are told.</summary>
    public sealed class BodyCaseRunTests
    {
        private FluidShaderSet shaders;

        [SetUp]
        public void LoadShaders() => shaders = SurfaceTestScene.LoadShaders();

        [Test]
        public void MetricsAreToldWhereBodiesAre()
        {
            CaseSetup setup = Pool("standard");
            setup.Bodies = new[] { Body(0.2f, 5f, null), Body(-0.2f, 0f, t => 0.3f * (float)t * Vector3.up) };
            var watch = new Watch();
            using (var run = new CaseRun(setup, watch, shaders))
                Assert.That(run.RunToEnd().Failure, Is.Null);

            Assert.That(watch.Places, Has.Count.EqualTo(watch.Samples));
            Vector3[] start = watch.Places[0], end = watch.Places.Last();
            Assert.That(start[0], Is.EqualTo(setup.Bodies[0].Centre));
            double seconds = watch.Times.Last();
            Assert.That(end[0].y - start[0].y, Is.EqualTo(-0.5 * 9.81 * seconds * seconds).Within(2).Percent, "the first falls freely");
            Assert.That(end[1].y - start[1].y, Is.EqualTo(0.3 * seconds).Within(1e-5), "the second goes its path");
        }

        [Test]
        public void ALiquidIsPushedByABodyOnAPath([Values("thesis", "standard")] string method)
        {
            CaseSetup setup = Pool(method);
            CaseBody plate = Body(0f, 0f, t => 0.5f * (float)t * Vector3.right);
            plate.Mesh = TriangleMesh.Box(Matrix4x4.Scale(new Vector3(0.2f, 2f, 2f)));
            plate.Centre = new Vector3(-0.25f, 0f, 0f);
            setup.Bodies = new[] { plate };
            setup.Duration = 0.2;
            var watch = new Watch();
            using (var run = new CaseRun(setup, watch, shaders))
                Assert.That(run.RunToEnd().Failure, Is.Null);

            Assert.That(watch.End.LocalPositions.Min(p => p.x), Is.GreaterThan(-0.15f + 0.1f - 0.02f), "none is behind the plate");
        }

        [Test]
        public void LiquidInABodyIsAFailure()
        {
            CaseSetup setup = Pool("standard");
            setup.Bodies = new[] { Body(0f, 0f, t => Vector3.zero) };
            var failure = new CaseFailure(setup);
            FluidSnapshot state = CaseStates.State(setup.Particles);
            Vector3 far = 3f * Vector3.up, within = setup.Particles[0].Position;

            Assert.That(failure.Of(state, new CaseReadings(new[] { far })), Is.Null);
            Assert.That(failure.Of(state, new CaseReadings(new[] { within })), Does.Contain("beyond a wall"));
        }

        [Test]
        public void WhatCannotMoveIsRefused()
        {
            CaseSetup setup = Pool("standard");
            setup.Bodies = new[] { Body(0f, 0f, null) };
            Assert.That(() => new CaseRun(setup, new Watch(), shaders), Throws.ArgumentException.With.Message.Contains("path nor a mass"));
            CaseSetup thesis = Pool("thesis");
            thesis.Bodies = new[] { Body(0f, 5f, null) };
            Assert.That(() => new CaseRun(thesis, new Watch(), shaders), Throws.ArgumentException.With.Message.Contains("moves no bodies"));
            setup.Bodies = new[] { new CaseBody { Mass = 1f } };
            Assert.That(() => new CaseRun(setup, new Watch(), shaders), Throws.ArgumentException.With.Message.Contains("not closed"));
        }

        // Above the pool of 0.1 m depth in a domain of a metre.
        private static CaseBody Body(float x, float mass, Func<double, Vector3> path) => new CaseBody
        {
            Mesh = TriangleMesh.Box(Matrix4x4.Scale(0.12f * Vector3.one)),
            Centre = new Vector3(x, 0.2f, 0f),
            Mass = mass,
            Path = path,
        };

        private static CaseSetup Pool(string method)
        {
            var parameters = CaseParameters.At(CaseMethod.Find(method), 4, 5.0);
            var counts = new Vector3Int(8, 4, 6);
            List<Vector3> water = CaseLattice.Box(counts, 0.025, new Vector3(-0.15f, -0.5f, -0.075f));
            return new CaseSetup
            {
                Settings = CaseSettings.For(parameters, Vector3.one, 0.025, 1.5, new Vector3(0f, -9.81f, 0f)),
                Particles = CaseLattice.Particles(water),
                Duration = 0.1,
                SampleInterval = 0.01,
            };
        }

        private sealed class Watch : CaseMetric
        {
            public readonly List<Vector3[]> Places = new List<Vector3[]>();
            public readonly List<double> Times = new List<double>();
            public int Samples;
            public FluidSnapshot End;

            public override void Read(double time, CaseReadings readings)
            {
                Places.Add(readings.Bodies.ToArray());
                Times.Add(time);
            }

            public override void Sample(double time, FluidSnapshot state)
            {
                Samples++;
                End = state;
            }

            public override IReadOnlyList<CaseError> Evaluate() => Array.Empty<CaseError>();
        }
    }
}
