namespace UnityEngine.Rendering.Universal;

/// <summary>The frame's data in the form that passes of older lines read.</summary>
public struct RenderingData
{
    public CameraData cameraData;
    public LightData lightData;
    public ShadowData shadowData;

    internal RenderingData(ContextContainer frameData)
    {
        Frame = frameData;
        (cameraData, lightData, shadowData) = (new CameraData(frameData), new LightData(frameData), new ShadowData(frameData));
    }

    internal ContextContainer Frame { get; }

    public readonly ref CullingResults cullResults => ref Frame.Get<UniversalRenderingData>().cullResults;
    public readonly ref bool supportsDynamicBatching => ref Frame.Get<UniversalRenderingData>().supportsDynamicBatching;
    public readonly ref PerObjectData perObjectData => ref Frame.Get<UniversalRenderingData>().perObjectData;
}
