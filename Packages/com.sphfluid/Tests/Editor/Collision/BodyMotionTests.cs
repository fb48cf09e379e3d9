using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>Bodies follow colliders of any affine motion from where they were, and say which motions they cannot follow.</summary>
    public sealed class BodyMotionTests
    {
        private ColliderRig rig;
        private GameObject parent;

        [SetUp]
        public void SetUp()
        {
            rig = new ColliderRig();
            parent = new GameObject("parent");
        }

        [TearDown]
        public void TearDown()
        {
            rig.Dispose();
            Object.DestroyImmediate(parent);
        }

        private FluidObstacle Gather()
        {
            rig.Gather();
            return rig.Scene.Solids.Single();
        }

        // As the shader places them, in double.
        private static List<Vector3> Corners(BodyMotion motion, bool end)
        {
            AffineMap pose = end
                ? AffineMap.FromMatrix(Matrix4x4.TRS(motion.Position1, motion.Rotation1, Vector3.one)) * motion.Stretch1.Map
                : AffineMap.FromMatrix(Matrix4x4.TRS(motion.Position0, motion.Rotation0, Vector3.one)) * motion.Stretch0.Map;
            return (end && motion.Deformation != null ? motion.Deformation.End : motion.Mesh).Vertices.Select(v => pose.Apply(v)).ToList();
        }

        private static float Farthest(IReadOnlyList<Vector3> a, IReadOnlyList<Vector3> b) =>
            Enumerable.Range(0, a.Count).Max(i => (a[i] - b[i]).magnitude);

        private Collider NewCollider(string kind)
        {
            switch (kind)
            {
                case "mesh": return rig.AddMesh(TestMeshes.Cube());
                case "box":
                    BoxCollider box = rig.Add<BoxCollider>();
                    box.size = new Vector3(0.5f, 1.2f, 0.8f);
                    box.center = new Vector3(0.1f, -0.2f, 0.3f);
                    return box;
                case "sphere":
                    SphereCollider sphere = rig.Add<SphereCollider>();
                    sphere.center = new Vector3(0.2f, 0f, -0.1f);
                    return sphere;
                default:
                    CapsuleCollider capsule = rig.Add<CapsuleCollider>();
                    capsule.height = 1.7f;
                    capsule.direction = kind == "capsule x" ? 0 : 2;
                    return capsule;
            }
        }

        [TestCase("mesh")]
        [TestCase("box")]
        public void CornersFollowAnyAffineMotionAndAFrameBeginsWhereTheLastEnded(string kind)
        {
            Collider collider = NewCollider(kind);
            collider.transform.SetParent(parent.transform, false);
            collider.transform.localScale = new Vector3(-1f, 1f, 1f); // mirrored throughout, which is no jump
            var motion = new BodyMotion(Gather());
            var random = new System.Random(1);
            int outgrown = 0;
            for (int frame = 0; frame < 60; frame++)
            {
                float swing = Mathf.Sin(0.2f * frame);
                parent.transform.localScale = new Vector3(1f + 0.6f * swing, 1f, 1f - 0.5f * swing);
                parent.transform.localPosition = 0.3f * ParticleSets.RandomVector(random);
                collider.transform.localRotation = Quaternion.Euler(9f * frame, 5f * frame, 3f);
                collider.transform.localScale = new Vector3(-1f - 0.02f * frame, 1f + 0.03f * frame, 1f);
                if (collider is BoxCollider box) box.center = 0.1f * swing * Vector3.up;
                List<Vector3> before = Corners(motion, true);
                motion.Arrive();
                FluidObstacle solid = Gather();
                BodyFollowing following = motion.MoveTo(solid);
                outgrown += following == BodyFollowing.CellsOutgrown ? 1 : 0;
                Assert.That(following, Is.EqualTo(BodyFollowing.Followed).Or.EqualTo(BodyFollowing.CellsOutgrown));
                Assert.That(Farthest(Corners(motion, false), before), Is.LessThan(2e-6f), $"frame {frame} begins where the last ended");
                Assert.That(Farthest(Corners(motion, true), solid.Mesh.Vertices), Is.LessThan(3e-5f),
                    $"frame {frame} ends at the collider");
                Assert.That(motion.FrameRange().least, Is.GreaterThanOrEqualTo(motion.CellStretch));
            }
            Assert.That(outgrown, Is.GreaterThan(1), "cells were made anew in between");
        }

        [TestCase("sphere")]
        [TestCase("capsule x")]
        [TestCase("capsule z")]
        public void RoundCollidersFollowEvenScales(string kind)
        {
            Collider collider = NewCollider(kind);
            collider.transform.localScale = 0.5f * Vector3.one;
            var motion = new BodyMotion(Gather());
            for (int frame = 0; frame < 20; frame++)
            {
                collider.transform.localScale = (0.5f + 0.05f * frame) * Vector3.one;
                collider.transform.localRotation = Quaternion.Euler(20f * frame, 10f * frame, 0f);
                motion.Arrive();
                FluidObstacle solid = Gather();
                Assert.That(motion.MoveTo(solid), Is.EqualTo(BodyFollowing.Followed).Or.EqualTo(BodyFollowing.CellsOutgrown));
                Bounds bounds = new TriangleMesh(Corners(motion, true).ToArray(), motion.Mesh.Indices).Bounds;
                float radius = RoundShape.FromCollider(solid.State).Radius;
                Assert.That((bounds.center - solid.Mesh.Bounds.center).magnitude, Is.LessThan(0.05f * radius));
                Assert.That((bounds.size - solid.Mesh.Bounds.size).magnitude, Is.LessThan(0.2f * radius), "to the error of the chords");
            }
        }

        [Test]
        public void ARigidMotionIsNoStretchHoweverLargeTheMesh()
        {
            MeshCollider collider = rig.AddMesh(TestMeshes.Cube());
            collider.transform.localScale = new Vector3(10f, 0.2f, 7f);
            var motion = new BodyMotion(Gather());
            for (int frame = 1; frame <= 200; frame++)
            {
                collider.transform.localRotation = Quaternion.Euler(1.7f * frame, 3.1f * frame, 0.3f * frame);
                FluidObstacle solid = Gather();
                Assert.That(motion.MoveTo(solid), Is.EqualTo(BodyFollowing.Followed));
                Assert.That(motion.IsStretched, Is.False);
                Assert.That(Farthest(Corners(motion, true), solid.Mesh.Vertices), Is.LessThan(2e-5f));
            }
        }

        [Test]
        public void ALargeMeshThatStretchesALittleDoesNotJump()
        {
            MeshCollider collider = rig.AddMesh(TestMeshes.Cube());
            collider.transform.localScale = 10f * Vector3.one;
            var motion = new BodyMotion(Gather());
            for (int frame = 1; frame <= 100; frame++)
            {
                collider.transform.localScale = 10f * (1f + 3e-5f * frame) * Vector3.one;
                List<Vector3> before = Corners(motion, true);
                motion.Arrive();
                FluidObstacle solid = Gather();
                motion.MoveTo(solid);
                Assert.That(Farthest(Corners(motion, false), before), Is.LessThan(3e-6f));
                Assert.That(Farthest(Corners(motion, true), solid.Mesh.Vertices), Is.LessThan(2e-4f), "a hundred-thousandth of its size");
            }
        }

        // While it moves on as a rigid body.
        private void CheckItSettlesOnce(BodyMotion motion, Transform collider)
        {
            int settled = 0;
            for (int frame = 0; frame < 400; frame++)
            {
                motion.Arrive();
                collider.position = 0.001f * frame * Vector3.right;
                collider.rotation = Quaternion.Euler(0f, 0.2f * frame, 0f);
                motion.MoveTo(Gather());
                List<Vector3> start = Corners(motion, false), end = Corners(motion, true);
                if (!motion.Settle()) continue;
                settled++;
                Assert.That(Farthest(Corners(motion, false), start), Is.LessThan(2e-6f));
                Assert.That(Farthest(Corners(motion, true), end), Is.LessThan(2e-6f));
            }
            Assert.That(settled, Is.EqualTo(1));
            Assert.That(Farthest(Corners(motion, true), Gather().Mesh.Vertices), Is.LessThan(1e-5f));
        }

        [Test]
        public void AStretchThatLastsBecomesTheShape()
        {
            BoxCollider box = rig.Add<BoxCollider>();
            var motion = new BodyMotion(Gather());
            box.transform.localScale = new Vector3(1.3f, 1f, 1f);
            Assert.That(motion.MoveTo(Gather()), Is.EqualTo(BodyFollowing.CellsOutgrown), "cells of a stretched body look farther");
            Assert.That(motion.IsStretched, Is.True);
            CheckItSettlesOnce(motion, box.transform);
            Assert.That(motion.IsStretched, Is.False);
        }

        [Test]
        public void WhatCannotBeFollowedIsSaid()
        {
            BoxCollider box = rig.Add<BoxCollider>("gate");
            FluidObstacle start = Gather();
            BodyFollowing After(Vector3 scale)
            {
                var motion = new BodyMotion(start);
                box.transform.localScale = scale;
                return motion.MoveTo(Gather());
            }
            Assert.That(After(new Vector3(-1f, 1f, 1f)), Is.EqualTo(BodyFollowing.Mirrored));
            Assert.That(After(0.05f * Vector3.one), Is.EqualTo(BodyFollowing.Scaled));
            Assert.That(After(new Vector3(1f, 30f, 1f)), Is.EqualTo(BodyFollowing.Scaled));
            Assert.That(After(0.3f * Vector3.one), Is.EqualTo(BodyFollowing.CellsOutgrown), "to less than half in one frame");
            Assert.That(After(new Vector3(-1f, -1f, 1f)), Is.EqualTo(BodyFollowing.Followed), "half a turn");

            foreach (BodyFollowing reason in new[] { BodyFollowing.Mirrored, BodyFollowing.Scaled, BodyFollowing.Reshaped,
                BodyFollowing.TooFar })
            {
                FluidMessage message = new BodyJump(box, reason).Message;
                Assert.That(message.Context, Is.SameAs(box));
                Assert.That(message.Issue, Is.EqualTo(FluidIssue.ColliderJumped));
                Assert.That(message.ToString(), Does.StartWith("[SPH Fluid] 'gate'").And.Contain("put at its new place at once"));
                Assert.That(message.Cure, Is.Not.Empty);
            }
        }

        [Test]
        public void CornersOfAMeshThatDeformsFollowItAsItMovesAndIsScaled()
        {
            Mesh mesh = TestMeshes.Cube();
            Vector3[] rest = mesh.vertices;
            MeshCollider collider = rig.AddMesh(mesh);
            var motion = new BodyMotion(Gather());
            var random = new System.Random(3);
            for (int frame = 0; frame < 40; frame++)
            {
                collider.transform.localRotation = Quaternion.Euler(9f * frame, 5f * frame, 3f);
                collider.transform.localPosition = 0.3f * ParticleSets.RandomVector(random);
                collider.transform.localScale = new Vector3(1f + 0.02f * frame, 1f, 1f - 0.01f * frame);
                if (frame >= 10 && frame % 3 != 0)
                {
                    mesh.vertices = rest.Select(v => (1f + 0.3f * Mathf.Sin(v.x + 0.4f * frame)) * v).ToArray();
                    mesh.RecalculateBounds();
                }
                List<Vector3> before = Corners(motion, true);
                motion.Arrive();
                FluidObstacle solid = Gather();
                BodyFollowing following = motion.MoveTo(solid);
                if (frame == 10) Assert.That(following, Is.EqualTo(BodyFollowing.CellsOutgrown), "it begins to deform");
                if (frame > 10) Assert.That(following, Is.EqualTo(BodyFollowing.Followed));
                Assert.That(motion.Deformation != null, Is.EqualTo(frame >= 10));
                Assert.That(Farthest(Corners(motion, false), before), Is.LessThan(2e-6f), $"frame {frame} begins where the last ended");
                Assert.That(Farthest(Corners(motion, true), solid.Mesh.Vertices), Is.LessThan(1e-5f),
                    $"frame {frame} ends at the collider");
                if (frame >= 10) Assert.That(motion.IsStretched, Is.False, "corners have the scale");
            }
        }

        [Test]
        public void AMeshThatDeformsNoMoreBecomesARigidBody()
        {
            Mesh mesh = TestMeshes.Cube();
            MeshCollider collider = rig.AddMesh(mesh);
            var motion = new BodyMotion(Gather());
            mesh.vertices = mesh.vertices.Select(v => v.y > 0f ? 1.3f * v : v).ToArray();
            mesh.RecalculateBounds();
            Assert.That(motion.MoveTo(Gather()), Is.EqualTo(BodyFollowing.CellsOutgrown), "it has lists of its own");
            CheckItSettlesOnce(motion, collider.transform);
            Assert.That(motion.Deformation, Is.Null);
        }

        [Test]
        public void OtherTrianglesAndAnUnevenCapsuleAreAnotherShape()
        {
            Mesh mesh = TestMeshes.Cube();
            MeshCollider collider = rig.AddMesh(mesh);
            var motion = new BodyMotion(Gather());
            mesh.triangles = mesh.triangles.Skip(3).ToArray();
            Assert.That(motion.MoveTo(Gather()), Is.EqualTo(BodyFollowing.Reshaped));
            collider.transform.localScale = new Vector3(-1f, 1f, 1f);
            Assert.That(motion.MoveTo(Gather()), Is.EqualTo(BodyFollowing.Mirrored));
            collider.enabled = false;

            CapsuleCollider capsule = rig.Add<CapsuleCollider>();
            capsule.height = 3f;
            motion = new BodyMotion(Gather());
            capsule.transform.localScale = new Vector3(1f, 1.2f, 1f);
            Assert.That(motion.MoveTo(Gather()), Is.EqualTo(BodyFollowing.Reshaped), "its caps stay round");
        }

        [Test]
        public void JumpsAreCountedNamedAndReportedOnceAFrame()
        {
            GpuTest.Require();
            BoxCollider box = rig.Add<BoxCollider>("gate");
            using (var bodies = new CollisionBodies(BodyRig.Water(rig.DomainSize, rig.Spacing, 1f)))
            {
                bodies.Update(new[] { Gather() });
                box.transform.localScale = new Vector3(1.2f, 1f, 1f);
                bodies.Update(new[] { Gather() });
                Assert.That(bodies.Jumps, Is.Zero);
                Assert.That(bodies.HasStretch && bodies.IsUnderWay, Is.True);
                box.transform.localScale = new Vector3(-1.2f, 1f, 1f);
                bodies.Update(new[] { Gather() });
                Assert.That(bodies.NewJumps.Single().Reason, Is.EqualTo(BodyFollowing.Mirrored));
                Assert.That(bodies.HasStretch, Is.False, "it is a new body");
                bodies.Update(rig.Scene.Solids);
                Assert.That(bodies.NewJumps, Is.Empty);
                Assert.That(bodies.Jumps, Is.EqualTo(1));
            }
        }
    }
}
