using System;
using Headless.Engine;

namespace UnityEngine.Rendering;

/// <summary>The pass of a stereo camera that is drawn now: one eye, or both at once.</summary>
internal static class EyePass
{
    /// <summary>0 for a camera with one picture, 1 for one eye, 2 for both.</summary>
    public static int Views => Stereo.Eyes.Count;

    /// <summary>What the eyes are drawn into.</summary>
    public static RenderTexture Target => EyeTextures.Current;

    /// <summary>Calls once, or once for each pass.</summary>
    public static void ForEach(Camera camera, Action draw) => Stereo.ForEachPass(camera, draw);

    public static Matrix4x4 View(Camera camera, int index) => camera.GetStereoViewMatrix(Stereo.Eyes[index]);

    public static Matrix4x4 Projection(Camera camera, int index) => camera.GetStereoProjectionMatrix(Stereo.Eyes[index]);
}
