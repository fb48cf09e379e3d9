using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Crates in still water, against Archimedes.</summary>
    public sealed class FloatingCrateTests
    {
        // Water in a tank about a crate three halves as wide as high, let go a little above its draught and tilted.
        static (double draught, double tilt, double speed, string figures) Float(float spacing, float ratio, int across, int deep, float side, double seconds)
        {
            Vector3 crate = side * new Vector3(1.5f, 1f, 1.5f);
            var domain = new Vector3(across * spacing, 2 * deep * spacing, across * spacing);
            FluidSolverSettings settings = BodyRig.Water(domain, spacing, deep * spacing);
            float level = -0.5f * domain.y + deep * spacing;
            var centre = new Vector3(0f, level + (0.5f - ratio) * crate.y + 0.05f * crate.y, 0f);
            Vector3 half = 0.5f * crate + 0.5f * spacing * Vector3.one;
            FluidParticle[] particles = FloatingRig.Block(new Vector3Int(across, deep, across), spacing, -0.5f * domain)
                .Where(p => Mathf.Abs(p.Position.x) > half.x || Mathf.Abs(p.Position.z) > half.z || Mathf.Abs(p.Position.y - centre.y) > half.y).ToArray();
            for (int i = 0; i < particles.Length; i++) particles[i].Id = (uint)i;
            using (var rig = new FloatingRig(settings, particles))
            {
                FloatingBody body = rig.AddBox(crate, ratio * settings.RestDensity, centre, Quaternion.Euler(5f, 0f, 3f));
                int frames = (int)(seconds * 60.0), steps = Mathf.CeilToInt(1f / 60f / settings.TimeStep);
                var heights = new List<double>();
                var speeds = new List<double>();
                for (int frame = 0; frame < frames; frame++)
                {
                    rig.Frame(steps);
                    FloatingState now = rig.Read(body);
                    heights.Add(now.Centre.y);
                    speeds.Add(now.Velocity.y);
                }
                FloatingState state = rig.Read(body);
                FluidParticle[] end = rig.Particles();
                double volume = particles.Length * (double)settings.ParticleMass / settings.RestDensity + ratio * crate.x * crate.y * crate.z;
                double nominal = volume / (domain.x * domain.z) - 0.5 * domain.y;
                int late = frames / 3;
                double height = heights.Skip(frames - late).Average();
                double rms = Math.Sqrt(speeds.Skip(frames - late).Average(v => v * v));
                double draught = (nominal - height + 0.5 * crate.y) / crate.y;
                double tilt = Vector3.Angle(Vector3.up, state.Rotation * Vector3.up);
                FluidCounters counters = rig.Solver.ReadCountersNow();
                string figures = $"{particles.Length} particles, {steps} steps a frame of {settings.TimeStep:g3} s: draught {draught:f4} of {ratio}, tilt {tilt:f2} deg, late v_rms {rms:g3}, contacts {counters.Contacts}, " +
                    $"squeezed {counters.Squeezed}, limits {counters.ImpulseLimits}, at {state.Centre}";
                return (draught, tilt, rms, figures);
            }
        }

        // Any force that is a frame late makes the light one diverge: it carries three times its mass of water along.
        [TestCase(0.1f)]
        [TestCase(0.5f)]
        public void ACrateFloatsUprightAsDeepAsItIsHeavy(float ratio)
        {
            var end = Float(0.06f, ratio, 16, 10, 0.3f, 1.6);
            Assert.That(end.tilt, Is.LessThan(8.0), end.figures);
            Assert.That(end.draught, Is.EqualTo(ratio).Within(0.3 * 0.06 / 0.3), end.figures); // 0.3 dx
            Assert.That(end.speed, Is.LessThan(0.05), end.figures);
        }
    }
}
