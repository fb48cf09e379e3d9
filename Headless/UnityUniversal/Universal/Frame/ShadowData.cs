namespace UnityEngine.Rendering.Universal;

public struct ShadowData
{
    private readonly ContextContainer frame;

    internal ShadowData(ContextContainer frameData) => frame = frameData;

    public readonly ref bool supportsMainLightShadows => ref Data.supportsMainLightShadows;
    public readonly ref bool supportsSoftShadows => ref Data.supportsSoftShadows;
    public readonly ref int mainLightShadowCascadesCount => ref Data.mainLightShadowCascadesCount;
    public readonly ref Vector3 mainLightShadowCascadesSplit => ref Data.mainLightShadowCascadesSplit;

    private readonly UniversalShadowData Data => frame.Get<UniversalShadowData>();
}
