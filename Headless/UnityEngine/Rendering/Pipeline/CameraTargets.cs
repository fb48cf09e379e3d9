using Headless.Vulkan;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Chooses what a camera draws into, clears it, and brings the picture to its destination.</summary>
internal sealed class CameraTargets
{
    private GpuTexture? color;
    private GpuTexture? depth;
    private (int Width, int Height, int Samples) size;

    public CameraFrame Begin(Camera camera)
    {
        DrawTarget final = Final(camera);
        bool wholeTarget = camera.pixelWidth == final.Width && camera.pixelHeight == final.Height;
        int samples = Samples(camera);
        CameraFrame frame;
        if (EyeViews.Camera is null && (ImageEffects.Of(camera).Count > 0 || !wholeTarget))
        {
            RenderTexture intermediate = RenderTexture.GetTemporary(new RenderTextureDescriptor(camera.pixelWidth, camera.pixelHeight, RenderTextureFormat.ARGB32, 24)
            {
                msaaSamples = samples,
            });
            frame = new CameraFrame(DrawTarget.Of(intermediate), intermediate);
        }
        else
        {
            frame = new CameraFrame(Of(camera), null);
        }

        TargetState.Set(frame.Target);
        Clear(camera);
        return frame;
    }

    /// <summary>The camera's texture, or the screen with its own depth.</summary>
    public DrawTarget Of(Camera camera) => camera.targetTexture != null ? DrawTarget.Of(camera.targetTexture)
        : Stereo.Draws(camera) ? EyeTextures.Target : ScreenBuffers(Samples(camera));

    /// <summary>Runs image effects, or copies the intermediate picture to where the camera's rectangle lies.</summary>
    public void Finish(Camera camera, CameraFrame frame)
    {
        if (frame.Intermediate is not { } picture)
        {
            return;
        }

        DrawTarget final = Final(camera);
        bool wholeTarget = camera.pixelWidth == final.Width && camera.pixelHeight == final.Height;
        if (!wholeTarget)
        {
            RenderTexture processed = RenderTexture.GetTemporary(new RenderTextureDescriptor(picture.width, picture.height, RenderTextureFormat.ARGB32, 0));
            ImageEffects.Run(camera, picture, processed, DrawTarget.Of(processed));
            Blitter.Blit(processed, final, null, 0, Vector2.one, Vector2.zero, camera.pixelRect);
            RenderTexture.ReleaseTemporary(processed);
        }
        else
        {
            ImageEffects.Run(camera, picture, Stereo.Draws(camera) ? EyeTextures.Current : camera.targetTexture, final);
        }
    }

    public void Reset() => (color, depth, size) = (null, null, default);

    private static DrawTarget Final(Camera camera) =>
        camera.targetTexture != null ? DrawTarget.Of(camera.targetTexture)
        : Stereo.Draws(camera) ? EyeTextures.Target : DrawTarget.Screen;

    private static int Samples(Camera camera) => camera.allowMSAA ? Samples(QualitySettings.antiAliasing) : 1;

    private static int Samples(int requested) =>
        SystemInfo.GetRenderTextureSupportedMSAASampleCount(new RenderTextureDescriptor(1, 1) { msaaSamples = requested is 2 or 4 or 8 ? requested : 1 });

    private static void Clear(Camera camera)
    {
        Color background = camera.backgroundColor.linear;
        switch (camera.clearFlags)
        {
            case CameraClearFlags.Skybox or CameraClearFlags.SolidColor:
                TargetState.Clear(true, true, background, 0f);
                break;
            case CameraClearFlags.Depth:
                TargetState.Clear(false, true, background, 0f);
                break;
        }
    }

    /// <summary>The screen's own multisampled color and depth; they outlive the frame so that a second camera draws over the first.</summary>
    private DrawTarget ScreenBuffers(int samples)
    {
        GpuTexture screen = ScreenTarget.Texture;
        if (depth is null || size != (ScreenTarget.Width, ScreenTarget.Height, samples))
        {
            TextureMemory.Release(color);
            TextureMemory.Release(depth);
            size = (ScreenTarget.Width, ScreenTarget.Height, samples);
            color = samples > 1 ? Make(screen.Description.Format, samples, "Screen MSAA") : null;
            depth = Make(GpuFormat.D32Float, samples, "Screen depth");
        }

        return new DrawTarget
        {
            Colors = [color ?? screen],
            Resolves = [color is null ? null : screen],
            Depth = depth,
        };
    }

    private static GpuTexture Make(GpuFormat format, int samples, string name) => TextureMemory.Create(
        new GpuTextureDescription
        {
            Width = ScreenTarget.Width,
            Height = ScreenTarget.Height,
            Format = format,
            Samples = samples,
            Usage = TextureUse.RenderTarget,
        },
        name);
}
