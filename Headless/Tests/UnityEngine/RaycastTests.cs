using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

public class RaycastTests : EngineFixture
{
    private static T Make<T>(Vector3 position, Vector3 scale, Quaternion? rotation = null) where T : Collider
    {
        var owner = new GameObject(typeof(T).Name);
        owner.transform.SetPositionAndRotation(position, rotation ?? Quaternion.identity);
        owner.transform.localScale = scale;
        return owner.AddComponent<T>();
    }

    private static float? Down(float x, float z, float from = 10f) =>
        Physics.Raycast(new Vector3(x, from, z), Vector3.down, out RaycastHit hit) ? hit.point.y : null;

    [Test]
    public void ABoxIsHitOnItsFace()
    {
        BoxCollider box = Make<BoxCollider>(new Vector3(0f, 1f, 0f), new Vector3(2f, 4f, 6f));
        Assert.That(Physics.Raycast(new Vector3(0.9f, 10f, 2.9f), 3f * Vector3.down, out RaycastHit hit), Is.True);
        Assert.That(hit.point.y, Is.EqualTo(3f).Within(1e-5));
        Assert.That(hit.distance, Is.EqualTo(7f).Within(1e-5));
        Assert.That(hit.normal, Is.EqualTo(Vector3.up));
        Assert.That(hit.collider, Is.SameAs(box));
        Assert.That(hit.transform, Is.SameAs(box.transform));
        Assert.That(Down(1.1f, 0f), Is.Null);
    }

    [Test]
    public void ATurnedBoxIsHitOnItsOwnFace()
    {
        Make<BoxCollider>(Vector3.zero, Vector3.one, Quaternion.Euler(0f, 0f, 45f));
        Assert.That(Down(0f, 0f), Is.EqualTo(Mathf.Sqrt(0.5f)).Within(1e-5));
        Assert.That(Down(0.5f, 0f), Is.EqualTo(Mathf.Sqrt(0.5f) - 0.5f).Within(1e-5));
        Assert.That(Down(0.75f, 0f), Is.Null);
    }

    [Test]
    public void SpheresAndCapsulesAreRound()
    {
        Make<SphereCollider>(Vector3.zero, 2f * Vector3.one);
        Make<CapsuleCollider>(new Vector3(5f, 0f, 0f), new Vector3(2f, 2f, 2f), Quaternion.Euler(0f, 0f, 90f)).height = 3f;
        Assert.That(Down(0.6f, 0f), Is.EqualTo(0.8f).Within(1e-5));
        // Along x from 2 to 8, of radius 1: cylinder to 7, then a half sphere.
        Assert.That(Down(6.9f, 0.6f), Is.EqualTo(0.8f).Within(1e-5));
        Assert.That(Down(7.6f, 0f), Is.EqualTo(0.8f).Within(1e-5));
        Assert.That(Down(8.1f, 0f), Is.Null);
    }

    [Test]
    public void AMeshIsHitFromItsFrontOnly([Values(1f, -1f)] float mirror)
    {
        MeshCollider plane = Make<MeshCollider>(new Vector3(0f, 2f, 0f), new Vector3(mirror, 1f, 1f));
        plane.sharedMesh = new Mesh
        {
            vertices = new[] { new Vector3(-5f, 0f, -5f), new Vector3(-5f, 0f, 5f), new Vector3(5f, 0f, 5f), new Vector3(5f, 0f, -5f) },
            triangles = new[] { 0, 1, 2, 0, 2, 3 },
        };
        Physics.SyncTransforms();
        Assert.That(Down(4f, -4f), Is.EqualTo(2f).Within(1e-5));
        Assert.That(Physics.Raycast(Vector3.zero, Vector3.up), Is.False);
        Physics.queriesHitBackfaces = true;
        try
        {
            Assert.That(Physics.Raycast(Vector3.zero, Vector3.up, out RaycastHit hit), Is.True);
            Assert.That(hit.normal.y, Is.EqualTo(-1f).Within(1e-5));
        }
        finally
        {
            Physics.queriesHitBackfaces = false;
        }
    }

    [Test]
    public void ATerrainIsHitOnItsHeights()
    {
        var data = new TerrainData { heightmapResolution = 33, size = new Vector3(32f, 10f, 32f) };
        var heights = new float[33, 33];
        for (int z = 0; z < 33; z++)
            for (int x = 0; x < 33; x++) heights[z, x] = x / 32f;
        data.SetHeights(0, 0, heights);
        Make<TerrainCollider>(new Vector3(-16f, 1f, -16f), Vector3.one).terrainData = data;
        Assert.That(Down(0f, 5f, 50f), Is.EqualTo(6f).Within(1e-4));
        Assert.That(Down(-8f, -3.3f, 50f), Is.EqualTo(3.5f).Within(1e-4));
        Assert.That(Down(17f, 0f, 50f), Is.Null);
    }

    [Test]
    public void WhatTheRayStartsInIsNotHit()
    {
        Make<BoxCollider>(Vector3.zero, 4f * Vector3.one);
        Make<SphereCollider>(Vector3.zero, 3f * Vector3.one);
        Make<CapsuleCollider>(Vector3.zero, 3f * Vector3.one);
        Make<BoxCollider>(new Vector3(0f, -5f, 0f), Vector3.one);
        Assert.That(Down(0f, 0f, 0f), Is.EqualTo(-4.5f).Within(1e-5));
    }

    [Test]
    public void TheFirstColliderCountsWithinTheReachAndTheLayers()
    {
        BoxCollider low = Make<BoxCollider>(Vector3.zero, Vector3.one), high = Make<BoxCollider>(new Vector3(0f, 3f, 0f), Vector3.one);
        Assert.That(Down(0f, 0f), Is.EqualTo(3.5f).Within(1e-5));
        Assert.That(Physics.Raycast(new Vector3(0f, 10f, 0f), Vector3.down, 6f), Is.False);
        Assert.That(Physics.Raycast(new Vector3(0f, 10f, 0f), Vector3.down, 6.6f), Is.True);
        high.gameObject.layer = 2;
        Assert.That(Down(0f, 0f), Is.EqualTo(0.5f).Within(1e-5), "the layer that rays ignore");
        low.isTrigger = true;
        Assert.That(Physics.Raycast(new Vector3(0f, 10f, 0f), Vector3.down, out _, 20f, Physics.DefaultRaycastLayers, QueryTriggerInteraction.Ignore), Is.False);
    }
}
