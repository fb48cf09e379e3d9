namespace UnityEngine.Rendering;

public static class RTHandles
{
    public static RTHandle Alloc(Texture tex) => new(tex as RenderTexture, tex is RenderTexture ? null : tex, All(tex), tex.name, false);

    public static RTHandle Alloc(RenderTexture tex, bool transferOwnership = false) => new(tex, null, All(tex), tex.name, transferOwnership);

    public static RTHandle Alloc(RenderTargetIdentifier tex) => Alloc(tex, string.Empty);

    public static RTHandle Alloc(RenderTargetIdentifier tex, string name) => new(null, null, tex, name, false);

    public static RTHandle Alloc(
        in RenderTextureDescriptor descriptor, FilterMode filterMode = FilterMode.Point, TextureWrapMode wrapMode = TextureWrapMode.Repeat,
        bool isShadowMap = false, int anisoLevel = 1, float mipMapBias = 0f, string name = "")
    {
        var texture = new RenderTexture(descriptor) { name = name, filterMode = filterMode, wrapMode = wrapMode, hideFlags = HideFlags.HideAndDontSave };
        return Alloc(texture, true);
    }

    private static RenderTargetIdentifier All(Texture tex) => tex.dimension == TextureDimension.Tex2DArray
        ? new RenderTargetIdentifier(tex, 0, CubemapFace.Unknown, RenderTargetIdentifier.AllDepthSlices)
        : new RenderTargetIdentifier(tex);

    public static void Release(RTHandle rth) => rth?.Release();

    /// <summary>The size that scaled handles go by; none here is scaled.</summary>
    public static void SetReferenceSize(int width, int height)
    {
    }

    public static void Initialize(int width, int height)
    {
    }
}
