using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class ImpactCaseTests
    {
        [Test]
        public void TheColumnStartsAsTheExperiments([Values(7, 16)] int resolution, [Values(1.9, 2.0, 2.5)] double supportRatio)
        {
            var damBreak = new DamBreakCase();
            CaseParameters parameters = Parameters(damBreak, "thesis", resolution, 0.0);
            parameters.SupportRatio = supportRatio;
            CaseSetup setup = damBreak.Build(parameters);
            CaseMetric metric = damBreak.CreateMetric(parameters, setup);
            metric.Sample(0.0, Start(setup));

            double a = MartinMoyce.Width, dx = setup.Settings.Spacing;
            Assert.That(dx, Is.EqualTo(a / resolution).Within(1e-8));
            Assert.That(metric.Series()[2].Y[0], Is.EqualTo(1.0).Within(1e-5));
            // c² = 25 · 2 g · 2a = 50 g · 2a: it stands 1/100 lower at first order, 50 ln 1.02 = 0.9901, and the top layer is not
            // compressed.
            Assert.That(metric.Series().Last().Y[0], Is.EqualTo(50.0 * System.Math.Log(1.02)).Within(0.02 / resolution));
            Assert.That(setup.Particles.Length * dx * dx * dx, Is.EqualTo(2.0 * a * a * setup.Settings.DomainSize.z).Within(1e-5).Percent);
            Assert.That(setup.Settings.DomainSize.z, Is.GreaterThanOrEqualTo(3f * setup.Settings.SupportRadius * 0.99999f));
            Assert.That(setup.Settings.DomainSize.z, Is.LessThan(3.0 * setup.Settings.SupportRadius + dx));
            Assert.That(setup.Settings.SoundSpeed, Is.EqualTo(5.0 * System.Math.Sqrt(4.0 * 9.81 * a)).Within(1e-4));
            Assert.That(setup.Duration * System.Math.Sqrt(2.0 * 9.81 / a), Is.GreaterThan(3.33 + DamBreakMetric.LargestShift));
        }

        [Test]
        public void MarinsWaterStartsAsTheRecord([Values(5, 10, 13)] int resolution)
        {
            var marin = new MarinCase();
            CaseParameters parameters = Parameters(marin, "thesis", resolution, 0.0);
            CaseSetup setup = marin.Build(parameters);
            CaseMetric metric = marin.CreateMetric(parameters, setup);
            metric.Sample(0.0, Start(setup));

            Assert.That(metric.Series()[7].Y[0], Is.EqualTo(0.55).Within(2.5).Percent);
            Assert.That(metric.Series().Where((series, i) => i == 1 || i == 3 || i == 5).Select(series => series.Y[0]), Is.All.Zero);
            double dx = setup.Settings.Spacing;
            Assert.That(setup.Particles.Length * dx * dx * dx, Is.EqualTo(1.228 * 0.55).Within(1e-3).Percent);
            Assert.That(setup.Particles.Min(p => p.Position.x), Is.InRange(1.992 - 1.61, 1.992 - 1.61 + 0.6 * dx));
            Assert.That(setup.Particles.Max(p => p.Position.x), Is.InRange(1.61 - 0.6 * dx, 1.61));
            Assert.That(setup.Particles.Max(p => p.Position.y), Is.InRange(0.05 - 0.6 * dx, 0.05));
            Assert.That(setup.Particles.Max(p => p.Position.z), Is.InRange(0.5 - 0.6 * dx, 0.5));
        }

        [Test]
        public void MarinsBoxIsWhereTheDrawingHasIt()
        {
            var marin = new MarinCase();
            Vector3[] corners = marin.Build(marin.Base(CaseMethod.Find("thesis"))).Obstacles.Single();

            double volume = 0;
            for (int i = 0; i < corners.Length; i += 3)
            {
                volume += Vector3.Dot(corners[i], Vector3.Cross(corners[i + 1], corners[i + 2])) / 6.0;
            }
            // Positive: the faces look outward.
            Assert.That(volume, Is.EqualTo(0.161 * 0.161 * 0.403).Within(1e-5));
            Assert.That(corners.Min(c => c.x) + 1.61, Is.EqualTo(0.744 - 0.0805).Within(1e-6));
            Assert.That(corners.Max(c => c.x) + 1.61, Is.EqualTo(0.744 + 0.0805).Within(1e-6));
            Assert.That(corners.Min(c => c.y) + 0.5, Is.Zero.Within(1e-6));
            Assert.That(corners.Max(c => c.z), Is.EqualTo(0.2015).Within(1e-6));
        }

        [Test]
        public void SeedsGiveDifferentStarts()
        {
            foreach (ValidationCase validationCase in new ValidationCase[] { new DamBreakCase(), new MarinCase() })
            {
                CaseParameters parameters = Parameters(validationCase, "thesis", 5, 0.01);
                Vector3 first = validationCase.Build(parameters).Particles[7].Position;
                Assert.That(validationCase.Build(parameters).Particles[7].Position, Is.EqualTo(first));
                parameters.Seed = 2;
                Assert.That(validationCase.Build(parameters).Particles[7].Position, Is.Not.EqualTo(first));
            }
        }

        [Test]
        public void WhatCannotRunIsNamed()
        {
            foreach (ValidationCase validationCase in new ValidationCase[] { new DamBreakCase(), new MarinCase() })
            {
                CaseParameters parameters = Parameters(validationCase, "thesis", 3, 0.01);
                Assert.That(() => validationCase.Build(parameters), Throws.ArgumentException.With.Message.Contains(validationCase.Name));
            }
        }

        internal static CaseParameters Parameters(ValidationCase validationCase, string method, int resolution, double jitter)
        {
            CaseParameters parameters = validationCase.Base(CaseMethod.Find(method));
            parameters.Resolution = resolution;
            parameters.Jitter = jitter;
            return parameters;
        }

        private static FluidSnapshot Start(CaseSetup setup) => ImpactCaseStates.State(setup.Particles.Select(p => p.Position).ToList());
    }
}
