using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A slab of water that hits a wall: what it loses of its momentum is known, whatever the pressure does meanwhile.</summary>
    public sealed class ImpactWallForceTests
    {
        private const float Spacing = 0.05f, Speed = 3f;

        // The liquid fills the domain across, so the wall has one pressure. The mean of the particles stays on after the hit has passed and
        // overrates it.
        [Test]
        public void InAHitTheForceIsTheMomentumLostAndTheMeanOfTheParticlesIsNot()
        {
            var domain = new Vector3(1f, 0.4f, 0.4f);
            FluidSolverSettings settings = BodyRig.Water(domain, Spacing, 0.4f, Speed);
            settings.Gravity = Vector3.zero;
            settings.Boundaries.Friction = 0f;
            FluidParticle[] slab =
                WallForceRig.Block(new Vector3Int(6, 8, 8), Spacing, new Vector3(0.05f, -0.2f, -0.2f), Speed * Vector3.right);
            using (var rig = new WallForceRig(settings, slab))
            {
                WallPatch wall = rig.Add(new Vector3(0.5f, 0f, 0f), Vector3.left, 0.6f, 0.6f);
                wall.Memory = 10.0;
                double step = settings.TimeStep, before = rig.Momentum().X, mean = 0.0, meanPeak = 0.0, area = domain.y * (double)domain.z;
                for (int i = 0; i * step < 0.16; i++)
                {
                    rig.Frame(1);
                    FluidParticle[] now = rig.Particles();
                    float[] pressures = rig.Pressures();
                    double pressure = 0.0;
                    for (int p = 0; p < 9; p++)
                    {
                        pressure += rig.Shepard(now, pressures, new Vector3(0.5f, 0.1f * (p / 3 - 1), 0.1f * (p % 3 - 1))) / 9.0;
                    }
                    mean += pressure * step;
                    meanPeak = Math.Max(meanPeak, pressure);
                }

                rig.Forces.Complete();
                double lost = before - rig.Momentum().X, peak = wall.PeakPressure(0.0, 10000) * wall.Area / area;
                string figures =
                    $"force {wall.Impulse / lost:f4}, mean of the particles {mean * area / lost:f2} of the momentum lost, " +
                    $"{lost / before:f2} of all; " +
                    $"peaks {peak / 1e3:f1} and {meanPeak / 1e3:f1} kPa; rho c v = " +
                    $"{settings.RestDensity * settings.SoundSpeed * Speed / 1e3:f1} kPa";
                TestContext.WriteLine(figures);
                Assert.That(lost / before, Is.GreaterThan(1.0), figures);
                Assert.That(wall.Impulse / lost, Is.EqualTo(1.0).Within(1e-3), figures);
                Assert.That(Math.Abs(mean * area / lost - 1.0), Is.GreaterThan(0.05), figures);
            }
        }
    }
}
