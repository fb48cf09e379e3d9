using System.Reflection;
using Headless.Tests.Rendering;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;

namespace Headless.Tests.Universal;

/// <summary>Scenes that the Universal Render Pipeline draws, by an asset that a test may change.</summary>
public abstract class UniversalFixture : SceneFixture
{
    private protected UniversalRenderPipelineAsset Asset { get; private set; } = null!;

    private protected UniversalRendererData Renderer => (UniversalRendererData)Asset.rendererDataList[0]!;

    [SetUp]
    public void UseUniversal()
    {
        Asset = UniversalRenderPipelineAsset.Create(ScriptableObject.CreateInstance<UniversalRendererData>());
        GraphicsSettings.defaultRenderPipeline = Asset;
    }

    [TearDown]
    public void LeaveUniversal()
    {
        UniversalRenderPipeline.CompatibilityMode = false;
        GraphicsSettings.defaultRenderPipeline = null;
    }

    /// <summary>A primitive with the pipeline's own lit shader.</summary>
    private protected static GameObject Lit(PrimitiveType type, Vector3 position, Color color)
    {
        GameObject primitive = GameObject.CreatePrimitive(type);
        primitive.transform.position = position;
        var material = new Material(Shader.Find("Universal Render Pipeline/Lit")!);
        material.SetColor("_BaseColor", color);
        material.SetFloat("_Smoothness", 0f);
        primitive.GetComponent<Renderer>().sharedMaterial = material;
        return primitive;
    }

    /// <summary>A field of the asset that has no public setter, as its inspector changes it.</summary>
    private protected void Set(string field, object value) =>
        typeof(UniversalRenderPipelineAsset).GetField(field, BindingFlags.Instance | BindingFlags.NonPublic)!.SetValue(Asset, value);

    /// <summary>Puts passes into the queue of each camera that is about to be drawn, while the scope lasts.</summary>
    private protected static IDisposable Enqueue(params ScriptableRenderPass[] passes) => new Listener(camera =>
    {
        foreach (ScriptableRenderPass pass in passes)
        {
            camera.GetUniversalAdditionalCameraData().scriptableRenderer!.EnqueuePass(pass);
        }
    });

    private sealed class Listener : IDisposable
    {
        private readonly Action<Camera> action;

        public Listener(Action<Camera> action)
        {
            this.action = action;
            RenderPipelineManager.beginCameraRendering += Call;
        }

        public void Dispose() => RenderPipelineManager.beginCameraRendering -= Call;

        private void Call(ScriptableRenderContext context, Camera camera) => action(camera);
    }
}
