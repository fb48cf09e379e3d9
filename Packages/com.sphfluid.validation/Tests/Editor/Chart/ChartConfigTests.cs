using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    /// <summary>What a point of the chart says of its liquid.</summary>
    public sealed class ChartConfigTests
    {
        [TestCase("thesis")]
        [TestCase("standard")]
        public void TheSpeedOfSoundIsThatOfTheProfile(string method)
        {
            ChartConfig config = Column(method);
            Assert.That(config.EffectiveSoundSpeedRatio, Is.EqualTo(config.SoundSpeedRatio));
        }

        [Test]
        public void RobustIsAsSoftAsItsStepsAreLong()
        {
            ChartConfig config = Column("robust");
            CaseSetup setup = config.Case.Build(config.Parameters(1));
            double expected = FluidRules.EffectiveSoundSpeed(setup.Settings, setup.Settings.TimeStep, setup.Settings.MaxSpeed) /
                setup.Settings.MaxSpeed;

            Assert.That(config.EffectiveSoundSpeedRatio,
                Is.EqualTo(expected).Within(1e-3).Percent.And.LessThan(0.6 * config.SoundSpeedRatio));
        }

        private static ChartConfig Column(string method)
        {
            var column = new HydrostaticCase();
            return new ChartConfig(column, column.Base(CaseMethod.Find(method)), ChartFactor.Base);
        }
    }
}
