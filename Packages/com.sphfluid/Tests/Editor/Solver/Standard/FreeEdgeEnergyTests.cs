using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// A block of liquid thrown at the free edge of a sheet, without gravity and viscosity: what it has of its kinetic energy after it has
    /// been parted, when nothing presses any more. With short steps, so that the time step adds nothing.
    /// </summary>
    public sealed class FreeEdgeEnergyTests
    {
        private const float Spacing = 0.02f;
        private const float Speed = 2f;

        // Head-on, off the middle, and from an irregular start. What is given: 1 + the share of energy that comes from nowhere.
        [TestCase(0f, 0f)]
        [TestCase(0f, 0.3f)]
        [TestCase(0.02f, 0f)]
        [TestCase(0.05f, 0.5f)]
        public void ABlockThatAnEdgePartsKeepsItsEnergy(float jitter, float shift)
        {
            double ratio = EnergyRatio(0.2f, jitter, shift, out double fastest);
            Assert.That(ratio, Is.InRange(0.85, 1.0));
            Assert.That(fastest, Is.LessThan(2.5), "drops do not leave faster than a jet is turned");
        }

        private static double EnergyRatio(float stepShare, float jitter, float shift, out double fastest)
        {
            FluidSolverSettings settings = BodyRig.Water(new Vector3(100f, 60f, 60f) * Spacing, Spacing, 0.01f, Speed);
            settings.Gravity = Vector3.zero;
            settings.Viscosity = 0f;
            settings.TimeStep *= stepShare;
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(5, 13, 5), Spacing, jitter * Spacing, 4)
                .Select((p, i) => new FluidParticle(p.Position + Spacing * new Vector3(shift, 8.5f, 0f), Speed * Vector3.down, (uint)i))
                .ToArray();
            float wide = 35f * Spacing, deep = -40f * Spacing;
            Vector3 a = new Vector3(0f, 0f, -wide), b = new Vector3(0f, 0f, wide), c = new Vector3(0f, deep, wide),
                d = new Vector3(0f, deep, -wide);
            using (var rig = new BodyRig(settings))
            {
                rig.Add(new[] { a, b, c, a, c, d });
                rig.Start(start);
                int steps = (int)(20f * Spacing / Speed / settings.TimeStep);
                for (int left = steps; left > 0; left -= 50) rig.Frame(Math.Min(50, left));
                FluidParticle[] end = rig.Particles();
                Assert.That(end.Length, Is.EqualTo(start.Length));
                Assert.That(end.Max(p => Math.Abs(p.Position.x)), Is.GreaterThan(3.5f * Spacing), "the edge has parted it");
                fastest = end.Max(p => p.VelT0.magnitude) / Speed;
                return end.Sum(p => (double)p.VelT0.sqrMagnitude) / (Speed * Speed * start.Length);
            }
        }
    }
}
