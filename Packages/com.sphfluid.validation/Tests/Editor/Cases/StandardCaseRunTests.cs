using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>What the Standard method is good for, case by case: coarse where the limit holds there too.</summary>
    public sealed class StandardCaseRunTests
    {
        private static readonly CaseMethod Standard = CaseMethod.Find("standard");

        [TestCase(2.25, 0.075)]
        [TestCase(2.5, 0.045)]
        public void TheEllipsoidSwings(double supportRatio, double limit)
        {
            var ellipsoid = new EllipsoidCase();
            CaseParameters parameters = Coarse(ellipsoid, 6);
            parameters.SupportRatio = supportRatio;
            Assert.That(Run(ellipsoid, parameters, out _), Is.LessThan(limit));
        }

        [Test]
        public void ChannelsStartUp()
        {
            foreach (ChannelCase channel in new ChannelCase[] { new PoiseuilleCase(), new CouetteCase() })
            {
                Assert.That(WallCaseRig.StartUpError(channel, Coarse(channel, 8)), Is.LessThan(0.03), channel.Name);
            }
        }

        [Test]
        public void TheColumnFalls()
        {
            var damBreak = new DamBreakCase();
            Assert.That(Run(damBreak, Coarse(damBreak, 8), out CaseMetric metric), Is.LessThan(MartinMoyce.Floor));
            Assert.That(WallCaseStates.Named(metric, "front, shift in T"), Is.InRange(-0.3, 0.0), "the gate held the experiment's back");
            Assert.That(WallCaseStates.Named(metric, "height, largest error"), Is.LessThan(0.06));
        }

        [Test]
        public void MarinsGaugesSeeTheWater()
        {
            var marin = new MarinCase();
            Run(marin, Coarse(marin, 5), out CaseMetric metric);
            foreach (CaseError error in metric.Evaluate())
            {
                if (error.Name.StartsWith("height at")) Assert.That(error.Value, Is.LessThan(0.35), error.Name);
            }
        }

        [TestCase(2.0)]
        [TestCase(2.5)]
        public void WhatFallsFreelyKeepsItsShape(double supportRatio)
        {
            var fall = new FreeFallCase();
            CaseParameters parameters = Coarse(fall, 7);
            parameters.SupportRatio = supportRatio;
            Assert.That(Run(fall, parameters, out _), Is.LessThan(fall.Limit));
        }

        [Test]
        public void MomentumStaysAndEnergyDoesNotGrow()
        {
            foreach (ValidationCase gate in new ValidationCase[] { new MomentumCase(), new EnergyCase() })
            {
                Assert.That(Run(gate, Coarse(gate, 8), out _), Is.LessThan(gate.Limit), gate.Name);
            }
        }

        [Test]
        public void DropsThatCollideSpreadAsOnAPlate()
        {
            var drops = new DropsCase();
            Assert.That(Run(drops, Coarse(drops, 6), out CaseMetric metric), Is.LessThan(0.05));
            Assert.That(WallCaseStates.Named(metric, DropsMetric.GrowthName), Is.LessThan(0.01));
            Assert.That(WallCaseStates.Named(metric, MomentumMetric.ErrorName), Is.LessThan(1e-5));
            Assert.That(WallCaseStates.Named(metric, "shift of the centre/dx"), Is.LessThan(1e-4));
            Assert.That(WallCaseStates.Named(metric, "sheet, height over width − 1"), Is.LessThan(0.02));
            Assert.That(WallCaseStates.Named(metric, "largest density error over U/c"), Is.LessThan(1.8));
            Assert.That(WallCaseStates.Named(metric, ParticleGapsMetric.ErrorName), Is.LessThan(3e-3));
        }

        [Test]
        public void ParticlesKeepApartInWaterThatSloshes()
        {
            var sloshing = new SloshingCase();
            CaseParameters parameters = Coarse(sloshing, 6);
            CaseSetup setup = sloshing.Build(parameters);
            setup.Duration = 2.4; // the block has fallen over, run up the other wall and come back
            CaseMetric metric = sloshing.CreateMetric(parameters, setup);
            CaseResult result = WallCaseRig.Run(sloshing.Name, setup, metric, SurfaceTestScene.LoadShaders());
            Assert.That(result.Failure, Is.Null);
            Assert.That(result.Errors[0].Value, Is.LessThan(3e-3), "one pair of 864");
            Assert.That(WallCaseStates.Named(metric, "particles within dx/2 of another, largest"), Is.LessThan(0.01));
        }

        [TestCase("thesis-printed", 2.0)]
        [TestCase("thesis", 2.0)]
        [TestCase("standard", 2.25)]
        public void CasesSweepAboutTheMethodsOwnSupport(string method, double supportRatio)
        {
            foreach (ValidationCase validationCase in CaseCatalogue.All)
            {
                Assert.That(validationCase.Base(CaseMethod.Find(method)).SupportRatio, Is.EqualTo(supportRatio), validationCase.Name);
            }
        }

        private static CaseParameters Coarse(ValidationCase validationCase, int resolution) =>
            WallCaseRig.Coarse(validationCase, Standard, resolution);

        private static double Run(ValidationCase validationCase, CaseParameters parameters, out CaseMetric metric) =>
            WallCaseRig.MainError(validationCase, parameters, out metric);
    }
}
