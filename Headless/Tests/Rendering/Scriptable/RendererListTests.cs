using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Tests.Rendering;

public sealed class RendererListTests : ScriptableFixture
{
    private static readonly ShaderTagId Second = new("Second");

    [Test]
    public void PassesAreDrawnInTheOrderOfTheirNames()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Primitive(PrimitiveType.Cube, Vector3.zero).GetComponent<Renderer>().sharedMaterial = MaterialOf(TwoPasses);
        UseOne((context, camera, culled) => Draw(context, List(context, culled, Drawing(camera, Unlit, Second))));
        Frame();
        Assert.That(IsGreen(Middle()), Is.True, "the second over the first");
        UseOne((context, camera, culled) => Draw(context, List(context, culled, Drawing(camera, Second, Unlit))));
        Frame();
        Assert.That(IsRed(Middle()), Is.True, "the other way round");
        UseOne((context, camera, culled) => Draw(context, List(context, culled, Drawing(camera, new ShaderTagId("Nothing")))));
        Frame();
        Assert.That(IsBlack(Middle()), Is.True, "no pass of that name");
    }

    [Test]
    public void APassThatTheMaterialTurnsOffIsLeftOut()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Material material = MaterialOf(TwoPasses);
        material.SetShaderPassEnabled("Second", false);
        Primitive(PrimitiveType.Cube, Vector3.zero).GetComponent<Renderer>().sharedMaterial = material;
        UseOne((context, camera, culled) => Draw(context, List(context, culled, Drawing(camera, Unlit, Second))));
        Frame();
        Assert.That(IsRed(Middle()), Is.True);
    }

    [Test]
    public void FiltersTakeQueueLayerAndRenderingLayer()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        GameObject cube = Flat(PrimitiveType.Cube, Vector3.zero, Color.red);
        cube.layer = 5;
        Renderer renderer = cube.GetComponent<Renderer>();
        renderer.renderingLayerMask = 4u;
        Assert.That(Shows(new FilteringSettings(RenderQueueRange.opaque)), Is.True);
        Assert.That(Shows(new FilteringSettings(RenderQueueRange.transparent)), Is.False);
        Assert.That(Shows(new FilteringSettings(RenderQueueRange.all, 1 << 5)), Is.True);
        Assert.That(Shows(new FilteringSettings(RenderQueueRange.all, 1 << 4)), Is.False);
        Assert.That(Shows(new FilteringSettings(RenderQueueRange.all, -1, 6u)), Is.True);
        Assert.That(Shows(new FilteringSettings(RenderQueueRange.all, -1, 3u)), Is.False);
        renderer.sharedMaterial!.renderQueue = 2501;
        Assert.That(Shows(new FilteringSettings(RenderQueueRange.opaque)), Is.False);
        Assert.That(Shows(new FilteringSettings(RenderQueueRange.transparent)), Is.True);
    }

    private static bool Shows(FilteringSettings filtering)
    {
        RendererListStatus status = default;
        UseOne((context, camera, culled) => status = context.QueryRendererListStatus(List(context, culled, Drawing(camera, Unlit), filtering)));
        Frame();
        return status == RendererListStatus.kRendererListPopulated;
    }

    [Test]
    public void ObjectsAreSortedByTheCriteria()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        GameObject near = Flat(PrimitiveType.Cube, Vector3.zero, Color.red);
        GameObject far = Flat(PrimitiveType.Cube, new Vector3(0f, 0f, 3f), Color.green);
        near.GetComponent<Renderer>().sharedMaterial!.SetOverrideTag("Name", "near");
        var always = new RenderStateBlock(RenderStateMask.Depth) { depthState = new DepthState(false, CompareFunction.Always) };
        void Use(SortingCriteria order) => UseOne((context, camera, culled) =>
        {
            DrawingSettings drawing = Drawing(camera, order, Unlit);
            FilteringSettings filtering = FilteringSettings.defaultValue;
            context.DrawRenderers(culled, ref drawing, ref filtering, ref always);
        });
        Use(SortingCriteria.CommonTransparent);
        Frame();
        Assert.That(IsRed(Middle()), Is.True, "back to front: the near one last");
        Use(SortingCriteria.CommonOpaque);
        Frame();
        Assert.That(IsGreen(Middle()), Is.True, "front to back: the far one last, with no depth test");
        near.GetComponent<Renderer>().sharedMaterial!.renderQueue = 2100;
        Frame();
        Assert.That(IsRed(Middle()), Is.True, "the queue counts before the distance");
        far.GetComponent<Renderer>().sortingOrder = 1;
        Frame();
        Assert.That(IsGreen(Middle()), Is.True, "and the sorting order before the queue");
    }

    [Test]
    public void AStateBlockTakesThePlaceOfThePassesState()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Flat(PrimitiveType.Cube, Vector3.zero, Color.red);
        var block = new RenderStateBlock(RenderStateMask.Blend)
        {
            blendState = new BlendState { blendState0 = new RenderTargetBlendState(ColorWriteMask.All, BlendMode.Zero, BlendMode.OneMinusSrcColor) },
        };
        UseOne((context, camera, culled) =>
        {
            Run(context, c => c.ClearRenderTarget(true, true, Color.white));
            DrawingSettings drawing = Drawing(camera, Unlit);
            FilteringSettings filtering = FilteringSettings.defaultValue;
            context.DrawRenderers(culled, ref drawing, ref filtering, ref block);
        });
        Frame();
        Color32 blended = Middle();
        Assert.That((blended.r, blended.g, blended.b), Is.EqualTo(((byte)0, (byte)255, (byte)255)));
        block = new RenderStateBlock(RenderStateMask.Raster) { rasterState = new RasterState(CullMode.Front) };
        var wall = Flat(PrimitiveType.Quad, new Vector3(0f, 0f, -1f), Color.green);
        Frame();
        Assert.That(IsGreen(Middle()), Is.False, "its front is culled");
        UnityEngine.Object.DestroyImmediate(wall);
    }

    [Test]
    public void AStateBlockIsChosenByATag()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        GameObject cube = Flat(PrimitiveType.Cube, Vector3.zero, Color.red);
        UseOne((context, camera, culled) =>
        {
            DrawingSettings drawing = Drawing(camera, Unlit);
            FilteringSettings filtering = FilteringSettings.defaultValue;
            using var values = new NativeArray<ShaderTagId>([new ShaderTagId("Hidden")], Allocator.Temp);
            using var blocks = new NativeArray<RenderStateBlock>(
                [new RenderStateBlock(RenderStateMask.Depth) { depthState = new DepthState(false, CompareFunction.Never) }], Allocator.Temp);
            context.DrawRenderers(culled, ref drawing, ref filtering, values, blocks);
        });
        Frame();
        Assert.That(IsRed(Middle()), Is.True, "another RenderType");
        cube.GetComponent<Renderer>().sharedMaterial!.SetOverrideTag("RenderType", "Hidden");
        Frame();
        Assert.That(IsBlack(Middle()), Is.True);
    }

    [Test]
    public void AStencilStateIsRefusedOnce()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        var block = new RenderStateBlock(RenderStateMask.Stencil) { stencilState = StencilState.defaultValue };
        UseOne((context, camera, culled) =>
        {
            DrawingSettings drawing = Drawing(camera, Unlit);
            FilteringSettings filtering = FilteringSettings.defaultValue;
            context.DrawRenderers(culled, ref drawing, ref filtering, ref block);
        });
        Frame(2);
        Assert.That(Warnings.Count(w => w.Contains("stencil", StringComparison.Ordinal)), Is.EqualTo(1));
    }

    [Test]
    public void AnOverrideMaterialOrShaderDrawsInThePlaceOfThePasses()
    {
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Flat(PrimitiveType.Cube, Vector3.zero, Color.red);
        Material other = MaterialOf(TwoPasses);
        UseOne((context, camera, culled) =>
        {
            DrawingSettings drawing = Drawing(camera, Unlit);
            (drawing.overrideMaterial, drawing.overrideMaterialPassIndex) = (other, 1);
            Draw(context, List(context, culled, drawing));
        });
        Frame();
        Assert.That(IsGreen(Middle()), Is.True);
        UseOne((context, camera, culled) =>
        {
            DrawingSettings drawing = Drawing(camera, new ShaderTagId("Nothing"));
            drawing.overrideMaterial = other;
            Draw(context, List(context, culled, drawing));
        });
        Frame();
        Assert.That(IsBlack(Middle()), Is.True, "what has no pass of the names is left out");
        UseOne((context, camera, culled) =>
        {
            DrawingSettings drawing = Drawing(camera, Unlit);
            (drawing.overrideShader, drawing.overrideShaderPassIndex) = (other.shader, 1);
            Draw(context, List(context, culled, drawing));
        });
        Frame();
        Assert.That(IsGreen(Middle()), Is.True, "with the object's own values");
    }

    [Test]
    public void DrawsOfAFrameAreForTheirCamera()
    {
        Camera camera = Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Camera another = Camera(new Vector3(0f, 50f, -5f), Vector3.zero);
        another.depth = 1f;
        Material material = MaterialOf(FlatShader);
        material.SetColor("_Color", Color.red);
        Mesh cube = Primitive(PrimitiveType.Cube, new Vector3(0f, -50f, 0f)).GetComponent<MeshFilter>().sharedMesh!;
        UseOne((context, viewer, culled) => Draw(context, List(context, culled, Drawing(viewer, Unlit))));
        Graphics.RenderMesh(new RenderParams(material) { camera = camera }, cube, 0, Matrix4x4.identity);
        Frame();
        Assert.That(IsRed(Middle()), Is.True);
        Graphics.RenderMesh(new RenderParams(material) { camera = another }, cube, 0, Matrix4x4.identity);
        Frame();
        Assert.That(IsBlack(Middle()), Is.True);
    }

    [Test]
    public void SubShadersAreChosenAgainForAnotherPipeline()
    {
        const string program = """
            HLSLPROGRAM
            #pragma vertex Vertex
            #pragma fragment Fragment
            float4 Vertex(float4 position : POSITION) : SV_POSITION { return position; }
            float4 Fragment() : SV_Target { return 1; }
            ENDHLSL
            """;
        const string two = $$"""
            Shader "Test/Tagged"
            {
                SubShader
                {
                    Tags { "RenderPipeline" = "One" "Queue" = "Transparent" }
                    Pass { {{program}} }
                    Pass { Tags { "LightMode" = "A" } {{program}} }
                }
                SubShader { Pass { {{program}} } }
            }
            """;
        Camera(new Vector3(0f, 0f, -5f), Vector3.zero);
        Material material = MaterialOf(two);
        Assert.That((material.passCount, material.renderQueue), Is.EqualTo((1, 2000)));
        TestPipelineAsset asset = Use((_, _) => { });
        asset.Tag = "One";
        Frame();
        Assert.That(Shader.globalRenderPipeline, Is.EqualTo("One"));
        Assert.That((material.passCount, material.renderQueue), Is.EqualTo((2, 3000)));
        GraphicsSettings.defaultRenderPipeline = null;
        Frame();
        Assert.That((material.passCount, material.renderQueue), Is.EqualTo((1, 2000)));
    }
}
