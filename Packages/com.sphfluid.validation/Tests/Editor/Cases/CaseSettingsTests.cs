using System;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The factors of the chart become constants of the solver.</summary>
    public sealed class CaseSettingsTests
    {
        private static readonly Vector3 Domain = 2 * Vector3.one;

        [TestCase(5.0)]
        [TestCase(12.0)]
        public void SoundSpeedIsTheRatioTimesTheSpeed(double ratio)
        {
            FluidSolverSettings settings = CaseSettings.For(At(ratio, 0.5), Domain, 0.1, 0.7, new Vector3(0, -9.81f, 0));

            Assert.That(settings.SoundSpeed, Is.EqualTo(0.7 * ratio).Within(1e-4).Percent);
            Assert.That(settings.TimeStep, Is.EqualTo(0.5 * 1.35 * 0.2 / Math.Sqrt(settings.Own<ThesisSettings>().Stiffness))
                .Within(1e-4).Percent, "dt = 0.5 · 1.35 R/√k");
            Assert.That(settings.OctantSearch, Is.False);
        }

        [Test]
        public void ViscosityIsExactOrTheMethodsLeast()
        {
            FluidSolverSettings exact = CaseSettings.For(At(10, 0.5), Domain, 0.1, 1, Vector3.zero, 0.002);
            FluidSolverSettings least = CaseSettings.For(At(10, 0.5), Domain, 0.1, 1, Vector3.zero);

            Assert.That(exact.Viscosity, Is.EqualTo(2f).Within(1e-5f));
            Assert.That(least.Viscosity, Is.EqualTo(0.01 * 10 * 0.2 * 1000).Within(1e-3), "0.01 c R ρ");
        }

        [Test]
        public void ThePrintedMethodShowsItsConstants()
        {
            CaseParameters parameters = At(10, 0.5);
            parameters.Method = CaseStates.Printed;
            FluidSolverSettings settings = CaseSettings.For(parameters, Domain, 0.1, 1, Vector3.zero);

            Assert.That(settings.Own<ThesisSettings>().SelfDensity, Is.False);
            Assert.That(settings.Own<ThesisSettings>().ForceTimesMass);
            Assert.That(settings.PressureClamp, Is.False);
            Assert.That(settings.OctantSearch);
        }

        [Test]
        public void APeriodicAxisThatIsTooShortIsAnError()
        {
            var boundaries = new FluidBoundaries { Periodic = FluidAxes.X };
            Assert.That(() => CaseSettings.For(At(10, 0.5), new Vector3(0.3f, 1, 1), 0.1, 1, Vector3.zero, null, boundaries),
                Throws.ArgumentException);
        }

        private static CaseParameters At(double ratio, double fraction) => new CaseParameters
        {
            Method = CaseStates.Thesis, Resolution = 10, SupportRatio = 2, SoundSpeedRatio = ratio, TimeStepFraction = fraction,
        };
    }
}
