using System;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// The gates and the ellipsoid on the GPU, coarse: what the thesis method is known to give, and what its printed form does not.
    /// </summary>
    public sealed class GateRunTests
    {
        private FluidShaderSet shaders;

        [SetUp]
        public void CreateShaders() => shaders = TestShaders.CreateSet();

        [TearDown]
        public void DestroyShaders() => UnityEngine.Object.DestroyImmediate(shaders);

        [TestCase(2.0)]
        [TestCase(2.5)]
        public void WhatFallsFreelyKeepsItsShape(double supportRatio)
        {
            CaseResult result = Run(new FreeFallCase(), CaseStates.Thesis, 6, supportRatio);

            Assert.That(result.Failure, Is.Null);
            Assert.That(result.Errors[0].Value, Is.LessThan(new FreeFallCase().Limit));
        }

        [Test]
        public void ThePrintedDensityContractsWhatFalls()
        {
            CaseResult result = Run(new FreeFallCase(), CaseStates.Printed, 6);
            Assert.That(result.Failed || result.Errors[1].Value > 0.1, "by a tenth of a spacing or more");
        }

        [Test]
        public void MomentumStays()
        {
            CaseResult result = Momentum(CaseStates.Thesis, 200);

            Assert.That(result.Failure, Is.Null);
            Assert.That(result.Errors[0].Value, Is.LessThan(0.2 * new MomentumCase().Limit), "a fifth of its steps");
        }

        [Test]
        public void ThePrintedForceLosesMomentum()
        {
            CaseResult result = Momentum(CaseStates.Printed, 200);
            Assert.That(result.Failed || result.Errors[0].Value > 1000 * new MomentumCase().Limit);
        }

        [Test]
        public void EnergyDoesNotGrow()
        {
            CaseResult result = Run(new EnergyCase(), CaseStates.Thesis, 8);

            Assert.That(result.Failure, Is.Null);
            Assert.That(result.Errors[0].Value, Is.LessThan(new EnergyCase().Limit));
            Assert.That(result.Errors[1].Value, Is.LessThan(0.3), "it has come to rest");
        }

        // What the corrected pressure works is taken from the density.
        [Test]
        public void EnergyFallsWithTheGradientCorrected()
        {
            CaseResult result = Run(new EnergyCase(), CaseMethod.Find("standard-corrected"), 8);

            Assert.That(result.Failure, Is.Null);
            Assert.That(result.Errors[0].Value, Is.LessThan(0.01));
        }

        [Test]
        public void TheEllipsoidSwings()
        {
            CaseResult result = Run(new EllipsoidCase(), CaseStates.Thesis, 4);

            Assert.That(result.Failure, Is.Null);
            Assert.That(result.Errors[0].Value, Is.InRange(0.08, 0.25), "0.16 at 4 particles in radius");
            Assert.That(result.Errors.Single(e => e.Name.StartsWith("first")).Value, Is.InRange(0.5, 0.9));
            Assert.That(result.Errors.Single(e => e.Name == "period, T/T_exact − 1").Value, Is.EqualTo(-0.05).Within(0.05));
        }

        [Test]
        public void ThePrintedEllipsoidHasNoStrengthToSwing()
        {
            CaseResult result = Run(new EllipsoidCase(), CaseStates.Printed, 4);
            Assert.That(result.Failed || result.Errors[0].Value > 0.3);
        }

        [Test]
        public void StartsFollowTheSeed()
        {
            Vector3[] Start(int seed)
            {
                CaseParameters parameters = new EllipsoidCase().Base(CaseStates.Thesis);
                parameters.Seed = seed;
                return new EllipsoidCase().Build(parameters).Particles.Select(p => p.Position).ToArray();
            }

            Assert.That(Start(1), Is.EqualTo(Start(1)));
            Assert.That(Start(2), Is.Not.EqualTo(Start(1)));
        }

        [Test]
        public void TheBallHasItsVolumeAndItsVelocities()
        {
            var ellipsoid = new EllipsoidCase();
            foreach (int resolution in new[] { 3, 5, 8 })
            {
                CaseParameters parameters = ellipsoid.Base(CaseStates.Thesis);
                parameters.Resolution = resolution;
                parameters.Jitter = 0;
                CaseSetup setup = ellipsoid.Build(parameters);
                double dx = setup.Settings.Spacing;

                Assert.That(setup.Particles.Length * dx * dx * dx, Is.EqualTo(4.0 / 3.0 * Math.PI).Within(1e-4).Percent);
                Assert.That(setup.Settings.SoundSpeed, Is.EqualTo(7.5f).Within(1e-4f));
                foreach (FluidParticle p in setup.Particles)
                {
                    Assert.That(Vector3.Distance(p.VelT0, new Vector3(-0.25f * p.Position.x, -0.25f * p.Position.y, 0.5f * p.Position.z)),
                        Is.LessThan(1e-6f));
                }
            }
        }

        [Test]
        public void AllCasesAreNamedOnceAndGatesHaveLimits()
        {
            Assert.That(CaseCatalogue.All.Select(c => c.Name), Is.Unique);
            foreach (ValidationCase validationCase in CaseCatalogue.All)
            {
                Assert.That(validationCase.Name, Does.Match("^[a-z]+(-[a-z]+)*$"));
                Assert.That(double.IsNaN(validationCase.Limit), Is.Not.EqualTo(validationCase.IsGate), validationCase.Name);
                foreach (CaseMethod method in CaseMethod.All.Where(m => !IsRefused(validationCase, m)))
                {
                    Assert.That(validationCase.Build(validationCase.Base(method)).Particles.Length, Is.InRange(100, 20000),
                        $"{validationCase.Name}, {method.Name}");
                }
            }
        }

        // A case names the method that cannot move floating bodies, sum the force on walls or hold a surface by tension.
        private static bool IsRefused(ValidationCase validationCase, CaseMethod method)
        {
            bool lacks = validationCase is HeaveCase ? method.Name.StartsWith("thesis") : validationCase is WallImpactCase
                ? !method.FeelsWalls
                : validationCase is CapillaryDropCase && !method.HasTension;
            if (lacks)
            {
                Assert.That(() => validationCase.Build(validationCase.Base(method)),
                    Throws.ArgumentException.With.Message.Contains(method.Name).Or.Message.Contains(method.Kind.ToString()),
                    $"{validationCase.Name}, {method.Name}");
            }
            return lacks;
        }

        [TestCase(2, 0.01, "resolution")]
        [TestCase(8, 0.5, "jitter")]
        public void WhatCannotBeRunIsNamed(int resolution, double jitter, string what)
        {
            foreach (ValidationCase validationCase in new ValidationCase[] { new EllipsoidCase(), new FreeFallCase(), new MomentumCase(),
                new EnergyCase() })
            {
                CaseParameters parameters = validationCase.Base(CaseStates.Thesis);
                parameters.Resolution = resolution;
                parameters.Jitter = jitter;
                Assert.That(() => validationCase.Build(parameters),
                    Throws.ArgumentException.With.Message.Contains(what).And.Message.Contains(validationCase.Name));
            }
        }

        private CaseResult Momentum(CaseMethod method, int steps)
        {
            var momentum = new MomentumCase();
            CaseParameters parameters = WallCaseRig.Coarse(momentum, method, 8);
            CaseSetup setup = momentum.Build(parameters);
            Assert.That(setup.Duration / setup.Settings.TimeStep, Is.EqualTo(1000.0).Within(1e-6), "of the case");
            setup.Duration = steps * (double)setup.Settings.TimeStep;
            CaseResult result = WallCaseRig.Run(momentum.Name, setup, momentum.CreateMetric(parameters, setup), shaders);
            Assert.That(result.Failed || result.Steps == steps);
            return result;
        }

        private CaseResult Run(ValidationCase validationCase, CaseMethod method, int resolution, double supportRatio = 2.0)
        {
            CaseParameters parameters = validationCase.Base(method);
            parameters.Resolution = resolution;
            parameters.SupportRatio = supportRatio;
            return WallCaseRig.Run(validationCase, parameters, shaders, out _);
        }
    }
}
