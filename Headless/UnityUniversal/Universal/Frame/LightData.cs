using Unity.Collections;

namespace UnityEngine.Rendering.Universal;

public struct LightData
{
    private readonly ContextContainer frame;

    internal LightData(ContextContainer frameData) => frame = frameData;

    public readonly ref int mainLightIndex => ref Data.mainLightIndex;
    public readonly ref int additionalLightsCount => ref Data.additionalLightsCount;
    public readonly ref int maxPerObjectAdditionalLightsCount => ref Data.maxPerObjectAdditionalLightsCount;
    public readonly ref NativeArray<VisibleLight> visibleLights => ref Data.visibleLights;

    private readonly UniversalLightData Data => frame.Get<UniversalLightData>();
}
