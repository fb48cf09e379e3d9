using Headless.Engine;

namespace UnityEngine.XR;

/// <summary>What draws two eyes, if anything does.</summary>
public static class XRSettings
{
    public enum StereoRenderingMode
    {
        MultiPass = 0,
        SinglePass = 1,
        SinglePassInstanced = 2,
        SinglePassMultiview = 3,
    }

    public static bool enabled => Stereo.Mode != StereoMode.Off;

    public static StereoRenderingMode stereoRenderingMode =>
        Stereo.Mode == StereoMode.Instanced ? StereoRenderingMode.SinglePassInstanced : StereoRenderingMode.MultiPass;

    public static RenderTextureDescriptor eyeTextureDesc => EyeTextures.Description;
    public static int eyeTextureWidth => Stereo.EyeWidth;
    public static int eyeTextureHeight => Stereo.EyeHeight;
}
