using NUnit.Framework;

namespace SphFluid.Tests
{
    /// <summary>
    /// The calibrated iso values; references from an independent single-precision program that meshes a finite pool.
    /// </summary>
    public sealed class SurfaceIsoCalibrationTests
    {
        [TestCase(1.0, 0.9, 1, 0.10, 0.503)]
        [TestCase(0.75, 0.5, 1, 0.12, 0.521)]
        [TestCase(0.5, 0.5, 2, 0.15, 0.513)]
        public void ValuesAreThoseOfTheReference(double cell, double smoothing, int passes, double offset,
            double expected) =>
                Assert.AreEqual(expected, SurfaceIsoCalibration.IsoValue(2.0, cell, smoothing, passes, offset), 0.0015);

        // Without a filter the cells do not matter but for the straight line between two samples.
        [Test]
        public void FineCellsNeedTheIsoValueOfTheFieldItself()
        {
            float fine = SurfaceIsoCalibration.IsoValue(2.0, 0.25, 0.0, 0, 0.0);
            Assert.AreEqual(fine, SurfaceIsoCalibration.IsoValue(2.0, 0.5, 0.0, 0, 0.0), 0.01);
            Assert.That(fine, Is.InRange(0.5f, 0.7f));
        }

        [Test]
        public void SettingsCarryTheCalibratedValue()
        {
            FluidSolverSettings settings = TestSettings.ByRule(UnityEngine.Vector3.one, 0.05f);
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings);
            Assert.AreEqual(0.0375f, field.CellSize, 1e-6f);
            Assert.AreEqual(0.1f, field.SupportRadius, 1e-6f);
            Assert.AreEqual(0.521f, field.IsoValue, 0.0015f);
            Assert.AreEqual(field, SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings, 0.75f));
            Assert.Throws<System.ArgumentOutOfRangeException>(() => SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings, 2.5f));
            Assert.Throws<System.ArgumentOutOfRangeException>(() =>
                SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings, float.NaN));
        }
    }
}
