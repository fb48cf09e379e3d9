using NUnit.Framework;

namespace SphFluid.Tests
{
    public sealed class WendlandKernelTests
    {
        [TestCase(2.0, 1.0338, 0.9501)]
        [TestCase(2.25, 1.0230, 0.9763)]
        [TestCase(2.5, 1.0134, 0.9664)]
        [TestCase(5.0, 1.0001, 0.9999)]
        public void SumsOverTheLattice(double ratio, double sum, double moment)
        {
            Assert.That(WendlandKernel.LatticeSum(ratio), Is.EqualTo(sum).Within(5e-5));
            Assert.That(WendlandKernel.LatticeMoment(ratio), Is.EqualTo(moment).Within(5e-5));
            var settings = new FluidSolverSettings { Spacing = 0.05f, SupportRadius = (float)(0.05 * ratio) };
            Assert.That(WendlandKernel.LatticeMoment(ratio), Is.EqualTo(StandardReference.Response(settings)).Within(1e-5),
                "by compression");
        }

        // Morris's sum of a particle that moves among others at rest, by all of a lattice.
        [TestCase(2.0, 18.216)]
        [TestCase(2.25, 20.5625)]
        [TestCase(3.0, 24.362)]
        public void ViscosityOfALattice(double ratio, double expected)
        {
            Assert.That(WendlandKernel.LatticeViscosity(ratio), Is.EqualTo(expected).Within(1e-4 * expected));
        }

        [Test]
        public void StepsAreOfTheForcesAsTheyAre()
        {
            // κ = 2: forces are 1/0.9501 of the sums', so that waves run at most as if c were that much faster.
            TimeStepAdvice advice = StandardRules.Advise(0.05, 0.1, 19.0, 1.0, 0.01);
            Assert.That(advice.Acoustic, Is.EqualTo(0.9 * 0.1 / (19.0 / 0.9501 + 1.0)).Within(0.01).Percent);
            Assert.That(advice.Viscosity, Is.EqualTo(0.035 * 0.01 * 0.9501 / 0.01).Within(0.01).Percent);
            Assert.That(advice.SoundSpeed, Is.EqualTo(19.0));
        }
    }
}
