using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Walls that hold the liquid: a = −ν (v − v_wall)/(d dx) along the wall where d &lt; dx, a step taking the whole difference at most.
    /// </summary>
    public sealed class WallDragTests
    {
        private const float Spacing = 0.02f;

        private static readonly Vector3 Domain = new Vector3(0.13f, 0.11f, 0.09f);

        [TestCase(1, 0.01f, FluidAxes.None, 1f)]
        [TestCase(255, 0.01f, FluidAxes.None, 1f)]
        [TestCase(257, 0.01f, FluidAxes.Y, 0.3f)]
        [TestCase(1009, 0.01f, FluidAxes.X | FluidAxes.Z, 1f)]
        [TestCase(1009, 3f, FluidAxes.None, 0.7f)]
        public void DomainFacesDragAsTheFormulaSays(int count, float kinematic, FluidAxes periodic, float friction)
        {
            FluidSolverSettings settings = Settings(kinematic);
            settings.SupportRadius = 0.02f; // so that the small box may be periodic
            settings.Boundaries = Moving(periodic);
            settings.Boundaries.Friction = friction;
            FluidParticle[] particles = ParticleSets.Random(count, Domain, 2f, count);
            Double3[] acceleration = Accelerate(settings, particles);
            int dragged = 0;
            for (int i = 0; i < count; i++)
            {
                Double3 expected = Expected(particles[i], settings);
                dragged += expected.Length > 0.0 ? 1 : 0;
                Assert.That((acceleration[i] - expected).Length, Is.LessThanOrEqualTo(2e-5 * (expected.Length + 1.0)),
                    $"particle {i} at {particles[i].Position}");
            }

            Assert.That(dragged, Is.GreaterThan(count / 4).Or.EqualTo(count), "the set exercises the drag");
        }

        [Test]
        public void AMovingWallDragsTheFirstLayerOnly()
        {
            // Layers at 0.5, 1.5 ... dx over the floor.
            var counts = new Vector3Int(4, 5, 4);
            FluidSolverSettings settings = Settings(1e-3f);
            settings.DomainSize = new Vector3(1f, counts.y * Spacing, 1f);
            settings.Boundaries = new FluidBoundaries { NoSlip = true, LowY = new Vector3(2f, 0f, -1f) };
            FluidParticle[] particles = ParticleSets.Lattice(counts, Spacing, 0f, 1);
            Double3[] acceleration = Accelerate(settings, particles);
            double rate = 1e-3 / (0.5 * Spacing * Spacing);
            for (int i = 0; i < particles.Length; i++)
            {
                int layer = i / counts.x % counts.y;
                Double3 expected = layer == 0 ? new Double3(2.0 * rate, 0.0, -rate) : Double3.Zero;
                Assert.That((acceleration[i] - expected).Length, Is.LessThan(1e-4 * rate), $"layer {layer}");
            }
        }

        [Test]
        public void OneStepTakesTheWholeDifferenceAtMost()
        {
            FluidSolverSettings settings = Settings(100f);
            settings.Boundaries = new FluidBoundaries { NoSlip = true, LowY = new Vector3(0.5f, 0f, 0f) };
            var particle = new FluidParticle(new Vector3(0f, -0.4999f * Domain.y, 0f), new Vector3(-2f, 0f, 3f), 0);
            Double3 a = Accelerate(settings, new[] { particle })[0];
            Assert.That(-2.0 + a.X * settings.TimeStep, Is.EqualTo(0.5).Within(1e-5), "the wall's velocity, not beyond");
            Assert.That(3.0 + a.Z * settings.TimeStep, Is.EqualTo(0.0).Within(1e-5));
        }

        [TestCase(0.3f, 1f)]
        [TestCase(-0.3f, 1f)]
        [TestCase(0.9f, 1f)]
        [TestCase(1.01f, 0f)]
        public void AMeshDragsAlongItsPlane(float distance, float acts)
        {
            FluidSolverSettings settings = Settings(1e-3f);
            settings.Boundaries.NoSlip = true;
            ReferenceMesh sheet = MeshShapes.Triangle(new Double3(-9, 0, -9), new Double3(0, 0, 9), new Double3(9, 0, -9));
            var velocity = new Vector3(0.5f, 0.25f, -1f);
            var particle = new FluidParticle(new Vector3(0.003f, distance * Spacing, 0.004f), velocity, 0);
            Double3 a = Accelerate(settings, new[] { particle }, sheet)[0];
            double rate = acts * 1e-3 / (Math.Abs(distance) * Spacing * Spacing);
            Assert.That((a - new Double3(-0.5 * rate, 0.0, rate)).Length, Is.LessThan(1e-4 * (rate + 1.0)));
        }

        [Test]
        public void TwoMeshesStopAParticleWithoutThrowingItBack()
        {
            // Between two plates, both so rough that each alone would take the whole velocity.
            FluidSolverSettings settings = Settings(100f);
            settings.Boundaries.NoSlip = true;
            ReferenceMesh[] plates = new[] { -0.004, 0.004 }
                .Select(y => MeshShapes.Triangle(new Double3(-0.2, y, -0.1), new Double3(0, y, 0.3), new Double3(0.2, y, -0.1))).ToArray();
            var particle = new FluidParticle(Vector3.zero, new Vector3(1f, 0f, -2f), 0);
            Double3 a = Accelerate(settings, new[] { particle }, plates)[0];
            Assert.That(((Double3)particle.VelT0 + settings.TimeStep * a).Length, Is.LessThan(1e-5));
        }

        [Test]
        public void InsideAClosedMeshTheDragIsFull()
        {
            FluidSolverSettings settings = Settings(1e-5f);
            settings.DomainSize = Vector3.one;
            settings.Boundaries.NoSlip = true;
            ReferenceMesh box = MeshShapes.Box(Double3.Zero, new Double3(0.05, 0.05, 0.05), 1);
            box.Closed = true;
            var particle = new FluidParticle(new Vector3(0.01f, 0.045f, 0.013f), new Vector3(1f, 0f, 0f), 0);
            Double3 a = Accelerate(settings, new[] { particle }, box)[0];
            double rate = 1e-5 / (0.05 * Spacing * Spacing);
            Assert.That(a.X, Is.EqualTo(-rate).Within(1e-4 * rate));
        }

        [Test]
        public void WallsThatOnlyPushDoNotDrag()
        {
            FluidSolverSettings settings = Settings(1f);
            FluidParticle[] particles = ParticleSets.Random(300, Domain, 2f, 3);
            Assert.That(Accelerate(settings, particles).Max(a => a.Length), Is.Zero);
        }

        // No push, no gravity, no force of the liquid: what is left is the drag.
        private static FluidSolverSettings Settings(float kinematic)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings.Gravity = Vector3.zero;
            settings = settings.WithOwn((ref ThesisSettings own) => own.WallStiffness = 0f);
            settings = settings.WithOwn((ref ThesisSettings own) => own.WallDamping = 0f);
            settings.OctantSearch = false;
            settings.Viscosity = kinematic * settings.RestDensity;
            return settings;
        }

        private static FluidBoundaries Moving(FluidAxes periodic)
        {
            bool x = (periodic & FluidAxes.X) == 0;
            bool y = (periodic & FluidAxes.Y) == 0;
            bool z = (periodic & FluidAxes.Z) == 0;
            return new FluidBoundaries
            {
                Periodic = periodic,
                NoSlip = true,
                LowX = x ? new Vector3(0f, 1f, -0.5f) : Vector3.zero,
                HighX = x ? new Vector3(0f, -2f, 0f) : Vector3.zero,
                LowY = y ? new Vector3(0.25f, 0f, 1f) : Vector3.zero,
                HighY = y ? new Vector3(3f, 0f, 0f) : Vector3.zero,
                LowZ = z ? new Vector3(-1f, 0.5f, 0f) : Vector3.zero,
                HighZ = z ? new Vector3(0f, 0.75f, 0f) : Vector3.zero,
            };
        }

        // Face by face, then component by component.
        private static Double3 Expected(in FluidParticle particle, FluidSolverSettings s)
        {
            FluidBoundaries walls = s.Boundaries;
            Vector3[] low = { walls.LowX, walls.LowY, walls.LowZ };
            Vector3[] high = { walls.HighX, walls.HighY, walls.HighZ };
            var rates = new double[3];
            var drives = new double[3];
            for (int face = 0; face < 6; face++)
            {
                int axis = face / 2;
                if (((int)walls.Periodic >> axis & 1) != 0) continue;

                double distance = 0.5 * s.DomainSize[axis] + (face % 2 == 0 ? 1.0 : -1.0) * particle.Position[axis];
                double rate = distance < s.Spacing
                    ? walls.Friction * s.Viscosity / s.RestDensity / (Math.Max(distance, 0.05 * s.Spacing) * s.Spacing) : 0.0;
                for (int along = 0; along < 3; along++)
                {
                    if (along != axis)
                    {
                        rates[along] += rate;
                        drives[along] += rate * ((face % 2 == 0 ? low : high)[axis][along] - particle.VelT0[along]);
                    }
                }
            }

            double[] a = rates.Zip(drives, (rate, drive) => rate * s.TimeStep > 1.0 ? drive / (rate * s.TimeStep) : drive).ToArray();
            return new Double3(a[0], a[1], a[2]);
        }

        private static Double3[] Accelerate(in FluidSolverSettings settings, FluidParticle[] particles, params ReferenceMesh[] meshes)
        {
            using (var rig = new ThesisRig(settings, particles))
            {
                if (meshes.Length > 0) rig.SetMeshes(meshes);

                rig.State.Published.Density.SetData(particles.Select(_ => 1000f).ToArray());
                rig.State.Buffers.Force.SetData(new Vector4[particles.Length]);
                var pass = new CalculateAccelerationPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State, rig.Step));
                return rig.ReadAcceleration().Select(a => (Double3)(Vector3)a).ToArray();
            }
        }
    }
}
