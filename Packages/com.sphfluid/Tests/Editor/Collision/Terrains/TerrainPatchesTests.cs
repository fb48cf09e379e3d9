#if SPHFLUID_TERRAIN
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    public sealed class TerrainPatchesTests
    {
        private ColliderRig rig;
        private TerrainData data;
        private TerrainCollider collider;

        [SetUp]
        public void SetUp()
        {
            rig = new ColliderRig();
            data = new TerrainData { heightmapResolution = 65, size = new Vector3(64f, 8f, 64f) };
            Fill(0.25f);
            collider = rig.Add<TerrainCollider>("Ground");
            collider.terrainData = data;
            collider.gameObject.AddComponent<Terrain>().terrainData = data;
            collider.transform.position = new Vector3(-32f, -2f, -32f);
        }

        [TearDown]
        public void TearDown()
        {
            rig.Dispose();
            Object.DestroyImmediate(data);
        }

        [Test]
        public void OnlyThePartNearTheDomainIsRead()
        {
            Assert.That(rig.GatherOne().All(t => t.A.y == 0f), "8 m x 0.25 above -2 m; walls and floor are outside the domain");
            TriangleMesh mesh = rig.Scene.Solids.Single().Mesh;
            Assert.That(mesh.TriangleCount, Is.LessThan(200), "of 8,192");
            Assert.That(mesh.Contains(new Vector3(0.3f, -0.1f, 0.2f)), Is.True);
            Assert.That(mesh.Contains(new Vector3(0.3f, 0.1f, 0.2f)), Is.False);
            Assert.That(mesh.Contains(new Vector3(1.9f, -1.9f, -1.9f)), Is.True, "the ground goes down to below the domain");
            Assert.That(rig.Gather(), Is.False, "nothing changed");
        }

        [Test]
        public void OtherHeightsAreSeenAndTheSameHeightsChangeNothing()
        {
            rig.Gather();
            Fill(0.25f);
            Assert.That(rig.Gather(), Is.False, "the same heights");
            rig.Scene.States.Terrains.Refresh();
            Assert.That(rig.Gather(), Is.False, "read again");
            Fill(0.3f);
            Assert.That(rig.Gather(), Is.True);
            Assert.That(rig.Scene.Triangles.All(t => Mathf.Abs(t.A.y - 0.4f) < 1e-3f));
        }

        [Test]
        public void AHoleOpensTheGround()
        {
            rig.Gather();
            int before = rig.Scene.Triangles.Count;
            data.SetHoles(32, 32, new[,] { { false } });
            Assert.That(rig.Gather(), Is.True);
            Assert.That(rig.Scene.Triangles.Count, Is.EqualTo(before - 2));
            Assert.That(rig.Scene.Solids.Single().Mesh.IsClosed, Is.False);
        }

        [Test]
        public void TrianglesFollowTheDomainOverTheTerrain()
        {
            rig.Gather();
            TriangleMesh first = rig.Scene.Solids.Single().State.Triangles;
            rig.Position = new Vector3(0.1f, 0f, 0f);
            rig.Gather();
            Assert.That(rig.Scene.Solids.Single().State.Triangles, Is.SameAs(first), "still over what was read");
            rig.Position = new Vector3(20f, 0f, 30f);
            rig.Gather();
            Assert.That(rig.Scene.Solids.Single().State.Triangles, Is.Not.SameAs(first));
            Assert.That(rig.Scene.Solids.Single().Mesh.Contains(new Vector3(0f, -0.1f, 0f)), Is.True);
        }

        [Test]
        public void WhatCannotServeIsNamedWithTheCure()
        {
            rig.DomainSize = new Vector3(64f, 4f, 64f);
            data.heightmapResolution = 2049;
            data.size = new Vector3(64f, 8f, 64f);
            rig.Gather();
            FluidMessage message = rig.Scene.Messages.Single();
            Assert.That(message.Issue, Is.EqualTo(FluidIssue.TooManyTriangles));
            Assert.That(message.ToString(), Does.Contain("'Ground'").And.Contain("Heightmap Resolution"));
        }

        private void Fill(float height)
        {
            var heights = new float[65, 65];
            for (int z = 0; z < 65; z++)
                for (int x = 0; x < 65; x++) heights[z, x] = height;
            data.SetHeights(0, 0, heights);
        }
    }
}
#endif
