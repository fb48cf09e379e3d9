using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class RobustMethodTests
    {
        private const float Spacing = 0.05f;

        private static FluidSolverSettings Settings(Vector3 domain, FluidAxes periodic = FluidAxes.None, float ratio = 2f)
        {
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = FluidMethodKind.Robust;
            input.DomainSize = domain;
            input.Spacing = Spacing;
            input.SupportRatio = ratio;
            input.LiquidHeight = domain.y;
            input.LiquidDepth = 0.5f * domain.y;
            FluidSolverSettings settings = FluidRules.Derive(input);
            settings.Boundaries.Periodic = periodic;
            return settings;
        }

        [TestCase(1, 2, FluidAxes.None)]
        [TestCase(63, 2, FluidAxes.None)]
        [TestCase(64, 1, FluidAxes.X)]
        [TestCase(65, 4, FluidAxes.None)]
        [TestCase(65, 4, FluidAxes.None, false)]
        [TestCase(257, 2, FluidAxes.All)]
        [TestCase(257, 2, FluidAxes.All, false)]
        [TestCase(509, 2, FluidAxes.None)]
        [TestCase(509, 3, FluidAxes.Y)]
        [TestCase(509, 3, FluidAxes.Y, false)]
        public void OneStepIsThatOfAllPairs(int count, int iterations, FluidAxes periodic, bool keepsLists = true)
        {
            FluidSolverSettings settings = Settings(new Vector3(0.4f, 0.5f, 0.3f), periodic)
                .WithOwn((ref RobustSettings own) => own.Iterations = iterations);
            FluidParticle[] start = ParticleSets.Random(count, 0.98f * settings.DomainSize, 1f, 4);
            using (StandardRig rig = new StandardRig(settings, start))
            {
                float dt = settings.TimeStep;
                rig.Solver.PeakSpeed = 0f;
                rig.Solver.FlowSpeed = keepsLists ? 0f : settings.SupportRadius / dt;
                rig.Steps(1);
                var reference = new RobustReference(start, settings, dt, 0.5 * dt, keepsLists);
                reference.Step(iterations, RobustRules.ActingViscosity(settings, dt, iterations),
                    Math.Min(settings.SoundSpeed, RobustRules.EffectiveSoundSpeed(settings, dt, iterations)));
                float[] pressures = rig.Pressures();
                FluidParticle[] after = rig.Particles();
                double highest = Enumerable.Range(0, count).Max(i => reference.Pressure(i));
                for (int k = 0; k < count; k++)
                {
                    int i = (int)after[k].Id;
                    Double3 apart = (Double3)after[k].Position - reference.Places[i];
                    Vector3 period = settings.PeriodLength;
                    double Short(double x, float length) => length > 0f ? x - length * Math.Round(x / length) : x;
                    var error = new Double3(Short(apart.X, period.x), Short(apart.Y, period.y), Short(apart.Z, period.z));
                    Assert.That(error.Length, Is.LessThan(2e-4 * Spacing), $"place of {i}");
                    Assert.That(((Double3)after[k].VelT0 - reference.Velocities[i]).Length, Is.LessThan(2e-4 * Spacing / dt),
                        $"velocity of {i}");
                    Assert.That(pressures[k], Is.EqualTo(reference.Pressure(i)).Within(1e-3 * highest + 1e-3), $"pressure of {i}");
                }
            }
        }

        [Test]
        public void EqualRunsAreEqualToTheLastBit()
        {
            FluidSolverSettings settings = Settings(new Vector3(0.4f, 0.5f, 0.3f));
            FluidParticle[] Run()
            {
                using (StandardRig rig =
                    new StandardRig(settings, ParticleSets.Lattice(new Vector3Int(7, 8, 5), Spacing, 0.2f * Spacing, 1)))
                {
                    for (int frame = 0; frame < 5; frame++) rig.Steps(4);
                    return rig.Particles();
                }
            }
            FluidParticle[] first = Run(), second = Run();
            Assert.That(second, Is.EqualTo(first));
            Assert.That(first.Max(p => p.VelT0.magnitude), Is.GreaterThan(0.1f));
        }
    }
}
