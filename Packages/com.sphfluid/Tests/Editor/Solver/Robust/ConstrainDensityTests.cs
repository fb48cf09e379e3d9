using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class ConstrainDensityTests
    {
        private const float Spacing = 0.05f;
        private const float TimeStep = 1f / 240f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.35f, 0.36f);

        [TestCase(1, FluidAxes.None)]
        [TestCase(63, FluidAxes.None)]
        [TestCase(64, FluidAxes.X)]
        [TestCase(65, FluidAxes.All)]
        [TestCase(251, FluidAxes.None)]
        public void TheFirstChangeIsThatOfTheDensityOverItsGradients(int count, FluidAxes periodic)
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing, periodic);
            using (var rig = new RobustStateRig(settings, count))
            {
                FluidParticle[] particles = rig.Constrained(TimeStep);
                Vector4[] terms = GpuTest.Read<Vector4>(rig.State.Buffers.PositionTerms, count);
                double[] expected = Enumerable.Range(0, count).Select(i => Change(particles, i, settings)).ToArray();
                double largest = expected.Max(Math.Abs);
                for (int i = 0; i < count; i++)
                {
                    Assert.That((Vector3)terms[i], Is.EqualTo(particles[i].Position));
                    Assert.That(terms[i].w, Is.EqualTo(expected[i]).Within(2e-4 * largest + 1e-12), $"particle {i}");
                }
                if (count > 200)
                {
                    Assert.That(expected.Count(c => c < 0.0), Is.InRange(count / 10, count - 1), "compressed ones move, others do not");
                }
            }
        }

        [Test]
        public void MultipliersComeToTheCompressionOverTheCompliance()
        {
            // Nobody moves, so C stays: lambda goes to -C/alpha, the pressure c^2 (rho - rho0) of the Standard method.
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing, FluidAxes.All);
            const int count = 257;
            using (var rig = new RobustStateRig(settings, count))
            {
                FluidParticle[] particles = rig.Constrained(1e-4f);
                CellBuffers buffers = rig.State.Buffers;
                var pass = new ConstrainDensityPass(rig.Shaders);
                var multipliers = new float[count];
                for (int n = 0; n < 40; n++)
                {
                    Vector4[] terms = GpuTest.Read<Vector4>(buffers.PositionTerms, count);
                    for (int i = 0; i < count; i++) multipliers[i] += terms[i].w;
                    buffers.NewPositions.SetData(particles.Select((p, i) => RobustStateRig.WithW(p.Position, multipliers[i])).ToArray());
                    GpuTest.Run(cmd => pass.RecordListed(cmd, rig.State, RobustRules.Compliance(settings, 1e-4, 1e-4, 1),
                        rig.State.Buffers.NewPositions));
                }
                double reach = settings.SoundSpeed * 1e-4;
                for (int i = 0; i < count; i++)
                {
                    double constraint = StandardReference.Density(particles, i, settings) / settings.RestDensity - 1.0;
                    Assert.That(multipliers[i], Is.EqualTo(Math.Min(0.0, -constraint * reach * reach)).Within(1e-3 * reach * reach),
                        $"particle {i}");
                }
            }
        }

        [Test]
        public void ShorterStepsStayAsSoftAsTheLongest()
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing);
            double longest = RobustRules.EffectiveSoundSpeed(settings, TimeStep, 2);
            foreach (double part in new[] { 1.0, 0.9, 0.5, 0.1 })
            {
                double step = part * TimeStep, compliance = RobustRules.Compliance(settings, step, TimeStep, 2);
                double own = 1.0 / System.Math.Sqrt(compliance * step * step);
                Assert.That(RobustRules.EffectiveSoundSpeed(settings.WithSoundSpeed((float)own), step, 2),
                    Is.EqualTo(longest).Within(1e-3).Percent);
            }
            Assert.That(RobustRules.Compliance(settings, TimeStep, TimeStep, 2),
                Is.EqualTo(System.Math.Pow(settings.SoundSpeed * (double)TimeStep, -2.0)).Within(1e-6).Percent);
        }

        [Test]
        public void ReadersGetDensityAndTheLastPressure([Values] bool hasPressures)
        {
            FluidSolverSettings settings = RobustStateRig.Robust(Domain, Spacing);
            const int count = 193;
            using (var rig = new RobustStateRig(settings, count))
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, Domain, 1f, 6));
                rig.State.Motion.Starts.SetData(Enumerable.Range(0, count)
                    .Select(i => new Vector4(0f, 0f, 0f, hasPressures ? 10f * i : float.NaN)).ToArray());
                var pass = new ConstrainDensityPass(rig.Shaders);
                GpuTest.Run(cmd => pass.RecordMeasured(cmd, rig.State, hasPressures));
                Vector2[] terms = rig.Terms();
                for (int i = 0; i < count; i++)
                {
                    Assert.That(terms[i].x, Is.EqualTo(StandardReference.Density(particles, i, settings)).Within(2e-3).Percent);
                    Assert.That(terms[i].y * settings.RestDensity * settings.RestDensity,
                        Is.EqualTo(hasPressures ? 10f * i : 0f).Within(1e-3).Percent, "at rest density");
                }
            }
        }

        // -omega C/(D + alpha), not above 0.
        private static double Change(FluidParticle[] particles, int i, FluidSolverSettings settings)
        {
            double response = StandardReference.Response(settings), ratio = settings.ParticleMass / (settings.RestDensity * response),
                h = 1e-4 * Spacing, squares = 0.0;
            double Walls(double x, double y, double z) =>
                StandardReference.Walls((Double3)particles[i].Position + new Double3(x, y, z), settings);
            Double3 gradient = new Double3(Walls(h, 0, 0) - Walls(-h, 0, 0), Walls(0, h, 0) - Walls(0, -h, 0),
                Walls(0, 0, h) - Walls(0, 0, -h)) / (2.0 * h * response);
            for (int j = 0; j < particles.Length; j++)
            {
                Double3 d = ThesisReference.Separation(particles[i], particles[j], settings.PeriodLength);
                if (j == i || d.Length >= settings.SupportRadius) continue;
                Double3 slope = ratio * StandardReference.Slope(d.Length, settings.SupportRadius) / d.Length * d;
                gradient += slope;
                squares += Double3.Dot(slope, slope);
            }
            double reach = settings.SoundSpeed * (double)TimeStep,
                constraint = StandardReference.Density(particles, i, settings) / settings.RestDensity - 1.0;
            return Math.Min(0.0,
                -settings.Own<RobustSettings>().Relaxation * constraint /
                    (Double3.Dot(gradient, gradient) + squares + 1.0 / (reach * reach)));
        }
    }
}
