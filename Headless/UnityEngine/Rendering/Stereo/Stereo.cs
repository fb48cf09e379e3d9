using System;
using System.Collections.Generic;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Two eyes in place of one picture, side by side on the screen; cameras with a target texture of their own have one eye.</summary>
internal static class Stereo
{
    private static readonly int EyeIndex = ShaderNames.Id("unity_StereoEyeIndex");
    private static Camera? drawn;
    private static Camera.StereoscopicEye[] eyes = [];

    public static StereoMode Mode { get; set; }

    public static int EyeWidth => Math.Max(1, ScreenTarget.Width / 2);
    public static int EyeHeight => ScreenTarget.Height;

    /// <summary>What is being drawn: one eye, or both at once; empty outside of a stereo camera's passes.</summary>
    public static IReadOnlyList<Camera.StereoscopicEye> Eyes => eyes;

    public static bool Shows(Camera camera) =>
        Mode != StereoMode.Off && camera.targetTexture == null && camera.cameraType == CameraType.Game
        && camera.stereoTargetEye != StereoTargetEyeMask.None;

    /// <summary>Whether what a camera draws goes to the eyes' textures now.</summary>
    public static bool Draws(Camera camera) => eyes.Length > 0 && Shows(camera);

    /// <summary>The one eye that a camera draws now.</summary>
    public static Camera.StereoscopicEye? EyeOf(Camera camera) => eyes.Length == 1 && ReferenceEquals(camera, drawn) ? eyes[0] : null;

    /// <summary>Draws once, or once for each pass of a stereo camera, and shows the eyes that it draws.</summary>
    public static void ForEachPass(Camera camera, Action draw)
    {
        if (eyes.Length > 0 || !Shows(camera))
        {
            draw();
            return;
        }

        try
        {
            foreach (Camera.StereoscopicEye[] pass in Passes(camera.stereoTargetEye))
            {
                (drawn, eyes) = (camera, pass);
                EyeViews.Camera = pass.Length > 1 ? camera : null;
                GlobalProperties.Sheet.SetInteger(EyeIndex, (int)pass[0]);
                draw();
            }
        }
        finally
        {
            (drawn, eyes, EyeViews.Camera) = (null, [], null);
            GlobalProperties.Sheet.SetInteger(EyeIndex, 0);
        }

        EyeTextures.Show(camera.stereoTargetEye);
    }

    private static IEnumerable<Camera.StereoscopicEye[]> Passes(StereoTargetEyeMask mask)
    {
        const Camera.StereoscopicEye Left = Camera.StereoscopicEye.Left;
        const Camera.StereoscopicEye Right = Camera.StereoscopicEye.Right;
        if (Mode == StereoMode.Instanced)
        {
            yield return [Left, Right];
            yield break;
        }

        if ((mask & StereoTargetEyeMask.Left) != 0)
        {
            yield return [Left];
        }

        if ((mask & StereoTargetEyeMask.Right) != 0)
        {
            yield return [Right];
        }
    }
}
