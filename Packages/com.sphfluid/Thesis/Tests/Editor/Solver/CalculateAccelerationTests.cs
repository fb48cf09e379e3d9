using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Block 6.3.3 against double precision: f/ρ, its limit, gravity, and the scene's triangles.</summary>
    public sealed class CalculateAccelerationTests
    {
        private const float Spacing = 0.02f;

        private static readonly Vector3 Domain = new Vector3(0.4f, 0.4f, 0.4f);

        [TestCase(1)]
        [TestCase(255)]
        [TestCase(256)]
        [TestCase(257)]
        [TestCase(1009)]
        public void FluidForceAndGravityAgreeWithDoublePrecision(int count)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings = settings.WithOwn((ref ThesisSettings own) => own.WallStiffness = 0f);
            settings = settings.WithOwn((ref ThesisSettings own) => own.WallDamping = 0f);
            using (var rig = new ThesisRig(settings, ParticleSets.Random(count, 0.4f * Domain, 3f, count)))
            {
                Run(rig, out FluidParticle[] particles, out Double3[] acceleration);
                float[] density = rig.ReadDensity();
                Vector4[] force = rig.ReadForce();
                long limited = 0;
                for (int i = 0; i < particles.Length; i++)
                {
                    Double3 fluid = (Double3)(Vector3)force[i] / density[i];
                    bool cut = fluid.Length > settings.Own<ThesisSettings>().AccelerationLimit;
                    limited += cut ? 1 : 0;
                    Double3 expected = (cut ? settings.Own<ThesisSettings>().AccelerationLimit / fluid.Length : 1.0) * fluid +
                        settings.Gravity;
                    Assert.That((acceleration[i] - expected).Length, Is.LessThan(1e-6 * (fluid.Length + 10.0)), $"particle {i}");
                }

                uint[] counters = GpuTest.Read<uint>(rig.State.Published.Counters, CounterReadback.Slots);
                Assert.That(counters[0], Is.EqualTo((uint)limited), "hits of the acceleration limit");
            }
        }

        [Test]
        public void LimitIsASwitch()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings = settings.WithOwn((ref ThesisSettings own) => own.AccelerationLimit = 1f);
            settings.Gravity = new Vector3(0f, -50f, 0f);
            FluidParticle[] pair = { At(Vector3.zero, Vector3.zero), At(new Vector3(0.001f, 0f, 0f), Vector3.zero) };
            settings.RestDensity = 300f;
            Assert.That(FirstAcceleration(settings, pair).X, Is.EqualTo(-1.0).Within(1e-5), "limited");
            Assert.That(FirstAcceleration(settings, pair).Y, Is.EqualTo(-50.0).Within(1e-4), "gravity is not limited");
            settings = settings.WithOwn((ref ThesisSettings own) => own.AccelerationLimitEnabled = false);
            Assert.That(FirstAcceleration(settings, pair).X, Is.LessThan(-2.0), "off");
        }

        [TestCase(false)]
        [TestCase(true)]
        public void CollisionsAgreeWithDoublePrecision(bool closed)
        {
            FluidSolverSettings settings = CollisionSettings();
            var random = new System.Random(11);
            ReferenceMesh[] meshes =
            {
                MeshShapes.Box(new Double3(0.013, -0.02, 0.01), new Double3(0.071, 0.052, 0.063), 3),
                MeshShapes.Triangle(new Double3(-0.15, 0.1, -0.1), new Double3(0.12, 0.13, -0.08), new Double3(0.02, 0.09, 0.14)),
            };
            meshes[0].Closed = closed;
            FluidParticle[] particles = ParticleSets.Random(4001, Domain, 4f, 12);
            using (var rig = new ThesisRig(settings, particles))
            {
                // The shader has the corners in float: the reference takes the same.
                foreach (ReferenceMesh mesh in meshes) mesh.Triangles = mesh.Triangles.Select(t => t.Select(Rounded).ToArray()).ToList();

                rig.SetMeshes(meshes);
                Run(rig, out FluidParticle[] sorted, out Double3[] acceleration);
                int differing = 0;
                int pushed = 0;
                double scale = settings.Own<ThesisSettings>().WallStiffness * settings.Own<ThesisSettings>().WallDistance;
                for (int i = 0; i < sorted.Length; i++)
                {
                    Double3 expected = CollisionReference.Force(meshes, sorted[i].Position, sorted[i].VelT0, settings);
                    pushed += expected.Length > 0.0 ? 1 : 0;
                    differing += (acceleration[i] - expected).Length > 1e-4 * (scale + expected.Length) ? 1 : 0;
                }

                // Which face, edge or vertex is meant is decided by comparisons; within rounding of a border either answer is right.
                Assert.That(pushed, Is.GreaterThan(300), "the set exercises the force");
                Assert.That(differing, Is.LessThanOrEqualTo(2), $"of {pushed}");
            }
        }

        [Test]
        public void FinerTrianglesOfAFacePushNoHarder()
        {
            FluidSolverSettings settings = CollisionSettings();
            var above = new Vector3(0.0031f, 0.052f, -0.0017f);
            double expected = settings.Own<ThesisSettings>().WallStiffness * (settings.Own<ThesisSettings>().WallDistance - 0.002);
            foreach (int n in new[] { 1, 2, 7, 20 })
            {
                Double3 a = Collide(settings, MeshShapes.Box(Double3.Zero, new Double3(0.05, 0.05, 0.05), n), above, Vector3.zero);
                Assert.That(a.Y, Is.EqualTo(expected).Within(1e-4 * expected), $"{n} squares a side");
                Assert.That(Math.Abs(a.X) + Math.Abs(a.Z), Is.LessThan(1e-4 * expected));
            }
        }

        // A thin spike whose one side is cut into many triangles: at its tip the sum of their normals points to that side, and what
        // is on the other side of the tip could pass for being inside. Out of reach of the mesh's box nothing is asked.
        [Test]
        public void BeyondTheReachOfItsBoxAClosedMeshDoesNothing()
        {
            FluidSolverSettings settings = CollisionSettings();
            const int cuts = 20;
            Double3 tip = new Double3(0, 0.05, 0), a = new Double3(0.01, -0.05, 0.02), b = new Double3(0.01, -0.05, -0.02),
                c = new Double3(-0.02, -0.05, 0);
            var spike = new ReferenceMesh { Closed = true };
            spike.Triangles.Add(new[] { tip, c, a });
            spike.Triangles.Add(new[] { tip, b, c });
            for (int i = 0; i < cuts; i++)
            {
                Double3 from = a + i / (double)cuts * (b - a), to = a + (i + 1) / (double)cuts * (b - a);
                spike.Triangles.Add(new[] { tip, from, to });
                spike.Triangles.Add(new[] { c, to, from });
            }
            Vector3 beside = new Vector3(0f, 0.05f, 0f) + 0.95f * Spacing * new Vector3(-0.6f, 0.8f, 0f);
            Assert.That(beside.y - 0.05f, Is.GreaterThan(settings.Own<ThesisSettings>().WallDistance),
                "above the box by more than contact reaches");
            Assert.That(Collide(settings, spike, beside, Vector3.zero).Length, Is.Zero);
        }

        [TestCase(0.052f, 1)]
        [TestCase(0.0495f, 1)]
        [TestCase(0.035f, 1)]
        [TestCase(0.0f, 0)]
        [TestCase(0.061f, 0)]
        public void ClosedMeshPushesOutOnBothSidesOfItsFace(float height, int sign)
        {
            FluidSolverSettings settings = CollisionSettings();
            ReferenceMesh box = MeshShapes.Box(Double3.Zero, new Double3(0.08, 0.05, 0.08), 2);
            Double3 a = Collide(settings, box, new Vector3(0.01f, height, 0.02f), Vector3.zero);
            Assert.That(Math.Sign(a.Y), Is.EqualTo(sign));
        }

        [Test]
        public void EdgeAndVertexPushAwayFromTheNearestPoint()
        {
            FluidSolverSettings settings = CollisionSettings();
            ReferenceMesh box = MeshShapes.Box(Double3.Zero, new Double3(0.05, 0.05, 0.05), 3);
            foreach (Vector3 outwards in new[] { new Vector3(1f, 1f, 0f), new Vector3(1f, 1f, 1f), new Vector3(-1f, 0f, 1f) })
            {
                Vector3 n = outwards.normalized;
                Vector3 corner = 0.05f * outwards;
                Double3 a = Collide(settings, box, corner + 0.004f * n, Vector3.zero);
                double expected = settings.Own<ThesisSettings>().WallStiffness * (settings.Own<ThesisSettings>().WallDistance - 0.004);
                Assert.That((a - expected * (Double3)n).Length, Is.LessThan(1e-3 * expected), outwards.ToString());
            }
        }

        [TestCase(1f)]
        [TestCase(4f)]
        [TestCase(40f)]
        [TestCase(400f)]
        public void NoStepCrossesATriangle(float speed)
        {
            FluidSolverSettings settings = CollisionSettings();
            settings.DomainSize = 2f * Vector3.one;
            ReferenceMesh sheet = MeshShapes.Triangle(new Double3(-9, 0, -9), new Double3(0, 0, 9), new Double3(9, 0, -9));
            float dt = settings.TimeStep;
            for (int side = -1; side <= 1; side += 2)
            {
                for (int k = 1; k <= 8; k++)
                {
                    var position = new Vector3(0.013f, side * 0.12f * speed * dt * k, 0.007f);
                    var velocity = new Vector3(0.3f * speed, -side * speed, 0.1f * speed);
                    Double3 a = Collide(settings, sheet, position, velocity);
                    double after = position.y + dt * (velocity.y + dt * a.Y);
                    Assert.That(side * after, Is.GreaterThan(-1e-5 * speed * dt), $"from {position.y} m");
                }
            }
        }

        private static FluidSolverSettings CollisionSettings()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings.Gravity = Vector3.zero;
            settings = settings.WithOwn((ref ThesisSettings own) => own.Stiffness = 1e-6f);
            settings.Viscosity = 0f;
            return settings;
        }

        private static Double3 Collide(in FluidSolverSettings settings, ReferenceMesh mesh, Vector3 position, Vector3 velocity)
        {
            using (var rig = new ThesisRig(settings, new[] { At(position, velocity) }))
            {
                rig.SetMeshes(new[] { mesh });
                Run(rig, out _, out Double3[] acceleration);
                return acceleration[0];
            }
        }

        private static Double3 FirstAcceleration(in FluidSolverSettings settings, FluidParticle[] particles)
        {
            using (var rig = new ThesisRig(settings, particles))
            {
                Run(rig, out _, out Double3[] acceleration);
                return acceleration[0];
            }
        }

        private static void Run(ThesisRig rig, out FluidParticle[] particles, out Double3[] acceleration)
        {
            rig.RunNeighbourSetup();
            var force = new CalculateForcePass(rig.Shaders);
            var pass = new CalculateAccelerationPass(rig.Shaders);
            GpuTest.Run(cmd =>
            {
                force.Record(cmd, rig.State);
                pass.Record(cmd, rig.State, rig.Step);
            });
            particles = rig.ReadParticles();
            acceleration = rig.ReadAcceleration().Select(a => (Double3)(Vector3)a).ToArray();
        }

        private static FluidParticle At(Vector3 position, Vector3 velocity) => new FluidParticle(position, velocity, 0);

        private static Double3 Rounded(Double3 v) => new Double3((float)v.X, (float)v.Y, (float)v.Z);
    }
}
