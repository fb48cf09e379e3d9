using Headless.Tests.Rendering;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.Conformance;

/// <summary>The sun and four point lights are drawn; every other light of a scene is named.</summary>
public sealed class LightTests : SceneFixture
{
    private static Light Lamp(string name, LightType type, Vector3 place)
    {
        var light = new GameObject(name).AddComponent<Light>();
        light.type = type;
        light.transform.position = place;
        light.transform.rotation = Quaternion.LookRotation(Vector3.down);
        return light;
    }

    [Test]
    public void APointLightLightsWhatLiesInItsRange()
    {
        Camera camera = Camera(new Vector3(0f, 5f, -0.1f), Vector3.zero);
        RenderSettings.ambientMode = UnityEngine.Rendering.AmbientMode.Flat;
        RenderSettings.ambientLight = Color.black;
        Primitive(PrimitiveType.Plane, Vector3.zero);
        Light lamp = Lamp("Lamp", LightType.Point, new Vector3(0f, 1f, 0f));
        lamp.range = 2f;
        Frame();
        Picture picture = Picture.OfScreen();
        float near = picture.Brightness(camera.WorldToScreenPoint(Vector3.zero));
        float beyond = picture.Brightness(camera.WorldToScreenPoint(new Vector3(2.2f, 0f, 0f)));
        Assert.That(near, Is.GreaterThan(beyond + 0.1f));
        Assert.That(Warnings, Has.None.Contains("Lamp"));
    }

    [TestCase(LightType.Directional, "only one directional light")]
    [TestCase(LightType.Spot, "spot lights are not supported")]
    [TestCase(LightType.Rectangle, "Rectangle lights are not supported")]
    public void ALightThatIsNotDrawnIsNamedOnce(LightType type, string reason)
    {
        Camera(new Vector3(0f, 5f, -0.1f), Vector3.zero);
        Sun(Vector3.down).intensity = 2f;
        Lamp("Second", type, Vector3.up);
        Frame(3);
        Assert.That(Warnings.Where(w => w.Contains("Second")).Single(), Does.Contain(reason));
    }

    [Test]
    public void AFifthPointLightABakedOneAndACookieAreNamed()
    {
        Camera(new Vector3(0f, 5f, -0.1f), Vector3.zero);
        Sun(Vector3.down).cookie = Texture2D.whiteTexture;
        for (int i = 0; i < 5; i++)
        {
            Lamp($"Point {i}", LightType.Point, Vector3.up).intensity = 5 - i;
        }

        Lamp("Bulb", LightType.Point, Vector3.up).lightmapBakeType = LightmapBakeType.Baked;
        Frame();
        Assert.That(Warnings, Has.Exactly(1).Contains("'Point 4' is not drawn"));
        Assert.That(Warnings, Has.Exactly(1).Contains("'Bulb' is baked"));
        Assert.That(Warnings, Has.Exactly(1).Contains("'Sun' is drawn without its cookie"));
    }
}
