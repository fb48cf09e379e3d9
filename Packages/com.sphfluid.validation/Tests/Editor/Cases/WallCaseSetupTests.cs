using System;
using System.Collections.Generic;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class WallCaseSetupTests
    {
        private static IEnumerable<ValidationCase> Cases()
        {
            yield return new HydrostaticCase();
            yield return new StandingWaveCase();
            yield return new PoiseuilleCase();
            yield return new CouetteCase();
        }

        [Test]
        public void SetupsCanBeRun([ValueSource(nameof(Cases))] ValidationCase flow, [Values(2.0, 2.5, 4.0)] double supportRatio)
        {
            foreach (CaseMethod method in CaseMethod.All)
            {
                CaseParameters parameters = flow.Base(method);
                parameters.SupportRatio = supportRatio;
                CaseSetup setup = flow.Build(parameters);
                setup.Settings.Validate();
                FluidSolverSettings used = setup.Settings;
                used.OctantSearch = method.Kind == FluidMethodKind.ThesisPrinted;
                Assert.DoesNotThrow(() => FluidGrid.For(used), method.Name);
                FluidSolver.CheckParticles(setup.Settings, setup.Particles);
                CaseMetric metric = flow.CreateMetric(parameters, setup);
                Assert.That(metric.Evaluate()[0].Name, Is.EqualTo(flow.ErrorName));
            }
        }

        [Test]
        public void TheFluidFillsWhatItShould()
        {
            CaseParameters parameters = new HydrostaticCase().Base(CaseMethod.Find("thesis"));
            Assert.That(new HydrostaticCase().Build(parameters).Particles.Length, Is.EqualTo(8 * 8 * 20));

            // The walls are at whole spacings: half a spacing from each to its layer, up to five deviations of the jitter.
            CaseSetup channel = new CouetteCase().Build(new CouetteCase().Base(CaseMethod.Find("thesis")));
            float lowest = 1, highest = -1;
            foreach (FluidParticle particle in channel.Particles)
            {
                lowest = Mathf.Min(lowest, particle.Position.y);
                highest = Mathf.Max(highest, particle.Position.y);
            }
            Assert.That(lowest, Is.EqualTo(-0.5f + 0.5f / 16).Within(0.05f / 16));
            Assert.That(highest, Is.EqualTo(0.5f - 0.5f / 16).Within(0.05f / 16));
            Assert.That(channel.Particles.Length, Is.EqualTo(16 * 6 * 6));
            Assert.That(channel.Settings.Viscosity, Is.EqualTo(0.01f * channel.Settings.RestDensity).Within(1e-4f));
            Assert.That(channel.Settings.SoundSpeed, Is.EqualTo(1f).Within(1e-4f));
        }

        [Test]
        public void TheWaveStartsWithItsAmplitudeAndAtRest()
        {
            var flow = new StandingWaveCase();
            CaseParameters parameters = flow.Base(CaseMethod.Find("thesis"));
            CaseSetup setup = flow.Build(parameters);
            CaseMetric metric = flow.CreateMetric(parameters, setup);
            metric.Sample(0, WallCaseStates.State(setup.Particles.Length, i => setup.Particles[i].Position));

            Assert.That(metric.Series()[1].Y[0], Is.EqualTo(1).Within(0.02), "over the start's amplitude");
            Assert.That(StandingWaveCase.Frequency, Is.EqualTo(1.769).Within(5e-4));
            Assert.That(setup.Particles[7].VelT0, Is.EqualTo(Vector3.zero));
        }

        [Test]
        public void ColumnsAtRestAreCompressedByWhatIsAbove()
        {
            const double M = 25;
            Assert.That(WallCaseSetup.Settled(0, 1, M), Is.Zero.Within(1e-12));
            Assert.That(WallCaseSetup.Settled(1, 1, M), Is.EqualTo(HydrostaticMetric.HeightRatio(M)).Within(1e-12));
            double atFloor = WallCaseSetup.Settled(1e-6, 1, M) / 1e-6;
            Assert.That(1 / atFloor, Is.EqualTo(1 + 1 / M).Within(1e-5), "ρ/ρ0 = 1 + gH/c² at the floor");
        }

        [Test]
        public void WhatCannotBeRunIsRefused([ValueSource(nameof(Cases))] ValidationCase flow)
        {
            CaseParameters coarse = flow.Base(CaseMethod.Find("thesis"));
            coarse.Resolution = 3;
            Assert.That(() => flow.Build(coarse),
                Throws.ArgumentException.With.Message.Contains(flow.Name).And.Message.Contains("resolution is 3"));
            CaseParameters shaken = flow.Base(CaseMethod.Find("thesis"));
            shaken.Jitter = 1;
            Assert.That(() => flow.Build(shaken), Throws.ArgumentException.With.Message.Contains("jitter"));
        }
    }
}
