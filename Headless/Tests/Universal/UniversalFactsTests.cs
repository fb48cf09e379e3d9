using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Headless.Tests.Universal;

/// <summary>Every line of the table of facts, at every event from its own on at which a pass may read it.</summary>
public sealed class UniversalFactsTests : UniversalFixture
{
    private const string Table = "Headless/UnityUniversal/FACTS.md";

    private static readonly RenderPassEvent[] Events =
    [
        RenderPassEvent.AfterRenderingShadows, RenderPassEvent.BeforeRenderingPrePasses, RenderPassEvent.BeforeRenderingOpaques,
        RenderPassEvent.AfterRenderingOpaques, RenderPassEvent.BeforeRenderingTransparents,
    ];

    private static IEnumerable<Fact> Facts => UniversalFacts.All;

    [TestCaseSource(nameof(Facts))]
    public void EachFactHoldsFromItsEventOn(Fact fact)
    {
        FactScene scene = Scene();
        FactProbe[] probes = [.. Events.Where(e => e >= fact.From).Select(e => new FactProbe(e, Inputs(fact), MaterialOf, fact.Declaration, fact.Values))];
        using (Enqueue([.. probes]))
        {
            Frame(2);
        }

        Vector4[] expected = fact.Expected(scene);
        foreach (FactProbe probe in probes)
        {
            Vector4[] seen = probe.Read();
            for (int i = 0; i < expected.Length; i++)
            {
                float doubt = 1e-5f + (2e-5f * expected[i].magnitude);
                Assert.That((seen[i] - expected[i]).magnitude, Is.LessThan(doubt), $"{fact.Values[i]} at {probe.renderPassEvent} is {seen[i]:G6}, and not {expected[i]:G6}");
            }
        }
    }

    [Test]
    public void TheTableOfFactsHasEveryLine()
    {
        string[] lines = [.. UniversalFacts.All.Select(f => $"| `{f.Name}` | {f.From} | {f.Formula} | {f.Unit} |")];
        string file = File.ReadAllText(Path.Combine(Conformance.ReleaseBuildTests.FindUp(Table), Table));
        Assert.That(file.Split('\n').Where(l => l.StartsWith("| `", StringComparison.Ordinal)), Is.EqualTo(lines), string.Join("\n", lines));
    }

    private static ScriptableRenderPassInput Inputs(Fact fact) =>
        ScriptableRenderPassInput.Color | ScriptableRenderPassInput.Depth | (fact.Name == "_CameraNormalsTexture" ? ScriptableRenderPassInput.Normal : 0);

    private FactScene Scene()
    {
        Camera camera = Camera(new Vector3(1f, 2f, -6f), new Vector3(0.5f, 0f, 1f));
        camera.farClipPlane = 60f;
        Light sun = Sun(new Vector3(0.3f, -1f, 0.4f));
        (sun.color, sun.intensity, sun.shadowStrength) = (new Color(1f, 0.9f, 0.7f), 1.3f, 0.8f);
        Light lamp = Lamp(LightType.Point, new Vector3(1f, 1.5f, 0f), new Color(1f, 0.2f, 0.1f));
        Light spot = Lamp(LightType.Spot, new Vector3(-1f, 3f, 0f), new Color(0.1f, 0.4f, 1f));
        (spot.spotAngle, spot.innerSpotAngle) = (50f, 30f);
        spot.transform.rotation = Quaternion.LookRotation(new Vector3(0.2f, -1f, 0.1f));
        Lit(PrimitiveType.Cube, Vector3.zero, Color.gray);
        Asset.shadowCascadeCount = 4;
        Set("m_SoftShadowsSupported", true);
        RenderSettings.ambientMode = AmbientMode.Trilight;
        (RenderSettings.ambientSkyColor, RenderSettings.ambientEquatorColor, RenderSettings.ambientGroundColor) =
            (new Color(0.5f, 0.6f, 0.8f), new Color(0.4f, 0.4f, 0.3f), new Color(0.2f, 0.15f, 0.1f));
        return new FactScene(camera, sun, lamp, spot, Asset);
    }

    private static Light Lamp(LightType type, Vector3 at, Color color)
    {
        var light = new GameObject(type.ToString()).AddComponent<Light>();
        (light.type, light.color, light.intensity, light.range) = (type, color, 2f, 8f);
        light.transform.position = at;
        return light;
    }
}
