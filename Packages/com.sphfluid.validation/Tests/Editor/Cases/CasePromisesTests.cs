using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What each case says of itself, which its metric and its chart must keep.</summary>
    public sealed class CasePromisesTests
    {
        private static IEnumerable<ValidationCase> Charted() => CaseCatalogue.All.Where(c => !c.IsGate);

        [Test]
        public void AFloorHasASource([ValueSource(nameof(Charted))] ValidationCase charted) =>
            Assert.That(charted.FloorSource.Length > 0, Is.EqualTo(charted.Floor > 0.0));

        [Test]
        public void WhatIsAlsoHeldIsAnErrorOfTheMetric([ValueSource(nameof(Charted))] ValidationCase charted)
        {
            CaseParameters parameters = charted.Base(CaseMethod.Find("standard"));
            CaseSetup setup = charted.Build(parameters);
            CaseMetric metric = charted.CreateMetric(parameters, setup);
            FluidSnapshot start = WallCaseStates.State(setup.Particles.Length, i => setup.Particles[i].Position,
                i => setup.Particles[i].VelT0);
            var readings = new CaseReadings(setup.Bodies.Select(_ => Vector3.zero).ToArray(), new double[setup.Patches.Count]);
            foreach (double time in new[] { 0.0, setup.SampleInterval })
            {
                metric.Read(time, readings);
                metric.Sample(time, start);
            }
            string[] names = metric.Evaluate().Select(e => e.Name).ToArray();

            Assert.That(charted.AlsoHeld, Is.Not.Empty);
            Assert.That(charted.AlsoHeld.Select(h => h.Name), Is.SubsetOf(names));
            Assert.That(charted.AlsoHeld.Select(h => h.Name), Does.Not.Contain(charted.ErrorName));
        }
    }
}
