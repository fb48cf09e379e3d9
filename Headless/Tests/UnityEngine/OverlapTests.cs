using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace Headless.Tests.UnityEngineApi;

public class OverlapTests : EngineFixture
{
    static T Make<T>(string name, Vector3 position, Quaternion rotation, Vector3 scale) where T : Collider
    {
        var owner = new GameObject(name);
        owner.transform.SetPositionAndRotation(position, rotation);
        owner.transform.localScale = scale;
        return owner.AddComponent<T>();
    }

    static int Hits(Vector3 center, Vector3 half, Quaternion? rotation = null, int mask = ~0) =>
        Physics.OverlapBox(center, half, rotation ?? Quaternion.identity, mask).Length;

    [Test]
    public void ARotatedBoxIsTestedByItsOwnSides()
    {
        Make<BoxCollider>("B", Vector3.zero, Quaternion.Euler(0f, 45f, 0f), Vector3.one);
        // The corner of the diamond reaches 0.707 on the axes; its world bounds also hold (0.6, 0, 0.6), which is outside.
        Assert.That(Hits(new Vector3(0.75f, 0f, 0f), Vector3.one * 0.05f), Is.EqualTo(1));
        Assert.That(Hits(new Vector3(0.6f, 0f, 0.6f), Vector3.one * 0.05f), Is.Zero);
        Assert.That(Hits(new Vector3(0.4f, 0f, 0.4f), Vector3.one * 0.06f), Is.EqualTo(1));
    }

    [Test]
    public void ARotatedQueryIsTestedByItsOwnSides()
    {
        Make<BoxCollider>("B", Vector3.zero, Quaternion.identity, Vector3.one);
        Quaternion turn = Quaternion.Euler(0f, 45f, 0f);
        Assert.That(Hits(new Vector3(1.1f, 0f, 0f), Vector3.one * 0.5f, turn), Is.EqualTo(1));
        Assert.That(Hits(new Vector3(1.1f, 0f, 1.1f), Vector3.one * 0.5f, turn), Is.Zero);
    }

    [Test]
    public void EdgeAgainstEdgeNeedsTheCrossAxes()
    {
        Make<BoxCollider>("B", Vector3.zero, Quaternion.Euler(0f, 0f, 45f), Vector3.one);
        Quaternion turn = Quaternion.Euler(45f, 0f, 0f) * Quaternion.Euler(0f, 90f, 0f);
        float reach = 2f * Mathf.Sqrt(0.5f);
        Assert.That(Hits(new Vector3(0f, reach - 0.02f, 0f), Vector3.one * 0.5f, turn), Is.EqualTo(1));
        Assert.That(Hits(new Vector3(0f, reach + 0.02f, 0f), Vector3.one * 0.5f, turn), Is.Zero);
    }

    [Test]
    public void SphereTakesTheLargestScale()
    {
        Make<SphereCollider>("S", Vector3.zero, Quaternion.identity, new Vector3(1f, 4f, 1f));
        Assert.That(Hits(new Vector3(2.05f, 0f, 0f), Vector3.one * 0.1f), Is.EqualTo(1));
        Assert.That(Hits(new Vector3(2.2f, 0f, 0f), Vector3.one * 0.1f), Is.Zero);
        Assert.That(Hits(new Vector3(1.55f, 1.55f, 0f), Vector3.one * 0.1f), Is.Zero);
    }

    [Test]
    public void ACharacterControllerStaysUpright()
    {
        CharacterController character = Make<CharacterController>("C", Vector3.zero, Quaternion.Euler(0f, 0f, 90f), Vector3.one);
        character.height = 3f;
        Assert.That(character.bounds.size.y, Is.EqualTo(3f).Within(1e-4f));
        Assert.That(character.bounds.size.x, Is.EqualTo(1f).Within(1e-4f));
        Assert.That(Hits(new Vector3(0f, 1.4f, 0f), Vector3.one * 0.05f), Is.EqualTo(1));
        Assert.That(Hits(new Vector3(1.4f, 0f, 0f), Vector3.one * 0.05f), Is.Zero);
    }

    [Test]
    public void AWheelHangsSteersAndTurnsWhereNoQueryFindsIt()
    {
        WheelCollider wheel = Make<WheelCollider>("W", new Vector3(1f, 2f, 3f), Quaternion.Euler(0f, 90f, 0f), 2f * Vector3.one);
        (wheel.center, wheel.suspensionDistance, wheel.steerAngle) = (new Vector3(0f, 0f, 1f), 0.25f, 30f);
        wheel.GetWorldPose(out Vector3 position, out Quaternion rotation);
        Assert.That((position - new Vector3(3f, 1.5f, 3f)).magnitude, Is.LessThan(1e-5f));
        Assert.That(Quaternion.Angle(rotation, Quaternion.Euler(0f, 120f, 0f)), Is.LessThan(1e-3f));
        wheel.rotationSpeed = 360f;
        float began = Time.fixedTime;
        Frame();
        wheel.GetWorldPose(out _, out rotation);
        Quaternion expected = Quaternion.Euler(0f, 120f, 0f) * Quaternion.Euler(360f * (Time.fixedTime - began), 0f, 0f);
        Assert.That(Quaternion.Angle(rotation, expected), Is.LessThan(1e-2f));
        Assert.That(Hits(position, Vector3.one), Is.Zero);
    }

    [Test]
    public void ATerrainIsItsBoxWhereverItsObjectIsTurned()
    {
        TerrainCollider terrain = Make<TerrainCollider>("T", new Vector3(1f, 2f, 3f), Quaternion.Euler(0f, 45f, 0f), 2f * Vector3.one);
        Assert.That(Hits(Vector3.zero, Vector3.one * 100f), Is.Zero, "no data");
        terrain.terrainData = new TerrainData { heightmapResolution = 40, size = new Vector3(64f, 4f, 32f) };
        Assert.That(terrain.terrainData.heightmapResolution, Is.EqualTo(65));
        Assert.That((terrain.bounds.min - new Vector3(1f, 2f, 3f)).magnitude, Is.LessThan(1e-3f));
        Assert.That((terrain.bounds.size - new Vector3(64f, 4f, 32f)).magnitude, Is.LessThan(1e-3f));
        Assert.That(Hits(new Vector3(64f, 5f, 34f), Vector3.one * 0.1f), Is.EqualTo(1));
        Assert.That(Hits(new Vector3(64f, 7f, 34f), Vector3.one * 0.1f), Is.Zero);
    }

    [Test]
    public void EditsOfTerrainDataRaiseItsTerrainsCallbacks()
    {
        var data = new TerrainData();
        new GameObject("T").AddComponent<Terrain>().terrainData = data;
        int heights = 0, holes = 0;
        TerrainCallbacks.HeightmapChangedCallback onHeights = (terrain, region, synched) => heights += region.width * region.height;
        TerrainCallbacks.TextureChangedCallback onTexture = (terrain, name, region, synched) => holes += name == TerrainData.HolesTextureName ? 1 : 0;
        TerrainCallbacks.heightmapChanged += onHeights;
        TerrainCallbacks.textureChanged += onTexture;
        try
        {
            data.SetHeights(3, 4, new float[2, 5] { { 0.5f, 0f, 0f, 0f, 2f }, { 0f, 0f, 0f, 0f, 0f } });
            data.SetHoles(31, 31, new bool[1, 1]);
        }
        finally
        {
            TerrainCallbacks.heightmapChanged -= onHeights;
            TerrainCallbacks.textureChanged -= onTexture;
        }
        Assert.That((heights, holes), Is.EqualTo((10, 1)));
        Assert.That(data.GetHeights(3, 4, 5, 1)[0, 0], Is.EqualTo(0.5f));
        Assert.That(data.GetHeights(7, 4, 1, 1)[0, 0], Is.EqualTo(1f), "heights are at most 1");
        Assert.That(data.GetHoles(31, 31, 1, 1)[0, 0], Is.False);
        Assert.That(() => data.GetHeights(30, 0, 4, 1), Throws.ArgumentException);
    }

    [Test]
    public void CapsuleHasRoundEnds()
    {
        CapsuleCollider capsule = Make<CapsuleCollider>("C", Vector3.zero, Quaternion.Euler(0f, 0f, 90f), Vector3.one);
        capsule.height = 3f;
        Assert.That(Hits(new Vector3(1.5f, 0f, 0f), Vector3.one * 0.01f), Is.EqualTo(1));
        Assert.That(Hits(new Vector3(1.45f, 0.45f, 0f), Vector3.one * 0.01f), Is.Zero);
        Assert.That(Hits(new Vector3(0.5f, 0.45f, 0f), Vector3.one * 0.01f), Is.EqualTo(1));
        Assert.That(capsule.bounds.size.x, Is.EqualTo(3f).Within(1e-4f));
        Assert.That(capsule.bounds.size.y, Is.EqualTo(1f).Within(1e-4f));
    }

    [Test]
    public void LayersAndTriggersFilter()
    {
        BoxCollider box = Make<BoxCollider>("B", Vector3.zero, Quaternion.identity, Vector3.one);
        box.gameObject.layer = 8;
        Assert.That(Hits(Vector3.zero, Vector3.one, null, 1 << 8), Is.EqualTo(1));
        Assert.That(Hits(Vector3.zero, Vector3.one, null, ~(1 << 8)), Is.Zero);
        box.isTrigger = true;
        var results = new Collider[4];
        Assert.That(Physics.OverlapBoxNonAlloc(Vector3.zero, Vector3.one, results, Quaternion.identity, ~0, QueryTriggerInteraction.Ignore), Is.Zero);
        Assert.That(Physics.OverlapBoxNonAlloc(Vector3.zero, Vector3.one, results, Quaternion.identity, ~0, QueryTriggerInteraction.UseGlobal), Is.EqualTo(1));
        Assert.That(results[0], Is.SameAs(box));
    }

    [Test]
    public void DisabledAndInactiveCollidersAreNotFoundAndHaveEmptyBounds()
    {
        BoxCollider box = Make<BoxCollider>("B", Vector3.one, Quaternion.identity, Vector3.one);
        Assert.That(box.bounds.center, Is.EqualTo(Vector3.one));
        box.enabled = false;
        Assert.That(Hits(Vector3.one, Vector3.one), Is.Zero);
        Assert.That(box.bounds.size, Is.EqualTo(Vector3.zero));
        box.enabled = true;
        box.gameObject.SetActive(false);
        Assert.That(Hits(Vector3.one, Vector3.one), Is.Zero);
    }

    [Test]
    public void MovedTransformsAreSeenAfterSyncOrAStep()
    {
        BoxCollider box = Make<BoxCollider>("B", Vector3.zero, Quaternion.identity, Vector3.one);
        box.transform.position = new Vector3(10f, 0f, 0f);
        Assert.That(Hits(new Vector3(10f, 0f, 0f), Vector3.one), Is.Zero);
        Physics.SyncTransforms();
        Assert.That(Hits(new Vector3(10f, 0f, 0f), Vector3.one), Is.EqualTo(1));
        box.transform.position = Vector3.zero;
        Frame();
        Assert.That(Hits(Vector3.zero, Vector3.one), Is.EqualTo(1));
    }

    [Test]
    public void ClosestPointOfPrimitives()
    {
        BoxCollider box = Make<BoxCollider>("B", Vector3.zero, Quaternion.Euler(0f, 45f, 0f), Vector3.one * 2f);
        Vector3 nearest = box.ClosestPoint(new Vector3(5f, 0f, 0f));
        Assert.That(nearest.x, Is.EqualTo(Mathf.Sqrt(2f)).Within(1e-4f));
        Assert.That(box.ClosestPoint(new Vector3(0.1f, 0.2f, 0.3f)), Is.EqualTo(new Vector3(0.1f, 0.2f, 0.3f)));
        SphereCollider sphere = Make<SphereCollider>("S", Vector3.zero, Quaternion.identity, Vector3.one);
        Assert.That((sphere.ClosestPoint(Vector3.up * 3f) - Vector3.up * 0.5f).magnitude, Is.LessThan(1e-5f));
    }

    [Test]
    public void TheScenesPhysicsSceneAnswersToo()
    {
        Make<BoxCollider>("B", Vector3.zero, Quaternion.identity, Vector3.one);
        PhysicsScene physics = SceneManager.GetActiveScene().GetPhysicsScene();
        var results = new Collider[2];
        Assert.That(physics.OverlapBox(Vector3.zero, Vector3.one, results, Quaternion.identity), Is.EqualTo(1));
        Assert.That(Physics.OverlapSphere(new Vector3(0f, 0.9f, 0f), 0.45f).Single(), Is.SameAs(results[0]));
        Assert.That(Physics.CheckSphere(new Vector3(0f, 1.1f, 0f), 0.45f), Is.False);
    }
}
