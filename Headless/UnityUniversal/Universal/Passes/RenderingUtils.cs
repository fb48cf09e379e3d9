namespace UnityEngine.Rendering.Universal;

public static class RenderingUtils
{
    /// <summary>Makes the texture anew where there is none or it is another than described.</summary>
    /// <returns>Whether it was made.</returns>
    public static bool ReAllocateHandleIfNeeded(
        ref RTHandle? handle, in RenderTextureDescriptor descriptor, FilterMode filterMode = FilterMode.Point, TextureWrapMode wrapMode = TextureWrapMode.Repeat,
        int anisoLevel = 1, float mipMapBias = 0f, string name = "")
    {
        if (handle?.rt is { } there && there != null && there.width == descriptor.width && there.height == descriptor.height
            && there.graphicsFormat == descriptor.graphicsFormat && there.antiAliasing == descriptor.msaaSamples && there.volumeDepth == descriptor.volumeDepth
            && there.dimension == descriptor.dimension && there.filterMode == filterMode && there.wrapMode == wrapMode && there.name == name)
        {
            return false;
        }

        handle?.Release();
        handle = RTHandles.Alloc(descriptor, filterMode, wrapMode, anisoLevel: anisoLevel, mipMapBias: mipMapBias, name: name);
        return true;
    }

    public static bool ReAllocateIfNeeded(
        ref RTHandle? handle, in RenderTextureDescriptor descriptor, FilterMode filterMode = FilterMode.Point, TextureWrapMode wrapMode = TextureWrapMode.Repeat,
        bool isShadowMap = false, int anisoLevel = 1, float mipMapBias = 0f, string name = "") =>
        ReAllocateHandleIfNeeded(ref handle, descriptor, filterMode, wrapMode, anisoLevel, mipMapBias, name);
}
