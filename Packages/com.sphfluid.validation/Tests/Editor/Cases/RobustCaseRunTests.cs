using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>
    /// What the Robust method is good for, case by case and coarse. It is soft and damps, which its limits show; gates are those of all
    /// methods.
    /// </summary>
    public sealed class RobustCaseRunTests
    {
        private static readonly CaseMethod Robust = CaseMethod.Find("robust");

        [Test]
        public void GatesHold()
        {
            foreach (ValidationCase gate in new ValidationCase[] { new FreeFallCase(), new MomentumCase(), new EnergyCase() })
            {
                Assert.That(Run(gate, Coarse(gate, 8), out _), Is.LessThan(gate.Limit), gate.Name);
            }
        }

        [Test]
        public void PressureCarriesTheColumn()
        {
            var column = new HydrostaticCase();
            CaseSetup setup = column.Build(Coarse(column, 10));
            HydrostaticMetric metric = WallCaseRig.Shorter(setup, 3.0, 5.0);
            Assert.That(WallCaseRig.Run(column.Name, setup, metric, SurfaceTestScene.LoadShaders()).Failure, Is.Null);
            Assert.That(WallCaseStates.Named(metric, HydrostaticMetric.ErrorName), Is.LessThan(0.05));
            Assert.That(WallCaseStates.Named(metric, HydrostaticMetric.FaceName), Is.EqualTo(1).Within(0.1));
            Assert.That(WallCaseStates.Named(metric, "height lost beyond the equation of state's"), Is.Zero.Within(0.03));
            Assert.That(WallCaseStates.Named(metric, "mean |ρ/ρ0 − 1|"), Is.LessThan(0.15), "as soft as its steps are long");
        }

        [Test]
        public void ChannelsStartUpWithTheViscosityThatIsSet()
        {
            foreach (ChannelCase channel in new ChannelCase[] { new PoiseuilleCase(), new CouetteCase() })
            {
                Assert.That(WallCaseRig.StartUpError(channel, Coarse(channel, 8)), Is.LessThan(0.03), channel.Name);
            }
        }

        [Test]
        public void TheEllipsoidSwings()
        {
            var ellipsoid = new EllipsoidCase();
            Assert.That(Run(ellipsoid, Coarse(ellipsoid, 6), out _), Is.LessThan(0.12));
        }

        [Test]
        public void DropsThatCollideKeepTheirMomentum()
        {
            var drops = new DropsCase();
            Assert.That(Run(drops, Coarse(drops, 6), out CaseMetric metric), Is.LessThan(0.08));
            Assert.That(WallCaseStates.Named(metric, DropsMetric.GrowthName), Is.LessThan(0.01));
            Assert.That(WallCaseStates.Named(metric, MomentumMetric.ErrorName), Is.LessThan(1e-5));
        }

        private static CaseParameters Coarse(ValidationCase validationCase, int resolution) =>
            WallCaseRig.Coarse(validationCase, Robust, resolution);

        private static double Run(ValidationCase validationCase, CaseParameters parameters, out CaseMetric metric) =>
            WallCaseRig.MainError(validationCase, parameters, out metric);
    }
}
