using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

/// <summary>RenderSettings.ambientProbe, evaluated as Unity's shaders evaluate unity_SHAr ... unity_SHC.</summary>
[TestFixture]
public sealed class AmbientProbeTests
{
    [SetUp]
    public void SetUp()
    {
        RenderSettings.ambientMode = AmbientMode.Trilight;
        RenderSettings.ambientSkyColor = new Color(0.9f, 0.5f, 0.3f);
        RenderSettings.ambientEquatorColor = new Color(0.4f, 0.6f, 0.2f);
        RenderSettings.ambientGroundColor = new Color(0.1f, 0.3f, 0.7f);
    }

    [TearDown]
    public void TearDown()
    {
        RenderSettings.ambientMode = AmbientMode.Skybox;
        RenderSettings.ambientSkyColor = new Color(0.212f, 0.227f, 0.259f, 1f);
        RenderSettings.ambientEquatorColor = new Color(0.114f, 0.125f, 0.133f, 1f);
        RenderSettings.ambientGroundColor = new Color(0.047f, 0.043f, 0.035f, 1f);
    }

    [Test]
    public void ThreeColorsComeBackFromTheirDirections()
    {
        for (int c = 0; c < 3; c++)
        {
            Assert.That(Light(c, Vector3.up), Is.EqualTo(RenderSettings.ambientSkyColor.linear[c]).Within(1e-5f));
            Assert.That(Light(c, Vector3.right), Is.EqualTo(RenderSettings.ambientEquatorColor.linear[c]).Within(1e-5f));
            Assert.That(Light(c, Vector3.forward), Is.EqualTo(RenderSettings.ambientEquatorColor.linear[c]).Within(1e-5f));
            Assert.That(Light(c, Vector3.down), Is.EqualTo(RenderSettings.ambientGroundColor.linear[c]).Within(1e-5f));
        }
    }

    [Test]
    public void FlatLightIsTheSameFromEverywhere()
    {
        RenderSettings.ambientMode = AmbientMode.Flat;
        var flat = default(SphericalHarmonicsL2);
        flat.AddAmbientLight(RenderSettings.ambientLight.linear);
        Assert.That(RenderSettings.ambientProbe == flat);
    }

    [Test]
    public void CustomModeGivesWhatWasSet()
    {
        var probe = default(SphericalHarmonicsL2);
        probe[1, 4] = 0.5f;
        RenderSettings.ambientProbe = probe;
        Assert.That(RenderSettings.ambientProbe, Is.Not.EqualTo(probe));
        RenderSettings.ambientMode = AmbientMode.Custom;
        Assert.That(RenderSettings.ambientProbe, Is.EqualTo(probe));
    }

    [TestCase(6570f, 1f, 0.98f, 1f, 0.06f)]
    [TestCase(2700f, 1f, 0.41f, 0.1f, 0.06f)]
    [TestCase(20000f, 0.42f, 0.56f, 1f, 0.08f)]
    public void TemperaturesHaveTheirColors(float kelvin, float r, float g, float b, float tolerance)
    {
        Color color = Mathf.CorrelatedColorTemperatureToRGB(kelvin);
        Assert.That(color.r, Is.EqualTo(r).Within(tolerance));
        Assert.That(color.g, Is.EqualTo(g).Within(tolerance));
        Assert.That(color.b, Is.EqualTo(b).Within(tolerance));
    }

    private static float Light(int c, Vector3 n)
    {
        SphericalHarmonicsL2 p = RenderSettings.ambientProbe;
        float linear = (p[c, 3] * n.x) + (p[c, 1] * n.y) + (p[c, 2] * n.z) + p[c, 0] - p[c, 6];
        float quadratic = (p[c, 4] * n.x * n.y) + (p[c, 5] * n.y * n.z) + (3f * p[c, 6] * n.z * n.z) + (p[c, 7] * n.z * n.x);
        return linear + quadratic + (p[c, 8] * ((n.x * n.x) - (n.y * n.y)));
    }
}
