using System;
using NUnit.Framework;
using SphFluid.Validation;

namespace SphFluid.Tests
{
    public sealed class ChannelFlowTests
    {
        private const double Gap = 0.8, Viscosity = 0.01, Force = 0.03, Speed = 0.2;

        [Test]
        public void BothStartFromRestAndEndInTheSteadyProfile()
        {
            for (int i = 0; i <= 16; i++)
            {
                double y = Gap * i / 16;
                Assert.That(Poiseuille(y, 1e4), Is.EqualTo(Force * y * (Gap - y) / (2 * Viscosity)).Within(1e-12));
                Assert.That(Couette(y, 1e4), Is.EqualTo(Speed * y / Gap).Within(1e-12));
                Assert.That(Poiseuille(y, 0), Is.Zero);
                Assert.That(Couette(y, 0), Is.EqualTo(i == 16 ? Speed : 0));
                if (i < 15) Assert.That(Couette(y, 1e-3), Is.Zero.Within(1e-12), "the wall has not been felt yet");
            }
            Assert.That(Poiseuille(0.5 * Gap, 1e-3), Is.EqualTo(Force * 1e-3).Within(1e-12), "a free fall far from the walls");
        }

        [Test]
        public void PoiseuilleIsSymmetricAndWallsAreKept([Values(0.5, 2, 10, 50)] double t)
        {
            Assert.That(Poiseuille(0, t), Is.Zero.Within(1e-14));
            Assert.That(Poiseuille(Gap, t), Is.Zero.Within(1e-14));
            Assert.That(Couette(0, t), Is.Zero.Within(1e-14));
            Assert.That(Couette(Gap, t), Is.EqualTo(Speed).Within(1e-14));
            for (double y = 0.05; y < 0.4; y += 0.05) Assert.That(Poiseuille(y, t), Is.EqualTo(Poiseuille(Gap - y, t)).Within(1e-14));
        }

        [Test]
        public void BothAgreeWithFiniteDifferences([Values(2.0, 20.0)] double end)
        {
            const int Cells = 160;
            double dy = Gap / Cells;
            int steps = (int)Math.Ceiling(end * Viscosity / (0.2 * dy * dy));
            double dt = end / steps;
            var p = new double[Cells + 1];
            var c = new double[Cells + 1];
            c[Cells] = Speed;
            for (int s = 0; s < steps; s++)
            {
                p = Diffused(p, Viscosity * dt / (dy * dy), Force * dt);
                c = Diffused(c, Viscosity * dt / (dy * dy), 0);
            }
            for (int i = 0; i <= Cells; i++)
            {
                Assert.That(Poiseuille(i * dy, end), Is.EqualTo(p[i]).Within(2e-4 * Force * Gap * Gap / (8 * Viscosity)));
                Assert.That(Couette(i * dy, end), Is.EqualTo(c[i]).Within(2e-4 * Speed));
            }
        }

        private static double[] Diffused(double[] u, double ratio, double push)
        {
            var next = (double[])u.Clone();
            for (int i = 1; i < u.Length - 1; i++) next[i] = u[i] + ratio * (u[i - 1] - 2 * u[i] + u[i + 1]) + push;
            return next;
        }

        private static double Poiseuille(double y, double t) => ChannelFlow.Poiseuille(y, t, Gap, Viscosity, Force);

        private static double Couette(double y, double t) => ChannelFlow.Couette(y, t, Gap, Viscosity, Speed);
    }
}
