using System;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Particles nearer than 0.6 dx where no pressure acts: they part, and nothing else changes.</summary>
    public sealed class ClosePairsTests
    {
        private const float Spacing = 0.05f;

        [TestCase(0.3f)]
        [TestCase(0.01f)]
        [TestCase(0f)]
        public void TwoThatRestPart(float distance)
        {
            FluidSolverSettings settings = Settings();
            Vector3 direction = new Vector3(2f, -1f, 2f) / 3f;
            FluidParticle[] end = Run(Pair(distance * Spacing * direction, Vector3.zero), 400, settings);
            Vector3 d = end[0].Position - end[1].Position;
            Assert.That(d.magnitude / Spacing, Is.InRange(0.59f, 15f));
            if (distance > 0f) Assert.That(Vector3.Angle(d, direction), Is.LessThan(1f), "along the line between them");
            Assert.That((end[0].VelT0 + end[1].VelT0).magnitude, Is.LessThan(1e-6f * settings.SoundSpeed), "momentum");
            Assert.That((end[0].VelT0 - end[1].VelT0).magnitude, Is.LessThan(0.03f * settings.SoundSpeed));
        }

        // Straight at each other, past each other at 0.2 dx, and apart; slow and at 0.2 c, twice the fastest that rules expect.
        [TestCase(0f, 0.002f)]
        [TestCase(0f, 0.2f)]
        [TestCase(0.2f, 0.2f)]
        public void ThoseThatCollideKeepMomentumAndGainNoEnergy(float past, float speedOverSound)
        {
            FluidSolverSettings settings = Settings();
            float speed = speedOverSound * settings.SoundSpeed;
            Vector3 apart = Spacing * new Vector3(1.5f, past, 0f), closing = new Vector3(-speed, 0f, 0f);
            Vector3 drift = speed * new Vector3(0.1f, 0.2f, -0.3f);
            FluidParticle[] start = Pair(apart, closing, drift);
            int steps = (int)(3f * Spacing / (speed * settings.TimeStep)) + 60;
            FluidParticle[] end = Run(start, steps, settings);
            Vector3 sum = end[0].VelT0 + end[1].VelT0 - 2f * drift, left = end[0].VelT0 - end[1].VelT0;
            Assert.That(sum.magnitude, Is.LessThan(1e-5f * speed + 1e-6f), "momentum");
            float push = 0.016f * settings.SoundSpeed; // what parts a pair that rests
            Assert.That(left.magnitude, Is.LessThan(Mathf.Max(past > 0f ? 0.9f * speed : 0f, push)), "speed to each other");
            Assert.That((end[0].Position - end[1].Position).magnitude / Spacing, Is.GreaterThan(0.5f));
            double before = Spin(start), after = Spin(end);
            Assert.That(after, Is.EqualTo(before).Within(1e-3 * Spacing * speed), "angular momentum");
        }

        [Test]
        public void NoStepIsTooLongForACollision()
        {
            FluidSolverSettings settings = Settings();
            settings.TimeStep *= 4f;
            float speed = 0.05f * settings.SoundSpeed;
            FluidParticle[] start = Pair(0.4f * Spacing * Vector3.right, -speed * Vector3.right);
            FluidParticle[] end = Run(start, 1, settings);
            float left = end[0].VelT0.x - end[1].VelT0.x;
            Assert.That(left, Is.InRange(-speed, 0.02f * settings.SoundSpeed), "no faster back than by the push");
        }

        // Layers of a film, and a thread of twice the density of one at rest; no pressure acts.
        [TestCase(8, 8, 1, 0.85f)]
        [TestCase(8, 8, 1, 1f)]
        [TestCase(20, 1, 1, 0.61f)]
        [TestCase(6, 6, 6, 1.001f)]
        public void AtTheDistancesOfLiquidNothingIsFelt(int x, int y, int z, float apart)
        {
            var particles = new List<FluidParticle>();
            var counts = new Vector3(x, y, z);
            for (int i = 0; i < x * y * z; i++)
            {
                var at = new Vector3(i % x, i / x % y, i / (x * y));
                Vector3 position = apart * Spacing * (at - 0.5f * (counts - Vector3.one));
                particles.Add(new FluidParticle(position, Vector3.zero, (uint)i));
            }

            FluidParticle[] end = Run(particles.ToArray(), 100, Settings());
            foreach (FluidParticle p in end)
            {
                Assert.That(p.VelT0, Is.EqualTo(Vector3.zero), $"velocity of {p.Id}");
                Assert.That(p.Position, Is.EqualTo(particles[(int)p.Id].Position), $"place of {p.Id}");
            }
        }

        // A sheet and a jet that are stretched: nothing draws them together.
        [TestCase(8, 8, 0.85f)]
        [TestCase(24, 1, 0.61f)]
        public void WhatIsStretchedFeelsNoTension(int x, int z, float apart)
        {
            const float rate = 2f; // 1/s
            var particles = new FluidParticle[x * z];
            for (int i = 0; i < particles.Length; i++)
            {
                Vector3 position = apart * Spacing * new Vector3(i % x - 0.5f * (x - 1), 0f, i / x - 0.5f * (z - 1));
                particles[i] = new FluidParticle(position, rate * position, (uint)i);
            }

            FluidParticle[] end = Run(particles, 50, Settings());
            foreach (FluidParticle p in end)
            {
                Vector3 start = particles[(int)p.Id].VelT0;
                Assert.That((p.VelT0 - start).magnitude, Is.LessThan(1e-6f + 1e-5f * start.magnitude), $"{p.Id}");
            }
        }

        private static FluidSolverSettings Settings()
        {
            FluidSolverSettings settings = StandardStateRig.Water(new Vector3(2f, 1f, 1f), Spacing);
            settings.Gravity = Vector3.zero;
            settings.Viscosity = 0f; // its own drag on pairs turns them
            return settings;
        }

        // Two, the first seen from the second at d with v.
        private static FluidParticle[] Pair(Vector3 d, Vector3 v, Vector3 drift = default) => new[]
        {
            new FluidParticle(0.5f * d, 0.5f * v + drift, 0u),
            new FluidParticle(-0.5f * d, -0.5f * v + drift, 1u),
        };

        // By id.
        private static FluidParticle[] Run(FluidParticle[] particles, int steps, in FluidSolverSettings settings)
        {
            using (var rig = new StandardRig(settings, particles))
            {
                rig.Steps(steps);
                FluidParticle[] end = rig.Particles();
                Array.Sort(end, (a, b) => a.Id.CompareTo(b.Id));
                return end;
            }
        }

        // About z, of the pair about its middle.
        private static double Spin(FluidParticle[] pair)
        {
            Double3 d = (Double3)pair[0].Position - pair[1].Position, v = (Double3)pair[0].VelT0 - pair[1].VelT0;
            return d.X * v.Y - d.Y * v.X;
        }
    }
}
