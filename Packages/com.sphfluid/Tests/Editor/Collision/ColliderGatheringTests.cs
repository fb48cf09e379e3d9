using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Box, sphere, capsule and mesh colliders become outward triangles where they are, however they are transformed.</summary>
    public sealed class ColliderGatheringTests
    {
        private ColliderRig rig;

        [SetUp]
        public void SetUp() => rig = new ColliderRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        [Test]
        public void BoxColliderFollowsCentreSizeAndTransform()
        {
            BoxCollider box = rig.Add<BoxCollider>();
            box.center = new Vector3(0.5f, 0f, 0f);
            box.size = new Vector3(1f, 0.5f, 0.25f);
            box.transform.position = new Vector3(0f, 1f, 0f);
            box.transform.localScale = new Vector3(1f, 2f, 1f);

            List<CollisionTriangle> triangles = rig.GatherOne();
            Bounds bounds = ColliderRig.BoundsOf(triangles);
            AssertNear(bounds.min, new Vector3(0f, 0.5f, -0.125f));
            AssertNear(bounds.max, new Vector3(1f, 1.5f, 0.125f));
            Assert.That(ColliderRig.Volume(triangles), Is.EqualTo(0.25).Within(1e-4));
        }

        [Test]
        public void SphereColliderStaysRoundUnderUnevenScale()
        {
            SphereCollider sphere = rig.Add<SphereCollider>();
            sphere.radius = 0.25f;
            sphere.transform.localScale = new Vector3(1f, 2f, 0.5f);
            List<CollisionTriangle> triangles = rig.GatherOne();
            foreach (CollisionTriangle t in triangles) Assert.That(t.A.magnitude, Is.EqualTo(0.5f).Within(1e-4f));
            Assert.That(ColliderRig.Volume(triangles), Is.EqualTo(4.0 / 3.0 * Math.PI * 0.125).Within(6).Percent);
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        public void CapsuleColliderFollowsItsAxis(int direction)
        {
            CapsuleCollider capsule = rig.Add<CapsuleCollider>();
            capsule.direction = direction;
            capsule.radius = 0.2f;
            capsule.height = 1.2f;
            Bounds bounds = ColliderRig.BoundsOf(rig.GatherOne());
            for (int axis = 0; axis < 3; axis++)
            {
                Assert.That(bounds.extents[axis], Is.EqualTo(axis == direction ? 0.6f : 0.2f).Within(0.01f), $"axis {axis}");
            }
        }

        [Test]
        public void CapsuleShorterThanItsDiameterIsASphere()
        {
            CapsuleCollider capsule = rig.Add<CapsuleCollider>();
            capsule.radius = 0.3f;
            capsule.height = 0.1f;
            foreach (CollisionTriangle t in rig.GatherOne()) Assert.That(t.B.magnitude, Is.EqualTo(0.3f).Within(1e-4f));
        }

        [Test]
        public void ACharacterControllerStandsUprightHoweverItsObjectIsTurned()
        {
            CharacterController character = rig.Add<CharacterController>();
            character.center = new Vector3(0f, 0.5f, 0f);
            character.radius = 0.2f;
            character.height = 1.2f;
            character.transform.rotation = Quaternion.Euler(0f, 0f, 90f);
            character.transform.localScale = new Vector3(1.5f, 1f, 1f);
            Bounds bounds = ColliderRig.BoundsOf(rig.GatherOne());
            AssertNear(bounds.center, new Vector3(-0.5f, 0f, 0f), 0.01f);
            AssertNear(bounds.extents, new Vector3(0.3f, 0.6f, 0.3f), 0.01f);
        }

        [TestCase(1f, 1f, 1f)]
        [TestCase(-1f, 1f, 1f)]
        [TestCase(-2f, -0.5f, -1f)]
        [TestCase(0.5f, 3f, -1f)]
        public void MeshColliderIsOutwardUnderRotationScaleAndMirroring(float x, float y, float z)
        {
            MeshCollider collider = rig.AddMesh(TestMeshes.Cube());
            collider.transform.SetPositionAndRotation(new Vector3(0.2f, -0.1f, 0.3f), Quaternion.Euler(30f, 45f, 60f));
            collider.transform.localScale = new Vector3(x, y, z);
            List<CollisionTriangle> triangles = rig.GatherOne();
            Assert.That(triangles.Count, Is.EqualTo(12));
            Assert.That(ColliderRig.Volume(triangles), Is.EqualTo(Math.Abs(x * y * z)).Within(1e-3));
            Assert.That(rig.Scene.Colliders[0].TriangleCount, Is.EqualTo(12u | CollisionCollider.ClosedBit));
        }

        [Test]
        public void TrianglesAreInTheSpaceOfTheTurnedDomain()
        {
            rig.Position = new Vector3(5f, 6f, 7f);
            rig.Rotation = Quaternion.Euler(0f, 90f, 0f);
            BoxCollider box = rig.Add<BoxCollider>();
            box.size = new Vector3(0.2f, 0.4f, 0.6f);
            box.transform.position = new Vector3(5f, 6f, 8f);
            Bounds bounds = ColliderRig.BoundsOf(rig.GatherOne());
            // World +z is the domain's −x: it was turned from z to x by a quarter turn about y.
            AssertNear(bounds.center, new Vector3(-1f, 0f, 0f));
            AssertNear(bounds.size, new Vector3(0.6f, 0.4f, 0.2f));
        }

        [Test]
        public void BoundsAndRangesCoverTheTriangles()
        {
            rig.Add<BoxCollider>("a").transform.position = new Vector3(1f, 0f, 0f);
            rig.Add<BoxCollider>("b").transform.position = new Vector3(-1f, 0f, 0f);
            rig.Gather();
            Assert.That(rig.Scene.Colliders.Count, Is.EqualTo(2));
            uint next = 0;
            foreach (CollisionCollider collider in rig.Scene.Colliders)
            {
                Assert.That(collider.FirstTriangle, Is.EqualTo(next));
                uint count = collider.TriangleCount & CollisionCollider.CountMask;
                Bounds bounds = ColliderRig.BoundsOf(rig.Scene.Triangles.Skip((int)next).Take((int)count));
                AssertNear(collider.BoundsMin, bounds.min);
                AssertNear(collider.BoundsMax, bounds.max);
                next += count;
            }
            Assert.That(next, Is.EqualTo(rig.Scene.Triangles.Count));
        }

        [Test]
        public void OnlyTrianglesNearTheDomainAreKept()
        {
            BoxCollider floor = rig.Add<BoxCollider>();
            floor.size = new Vector3(100f, 1f, 100f);
            floor.transform.position = new Vector3(0f, -2.5f, 0f);
            List<CollisionTriangle> triangles = rig.GatherOne();
            Assert.That(triangles.Count, Is.EqualTo(2), "the top face alone intersects the domain");
            Assert.That(triangles.All(t => Vector3.Cross(t.B - t.A, t.C - t.A).y > 0f));
        }

        [Test]
        public void TriggersDisabledOtherLayersAndFarAwayAreLeftOut()
        {
            rig.Add<BoxCollider>().isTrigger = true;
            rig.Add<BoxCollider>().enabled = false;
            rig.Add<BoxCollider>().gameObject.layer = 0;
            rig.Add<BoxCollider>().gameObject.SetActive(false);
            rig.Add<BoxCollider>().transform.position = new Vector3(10f, 0f, 0f);
            rig.Gather();
            Assert.That(rig.Scene.Colliders, Is.Empty);
            Assert.That(rig.Scene.Messages, Is.Empty);
        }

        [Test]
        public void MoreCollidersThanTheFirstResultArrayAreAllFound()
        {
            for (int i = 0; i < 100; i++) rig.Add<BoxCollider>().transform.position = new Vector3(0.01f * i, 0f, 0f);
            rig.Gather();
            Assert.That(rig.Scene.Colliders.Count, Is.EqualTo(100));
        }

        private static void AssertNear(Vector3 actual, Vector3 expected, float within = 1e-4f) =>
            Assert.That((actual - expected).magnitude, Is.LessThan(within), $"{actual} instead of {expected}");
    }
}
