using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Liquid among triangles, many steps: nothing is lost, nothing boils.</summary>
    public sealed class MeshWallFlowTests
    {
        const float Spacing = 0.02f;

        static FluidParticle[] Block(Vector3Int counts, Vector3 low)
        {
            FluidParticle[] particles = ParticleSets.Lattice(counts, Spacing, 0f, 1);
            for (int i = 0; i < particles.Length; i++)
                particles[i].Position += low + 0.5f * Spacing * (Vector3)counts;
            return particles;
        }

        static bool IsInside(Transform box, Vector3 position)
        {
            Vector3 p = box.InverseTransformPoint(position);
            return Mathf.Abs(p.x) < 0.5f && Mathf.Abs(p.y) < 0.5f && Mathf.Abs(p.z) < 0.5f;
        }

        [Test]
        public void APoolInABoxOfTrianglesRests()
        {
            var counts = new Vector3Int(10, 10, 10);
            Vector3 size = Vector3.Scale(new Vector3(1f, 2f, 1f), (Vector3)counts) * Spacing;
            FluidSolverSettings settings = BodyRig.Water(size + 6f * Spacing * Vector3.one, Spacing, counts.y * Spacing);
            using (var rig = new BodyRig(settings))
            {
                Transform box = rig.AddBox(size);
                rig.Start(Block(counts, -0.5f * size));
                double depth = counts.y * Spacing, gravity = settings.Gravity.magnitude;
                rig.Frame((int)(4.0 * Math.Sqrt(depth / gravity) / settings.TimeStep));
                FluidCounters counters = rig.Solver.ReadCountersNow();
                FluidParticle[] particles = rig.Particles();
                double speed = Math.Sqrt(particles.Average(p => (double)p.VelT0.sqrMagnitude)) / Math.Sqrt(gravity * depth);
                double centre = particles.Average(p => (double)p.Position.y) + 0.5 * size.y;
                double height = 2.0 * centre;
                double expected = depth * (1.0 - 0.5 * gravity * depth / (settings.SoundSpeed * settings.SoundSpeed));
                TestContext.WriteLine($"v_rms {speed:g3}, height {height / expected:f4} of the EOS's, contacts {counters.Contacts}, fallbacks {counters.ContactFallbacks}, steps {rig.Solver.StepCount}, clamps {counters.DomainClamps}");
                Assert.That(particles.All(p => IsInside(box, p.Position)), Is.True);
                Assert.That(counters.ContactFallbacks, Is.Zero);
                Assert.That(counters.NonFinite, Is.Zero);
                Assert.That(speed, Is.LessThan(0.02));
                Assert.That(height, Is.EqualTo(expected).Within(1.5).Percent);
            }
        }
    }
}
