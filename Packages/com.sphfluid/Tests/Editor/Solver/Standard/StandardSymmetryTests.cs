using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A liquid in a box of triangles goes as its image does: turned, mirrored, elsewhere and at another scale.</summary>
    public sealed class StandardSymmetryTests
    {
        private const float Spacing = 0.02f;
        private const int Steps = 8; // from rounding, 4e-7 dx in the first step, differences grow twentyfold in sixteen
        private static readonly Vector3 Domain = new Vector3(0.64f, 0.6f, 0.56f), Box = new Vector3(0.2f, 0.24f, 0.16f);
        private static readonly Vector3 Gravity = new Vector3(0.3f, -9.81f, 0.2f);

        /// <summary>Where points of the first liquid are in the second one.</summary>
        private struct Image
        {
            public Quaternion Turn;
            public bool IsMirrored; // along x, before it turns
            public float Scale;
            public Vector3 Shift;

            public Vector3 Vector(Vector3 v) => Turn * (IsMirrored ? new Vector3(-v.x, v.y, v.z) : v);
            public Vector3 Point(Vector3 p) => Scale * Vector(p) + Shift;
        }

        private static Image Turned(Quaternion turn) => new Image { Turn = turn, Scale = 1f };

        [TestCase(0f, 1f, 0f, 90f, 5e-5)]
        [TestCase(0f, 1f, 0f, 180f, 5e-5)]
        [TestCase(1f, 0f, 0f, 90f, 5e-5)]
        [TestCase(1f, 2f, 3f, 40f, 2e-4)]
        [TestCase(0f, 0f, 1f, -17f, 2e-4)]
        [TestCase(1f, 2f, 3f, 40f, 2e-4, true)]
        public void TurnedItGoesAsItDid(float x, float y, float z, float degrees, double within, bool isCorrected = false) =>
            Check(Turned(Quaternion.AngleAxis(degrees, new Vector3(x, y, z))), within, isCorrected);

        [TestCase(2e-5)]
        [TestCase(5e-5, true)]
        public void MirroredItGoesAsItDid(double within, bool isCorrected = false) =>
            Check(new Image { Turn = Quaternion.identity, IsMirrored = true, Scale = 1f }, within, isCorrected);

        [Test]
        public void ElsewhereItGoesAsItDid() =>
            Check(new Image { Turn = Quaternion.identity, Scale = 1f, Shift = new Vector3(0.0137f, 0.0071f, -0.0093f) }, 5e-5);

        [TestCase(4f, 1e-6)] // lengths, times and speeds by powers of two: no digit changes
        [TestCase(0.25f, 1e-6)]
        [TestCase(3f, 5e-5)]
        public void ItsScaleIsThatOfFroude(float scale, double within) =>
            Check(new Image { Turn = Quaternion.identity, Scale = scale }, within);

        private static void Check(Image image, double within, bool isCorrected = false)
        {
            (FluidParticle[] first, FluidSolverSettings settings) = Play(Turned(Quaternion.identity), isCorrected);
            (FluidParticle[] second, FluidSolverSettings its) = Play(image, isCorrected);
            double speed = Math.Sqrt(image.Scale), fastest = first.Max(p => (double)p.VelT0.magnitude);
            Assert.That(its.TimeStep, Is.EqualTo(speed * settings.TimeStep).Within(1e-6 * its.TimeStep));
            Assert.That(first.Length, Is.EqualTo(second.Length));
            double place = 0.0, velocity = 0.0;
            for (int i = 0; i < first.Length; i++)
            {
                place = Math.Max(place, (second[i].Position - image.Point(first[i].Position)).magnitude / (image.Scale * Spacing));
                velocity =
                    Math.Max(velocity, (second[i].VelT0 - (float)speed * image.Vector(first[i].VelT0)).magnitude / (speed * fastest));
            }
            TestContext.WriteLine($"places {place:g3} dx, velocities {velocity:g3} of the fastest");
            Assert.That(place, Is.LessThan(within), "places, dx");
            Assert.That(velocity, Is.LessThan(10.0 * within), "velocities, of the fastest");
        }

        // 400 particles thrown into a corner of the box, by number.
        private static (FluidParticle[], FluidSolverSettings) Play(Image image, bool isCorrected)
        {
            Vector3 side = image.Scale * (image.Turn == Quaternion.identity ? Domain : 0.72f * Vector3.one);
            double time = Math.Sqrt(image.Scale);
            FluidRuleInput input = FluidRuleInput.Water;
            input.Method = FluidMethodKind.Standard;
            input.DomainSize = side;
            input.Spacing = image.Scale * Spacing;
            input.LiquidHeight = input.LiquidDepth = image.Scale * Box.y;
            input.MinSpeed = (float)time;
            input.Gravity = image.Vector(Gravity);
            input.GradientCorrection = isCorrected;
            input.KinematicViscosity *= image.Scale * image.Scale / (float)time;
            FluidSolverSettings settings = FluidRules.Derive(input);
            using (var rig = new BodyRig(settings))
            {
                Transform box = rig.AddBox(image.Scale * Box);
                (box.position, box.rotation) = (image.Point(Vector3.zero), image.Turn);
                FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(8, 8, 6), Spacing, 0.1f * Spacing, 7);
                for (int i = 0; i < start.Length; i++)
                {
                    Vector3 p = start[i].Position + new Vector3(0.009f, -0.035f, 0.011f);
                    Vector3 v = new Vector3(0.4f, -0.5f, 0.3f) + 4f * new Vector3(-p.y, p.x, 0f);
                    start[i].Position = image.Point(p);
                    start[i].VelT0 = (float)time * image.Vector(v);
                }
                rig.Start(start);
                rig.Frame(Steps);
                return (rig.Particles().OrderBy(p => p.Id).ToArray(), settings);
            }
        }
    }
}
