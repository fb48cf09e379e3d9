using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Triangles hold the liquid next to them by their friction, from free slip to no slip.</summary>
    public sealed class MeshFrictionTests
    {
        private const float Spacing = 0.02f;

        // Square of two triangles that goes on behind the domain's faces.
        private static Transform AddFloor(BodyRig rig, float y)
        {
            const float half = 1f;
            Vector3 a = new Vector3(-half, y, -half), b = new Vector3(-half, y, half), c = new Vector3(half, y, half),
                d = new Vector3(half, y, -half);
            return rig.Add(new[] { a, b, c, a, c, d });
        }

        private static void SetFriction(Transform holder, float? friction)
        {
            if (friction.HasValue) holder.gameObject.AddComponent<FluidCollider>().Friction = friction.Value;
        }

        // Morris's sum over the mirror image behind a wall at rest, D(d) = 42 u^5 (1 - 3u/2 + 4u^2/7) / (q R^2), u = 1 - q, q = d/R.
        private static double MirrorDrag(double distance, double radius)
        {
            double u = Math.Max(1.0 - distance / radius, 0.0);
            return 42.0 * Math.Pow(u, 5.0) * (1.0 - 1.5 * u + 4.0 / 7.0 * u * u) / (distance * radius);
        }

        [TestCase(0f, null)]
        [TestCase(0.3f, null)]
        [TestCase(1f, null)]
        [TestCase(0f, 0.5f)]
        [TestCase(1f, 0f)]
        [TestCase(0.3f, 1f)]
        public void ATriangleHasItsCollidersFrictionOrTheDomains(float domain, float? own)
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.1f);
            settings.Gravity = Vector3.zero;
            settings.Viscosity = 0.01f * settings.RestDensity;
            settings.Boundaries.Friction = domain;
            using (var rig = new BodyRig(settings))
            {
                SetFriction(AddFloor(rig, 0f), own);
                var start = new List<FluidParticle>(); // none feels another
                for (int i = 0; i < 100; i++)
                {
                    float distance = settings.SupportRadius * (0.15f + 0.9f * i / 100f);
                    var position =
                        new Vector3(3f * Spacing * (i % 10 - 4.5f), i % 3 == 0 ? -distance : distance, 3f * Spacing * (i / 10 - 4.5f));
                    start.Add(new FluidParticle(position, new Vector3(0.1f + 0.01f * i, 0f, -0.3f), (uint)i));
                }
                rig.Start(start.ToArray());
                rig.Frame(1);
                int rubbed = 0;
                foreach (FluidParticle p in rig.Particles())
                {
                    Vector3 before = start[(int)p.Id].VelT0;
                    double rate = (own ?? domain) * 0.01 * MirrorDrag(Math.Abs(start[(int)p.Id].Position.y), settings.SupportRadius);
                    double kept = 1.0 - rate * 0.5 * settings.TimeStep; // the first kick is half a step's
                    rubbed += kept < 0.999 ? 1 : 0;
                    Assert.That(p.VelT0.x, Is.EqualTo(before.x * kept).Within(2e-5), $"at {start[(int)p.Id].Position}");
                    Assert.That(p.VelT0.z, Is.EqualTo(before.z * kept).Within(2e-5), $"at {start[(int)p.Id].Position}");
                }
                Assert.That(rubbed, (own ?? domain) > 0f ? Is.GreaterThan(30) : Is.Zero);
            }
        }

        // A film of ten layers down a slide, with the flow that no slip has at the end.
        private sealed class Film : IDisposable
        {
            public const int Layers = 10;
            private const int Width = 7;
            private const float Kinematic = 0.018f;
            private readonly BodyRig rig;

            public Film(float slope, float? friction, bool flows)
            {
                var domain = new Vector3(Width, Layers + 6, Width) * Spacing;
                FluidSolverSettings settings = BodyRig.Water(domain, Spacing, Layers * Spacing);
                settings.Gravity = 9.81f * new Vector3(Mathf.Sin(slope), -Mathf.Cos(slope), 0f);
                settings.Boundaries.Periodic = FluidAxes.X | FluidAxes.Z;
                if (friction.HasValue) settings.Viscosity = Kinematic * settings.RestDensity;
                settings.TimeStep = Mathf.Min(settings.TimeStep, 0.035f * settings.SupportRadius * settings.SupportRadius / Kinematic);
                rig = new BodyRig(settings);
                Floor = -0.5f * domain.y + 3f * Spacing;
                SetFriction(AddFloor(rig, Floor), friction);
                FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(Width, Layers, Width), Spacing, 0f, 1);
                for (int i = 0; i < start.Length; i++)
                {
                    start[i].Position.y += Floor + 0.5f * Layers * Spacing;
                    if (flows) start[i].VelT0 = new Vector3((float)NoSlip(start[i].Position.y), 0f, 0f);
                }
                rig.Start(start);
            }

            public float Floor { get; }
            public FluidSolverSettings Settings => rig.Settings;
            public FluidParticle[] Particles() => rig.Particles();
            public void Steps(int count) => rig.Frame(count);

            // u = g sin a (2 H y - y^2) / 2 nu.
            public double NoSlip(double position)
            {
                double y = position - Floor, depth = Layers * Spacing;
                return rig.Settings.Gravity.x * (2.0 * depth * y - y * y) / (2.0 * Kinematic);
            }

            // Speed at the floor by the line through the mean speeds of the two lowest layers.
            public double SpeedAtTheFloor()
            {
                double Mean(int layer, Func<FluidParticle, double> of) =>
                    Particles().OrderBy(p => p.Position.y).Skip(layer * Width * Width).Take(Width * Width).Average(of);
                double y0 = Mean(0, p => p.Position.y - Floor), y1 = Mean(1, p => p.Position.y - Floor);
                double u0 = Mean(0, p => p.VelT0.x), u1 = Mean(1, p => p.VelT0.x);
                return u0 - y0 * (u1 - u0) / (y1 - y0);
            }

            public void Dispose() => rig.Dispose();
        }

        [Test]
        public void AFilmSlipsFreelyDownASlide()
        {
            const int steps = 200;
            using (var film = new Film(Mathf.PI / 6f, null, false))
            {
                film.Steps(steps);
                double expected = film.Settings.Gravity.x * (steps - 0.5) * film.Settings.TimeStep; // half a step before the place's time
                FluidParticle[] particles = film.Particles();
                Assert.That(particles.Average(p => (double)p.VelT0.x), Is.EqualTo(expected).Within(0.2).Percent);
                double lowest = particles.OrderBy(p => p.Position.y).Take(49).Average(p => (double)p.VelT0.x);
                Assert.That(lowest, Is.EqualTo(expected).Within(0.2).Percent, "the first layer");
            }
        }

        [Test]
        public void FrictionGoesFromFreeSlipToNoSlip()
        {
            double AtTheFloor(float friction)
            {
                using (var film = new Film(0.1f, friction, true))
                {
                    double top = film.NoSlip(film.Floor + Film.Layers * Spacing);
                    film.Steps(150);
                    return film.SpeedAtTheFloor() / top;
                }
            }
            double free = AtTheFloor(0f), half = AtTheFloor(0.5f), held = AtTheFloor(1f);
            string figures = $"speed at the floor over the film's: friction 0 {free:f3}, 0.5 {half:f3}, 1 {held:f3}";
            TestContext.WriteLine(figures);
            Assert.That(Math.Abs(held), Is.LessThan(0.04), figures);
            Assert.That(half, Is.GreaterThan(held + 0.02).And.LessThan(0.5 * free), figures);
        }
    }
}
