using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Steps are timed on the device: something is measured, with how many particles is said, and the liquid itself is not touched.
    /// </summary>
    public sealed class StepCalibrationTests
    {
        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp()
        {
            GpuTest.Require();
            shaders = TestShaders.CreateSet();
        }

        [TearDown]
        public void TearDown() => Object.DestroyImmediate(shaders);

        [TestCase(1)]
        [TestCase(257)]
        public void TheStepsOfALiquidAreTimed(int count)
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, 0.05f, 0.3f);
            List<FluidParticle> particles = Lattice(count);
            FluidParticle[] before = particles.ToArray();
            var clock = Stopwatch.StartNew();
            using (var collision = new CollisionScene())
            {
                StepCost? cost = StepCalibration.Measure(settings, shaders, particles, collision);
                Assert.That(cost.HasValue);
                Assert.That(cost.Value.Particles, Is.EqualTo(count));
                Assert.That(cost.Value.Milliseconds, Is.GreaterThan(0.0).And.LessThan(1e3 * clock.Elapsed.TotalSeconds));
                Assert.That(cost.Value.InPlay, Is.False);
            }
            Assert.That(particles, Is.EqualTo(before));
        }

        [Test]
        public void NoParticlesAreNotTimed()
        {
            using (var collision = new CollisionScene())
                Assert.That(StepCalibration.Measure(BodyRig.Water(Vector3.one, 0.05f, 0.3f), shaders, new List<FluidParticle>(), collision),
                    Is.Null);
        }

        [Test]
        public void ADeviceThatCannotRunTheMethodIsNotTimed()
        {
            FluidShaderSet empty = ScriptableObject.CreateInstance<FluidShaderSet>();
            using (var collision = new CollisionScene())
                Assert.That(StepCalibration.Measure(BodyRig.Water(Vector3.one, 0.05f, 0.3f), empty, Lattice(8), collision), Is.Null);
            Object.DestroyImmediate(empty);
        }

        [Test]
        public void APartIsWholeLayersAboutTheMiddle()
        {
            List<FluidParticle> cube = Lattice(27 * 27 * 27);
            IReadOnlyList<FluidParticle> part = StepCalibration.Middle(cube, 1000, 0.025f);
            Assert.That(part.Count, Is.EqualTo(11 * 11 * 11), "the first odd cube that holds as many");
            Vector3 size = part.Aggregate(Vector3.zero, (most, p) => Vector3.Max(most, p.Position)) -
                part.Aggregate(Vector3.one, (least, p) => Vector3.Min(least, p.Position));
            Assert.That((size - 0.25f * Vector3.one).magnitude, Is.LessThan(1e-4f));
            Assert.That(StepCalibration.Middle(Lattice(1999), 1000, 0.05f).Count, Is.EqualTo(1999), "few more are all timed");
        }

        // A cube of particles, the first ones of it, about the origin of the whole cube.
        private static List<FluidParticle> Lattice(int count)
        {
            int side = Mathf.CeilToInt(Mathf.Pow(count, 1f / 3f) - 1e-4f);
            var particles = new List<FluidParticle>();
            for (int i = 0; i < count; i++)
            {
                var cell = new Vector3(i % side, i / side % side, i / side / side);
                particles
                    .Add(new FluidParticle(0.05f * (cell - 0.5f * (side - 1) * Vector3.one) * (side > 18 ? 0.5f : 1f),
                        Vector3.zero, (uint)i));
            }
            return particles;
        }
    }
}
