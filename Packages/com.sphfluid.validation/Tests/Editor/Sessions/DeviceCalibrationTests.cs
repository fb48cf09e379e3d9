using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    [Category("Gpu")]
    public sealed class DeviceCalibrationTests
    {
        [Test]
        public void AStepTakesTime()
        {
            var calibration = new DeviceCalibration(SurfaceTestScene.LoadShaders());
            int submissions = 0;
            for (var run = calibration.Run(); run.MoveNext();) submissions++;

            Assert.That(submissions, Is.GreaterThan(1), "the first, which compiles, does not count");
            // A GPU needs tens of microseconds for its dispatches, a processor seconds at worst.
            Assert.That(calibration.SecondsPerStep, Is.InRange(1e-7, 100.0));
        }
    }
}
