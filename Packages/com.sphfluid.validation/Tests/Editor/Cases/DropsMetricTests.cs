using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The metric of two colliding drops on motions made by hand.</summary>
    public sealed class DropsMetricTests
    {
        private const int Count = 200;

        // The published force, summed by small steps; its peak is at t* = 0.15.
        [TestCase(0.1)]
        [TestCase(0.4)]
        [TestCase(0.8)]
        [TestCase(1.0)]
        public void TheReferenceLosesTheMomentumThatTheForceTakes(double time)
        {
            const int steps = 200000;
            double sum = 0.0;
            for (int i = 0; i < steps; i++)
            {
                double t = (i + 0.5) * time / steps;
                sum += Math.Sqrt(1000.0 * Math.PI * t / 243.0) * Math.Exp(-10.0 * t / 3.0) * time / steps;
            }

            Assert.That(DropsMetric.OnAPlate(time), Is.EqualTo(1.0 - sum / (Math.PI / 6.0)).Within(1e-5));
        }

        [Test]
        public void BeforeTheTouchAndLongAfterTheReferenceIsKnown()
        {
            Assert.That(DropsMetric.OnAPlate(-0.5), Is.EqualTo(1.0));
            Assert.That(DropsMetric.OnAPlate(10.0), Is.EqualTo(0.0).Within(1e-9));
        }

        [TestCase(0.0)]
        [TestCase(0.05)]
        public void TheErrorIsTheMomentums(double off)
        {
            DropsMetric metric = Metric();
            for (int i = 0; i <= 60; i++)
            {
                double time = 0.05 * i; // they touch at 1 s, D/U is 2 s
                double part = DropsMetric.OnAPlate((time - 1.0) / 2.0) + (time >= 1.0 ? off : 0.0);
                metric.Sample(time, State((float)(3.0 * part), Vector3.zero, Vector3.zero));
            }

            Assert.That(metric.Evaluate()[0].Value, Is.EqualTo(off).Within(1e-5));
            Assert.That(Named(metric, "shift"), Is.Zero);
            Assert.That(Named(metric, "|ΣΔmv|"), Is.LessThan(1e-7));
            Assert.That(Named(metric, "largest E/E0"), Is.LessThan(1e-6).Or.EqualTo(off).Within(1.0));
        }

        [Test]
        public void ARunThatEndsTooEarlyHasNoError()
        {
            DropsMetric metric = Metric();
            metric.Sample(0.0, State(3f, Vector3.zero, Vector3.zero));
            metric.Sample(2.0, State(2f, Vector3.zero, Vector3.zero));
            Assert.That(metric.Evaluate()[0].Value, Is.NaN);
        }

        [Test]
        public void WhatMustNotChangeIsMeasured()
        {
            DropsMetric metric = Metric();
            metric.Sample(0.0, State(3f, Vector3.zero, Vector3.zero));
            metric.Sample(1.0, State(3.3f, new Vector3(0f, 0.01f, 0f), new Vector3(0f, 0f, 0.3f)));
            metric.Sample(3.0, State(1.5f, Vector3.zero, Vector3.zero));
            Assert.That(Named(metric, "shift"), Is.EqualTo(0.2).Within(0.1).Percent, "0.01 m of 0.05 m");
            Assert.That(Named(metric, "|ΣΔmv|"), Is.EqualTo(0.1).Within(0.1).Percent, "0.3 of 3 m/s");
            Assert.That(Named(metric, "largest E/E0"), Is.EqualTo((3.3 * 3.3 + 0.3 * 0.3) / 9.0 - 1.0).Within(0.1).Percent);
            Assert.That(Named(metric, "E/E0 at the end"), Is.EqualTo(0.25).Within(0.1).Percent);
            Assert.That(Named(metric, "sheet"), Is.EqualTo(1.0).Within(0.1).Percent, "made twice as high as wide");
        }

        [Test]
        public void TheDropsAreApartAndTouchWhenTheySay()
        {
            var drops = new DropsCase();
            CaseParameters parameters = drops.Base(CaseMethod.Find("standard"));
            parameters.Jitter = 0.0;
            CaseSetup setup = drops.Build(parameters);
            float dx = setup.Settings.Spacing;
            FluidParticle[] left = setup.Particles.Take(setup.Particles.Length / 2).ToArray();
            Assert.That(left.All(p => p.Position.x < 0f && p.VelT0.x > 0f), "the first half is the left drop");
            Assert.That(setup.Particles.Skip(left.Length).All(p => p.Position.x > 0f && p.VelT0.x == -left[0].VelT0.x));
            float gap = -2f * left.Max(p => p.Position.x);
            Assert.That(gap, Is.GreaterThan(3f * setup.Settings.SupportRadius));
            Assert.That(gap - dx, Is.EqualTo(1f).Within(0.2f * dx), "between their surfaces");
            Assert.That(setup.Particles.Length * Math.Pow(dx, 3.0), Is.EqualTo(8.0 / 3.0 * Math.PI).Within(0.01).Percent);
        }

        private static double Named(CaseMetric metric, string start) => metric.Evaluate().Single(e => e.Name.StartsWith(start)).Value;

        private static DropsMetric Metric()
        {
            var settings = new FluidSolverSettings
            {
                Method = FluidMethodKind.Standard, Spacing = 0.05f, TimeStep = 0.001f,
                RestDensity = 1000f, ParticleMass = 1f, DomainSize = 100f * Vector3.one
            };
            return new DropsMetric(settings.WithOwn(new StandardSettings { SoundSpeed = 30f }), 3.0, 6.0, 1.0);
        }

        // Two rows twice as high as wide; the drops at ±u along x.
        private static FluidSnapshot State(float u, Vector3 shift, Vector3 velocity)
        {
            var particles = new FluidParticle[Count];
            for (int i = 0; i < Count; i++)
            {
                float side = i < Count / 2 ? -1f : 1f, at = i % (Count / 2) - 0.5f * (Count / 2 - 1);
                var position = new Vector3(side, 2f * at * (i % 2), 0f) + new Vector3(0f, 0f, at * (1 - i % 2));
                particles[i] = new FluidParticle(position + shift, new Vector3(-side * u, 0f, 0f) + velocity, (uint)i);
            }

            return CaseStates.State(particles);
        }
    }
}
