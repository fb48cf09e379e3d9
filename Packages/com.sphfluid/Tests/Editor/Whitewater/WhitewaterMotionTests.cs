using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What whitewater is and where it goes, against the paper's rules over all particles in double precision.</summary>
    public sealed class WhitewaterMotionTests
    {
        private const float Duration = 1f / 40f;

        [TestCase(FluidMethodKind.Standard, 0, FluidAxes.None, FluidFaces.None)]
        [TestCase(FluidMethodKind.Standard, 1, FluidAxes.None, FluidFaces.None)]
        [TestCase(FluidMethodKind.Standard, 255, FluidAxes.None, FluidFaces.HighY)]
        [TestCase(FluidMethodKind.Standard, 256, FluidAxes.X | FluidAxes.Z, FluidFaces.None)]
        [TestCase(FluidMethodKind.Standard, 257, FluidAxes.Y, FluidFaces.LowX | FluidFaces.HighX)]
        [TestCase(FluidMethodKind.Standard, 2003, FluidAxes.None, FluidFaces.None)]
        [TestCase(FluidMethodKind.Thesis, 1009, FluidAxes.None, FluidFaces.None)]
        public void PiecesMoveAsTheReferenceDoes(FluidMethodKind method, int count, FluidAxes periodic, FluidFaces open)
        {
            FluidSolverSettings settings = WhitewaterRig.Settings(method, periodic, open);
            // The lower part is full, the upper part is not.
            FluidParticle[] full = ParticleSets.Lattice(new Vector3Int(18, 6, 16), WhitewaterRig.Spacing, 0.01f, 3);
            for (int i = 0; i < full.Length; i++)
            {
                full[i].Position.y -= 0.22f;
                full[i].VelT0 = full[i].VelT1 = new Vector3(1f, 0.5f, -0.5f) + full[i].Position;
            }
            FluidParticle[] spread = ParticleSets.Random(1500, 0.99f * WhitewaterRig.Domain, 2f, 4);
            for (int i = 0; i < spread.Length; i++) spread[i].Id += (uint)full.Length;
            WhitewaterPiece[] pieces = WhitewaterPiece.Random(count, 0.99f * WhitewaterRig.Domain, 2f, 0.0, count);
            using (var rig = new WhitewaterRig(settings, full.Concat(spread).ToArray(), count + 3))
            {
                rig.Put(pieces);
                WhitewaterPiece[] moved = rig.Move(count, Duration);
                var reference = new WhitewaterReference(rig.Particles, settings);
                var kinds = new int[3];
                int certain = 0;
                for (int i = 0; i < count; i++)
                {
                    if (!(reference.Move(pieces[i], Duration) is WhitewaterPiece expected)) continue;
                    certain++;
                    kinds[expected.Kind]++;
                    Assert.AreEqual(expected.Seed, moved[i].Seed, $"seed and kind of {i}");
                    Assert.AreEqual(0f, (expected.Position - moved[i].Position).magnitude, 2e-5f, $"position of {i}, kind {expected.Kind}");
                    Assert.AreEqual(0f, (expected.Velocity - moved[i].Velocity).magnitude, 1e-3f, $"velocity of {i}, kind {expected.Kind}");
                    Assert.AreEqual(0f, (expected.Normal - moved[i].Normal).magnitude, 2e-3f, $"normal of {i}, kind {expected.Kind}");
                    Assert.AreEqual(expected.Life, moved[i].Life, 1e-4f, $"life of {i}");
                    Assert.AreEqual(expected.Age, moved[i].Age, 1e-5f, $"age of {i}");
                }
                Assert.That(certain, Is.GreaterThanOrEqualTo(0.9 * count));
                if (count > 1000) Assert.That(kinds, Has.All.GreaterThan(50), "spray, foam and bubbles");
            }
        }

        [Test]
        public void SprayEndsOnACollider()
        {
            WhitewaterPiece moved = ShotAtAPlate(Vector3.zero, liquid: false, out Vector3 place);
            Assert.That(moved.Life, Is.Zero);
            Assert.That(place.x, Is.InRange(-0.06f, -0.05f), "in front of the plate");
        }

        [Test]
        public void BubblesStopBeforeACollider()
        {
            WhitewaterPiece moved = ShotAtAPlate(Vector3.zero, liquid: true, out Vector3 place);
            Assert.That(moved.Life, Is.GreaterThan(0f));
            Assert.That(moved.Kind, Is.EqualTo(WhitewaterPiece.Bubble));
            Assert.That(place.x, Is.InRange(-0.06f, -0.05f), "in front of the plate");
        }

        [Test]
        public void AColliderThatMovesMeetsSprayThatRests()
        {
            WhitewaterPiece moved = ShotAtAPlate(new Vector3(-0.1f, 0f, 0f), liquid: false, out Vector3 place);
            Assert.That(moved.Life, Is.Zero);
            Assert.That(place.x, Is.InRange(-0.16f, -0.15f), "before the plate where it is now");
        }

        // A plate from x = -0.05 to 0.05; a piece flies at it, in liquid or in air, or it moves at a piece that rests.
        private static WhitewaterPiece ShotAtAPlate(Vector3 motion, bool liquid, out Vector3 place)
        {
            FluidSolverSettings settings = WhitewaterRig.Settings(FluidMethodKind.Standard);
            settings.Gravity = 1e-6f * Vector3.down;
            TriangleMesh plate = TriangleMesh.Box(Matrix4x4.Scale(new Vector3(0.1f, 0.7f, 0.8f)));
            FluidParticle[] particles = liquid
                ? ParticleSets.Lattice(new Vector3Int(8, 8, 8), WhitewaterRig.Spacing, 0f, 1)
                : new[] { new FluidParticle(new Vector3(0.4f, 0.3f, 0.3f), Vector3.zero, 0) };
            for (int i = 0; i < particles.Length; i++) particles[i].VelT0 = particles[i].VelT1 = 4f * Vector3.right;
            using (var rig = new WhitewaterRig(settings, particles, 1))
            using (var obstacles = new FluidObstacles(rig.Solver.Settings))
            {
                int mesh = obstacles.Add(plate, Matrix4x4.identity);
                obstacles.Update(Matrix4x4.identity);
                obstacles.MoveTo(mesh, Matrix4x4.Translate(motion));
                obstacles.Update(Matrix4x4.identity);
                rig.Solver.SetObstacles(obstacles);
                GpuTest.Run(rig.Solver.RecordNeighbourSetup);
                rig.Put(
                    new[] { new WhitewaterPiece { Position = new Vector3(-0.1f, 0.01f, 0.02f),
                        Velocity = motion == Vector3.zero ? 4f * Vector3.right : Vector3.zero, Life = 2f } });
                WhitewaterPiece moved = rig.Move(1, Duration)[0];
                place = moved.Position;
                return moved;
            }
        }
    }
}
