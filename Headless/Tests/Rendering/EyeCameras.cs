using Headless.Engine;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.XR;

namespace Headless.Tests.Rendering;

/// <summary>Cameras of one picture where the eyes of a stereo camera are, which draw the same frame into textures.</summary>
internal sealed class EyeCameras
{
    private readonly RenderTexture[] pictures = new RenderTexture[2];

    public EyeCameras(Camera stereo)
    {
        for (int eye = 0; eye < 2; eye++)
        {
            var camera = new GameObject($"Eye {eye}").AddComponent<Camera>();
            camera.CopyFrom(stereo);
            camera.transform.position += stereo.transform.right * ((eye - 0.5f) * stereo.stereoSeparation);
            camera.projectionMatrix = stereo.GetStereoProjectionMatrix((Camera.StereoscopicEye)eye);
            camera.depthTextureMode = DepthTextureMode.None;
            pictures[eye] = new RenderTexture(stereo.pixelWidth, stereo.pixelHeight, 24) { antiAliasing = XRSettings.eyeTextureDesc.msaaSamples };
            camera.targetTexture = pictures[eye];
        }
    }

    /// <summary>Compares the halves of the screen with the cameras' pictures.</summary>
    public void AssertAlike(string name, double most = 0.002)
    {
        Picture screen = Picture.OfScreen().Keep(name);
        Picture[] expected = [Picture.Of(pictures[0]).Keep(name + "-left"), Picture.Of(pictures[1]).Keep(name + "-right")];
        (int width, int height) = (expected[0].Width, expected[0].Height);
        Assert.That(width, Is.EqualTo(screen.Width / 2));
        Assert.Multiple(() =>
        {
            for (int eye = 0; eye < 2; eye++)
            {
                int at = eye * width;
                Assert.That(Share(width, height, (x, y) => Differ(screen.At(at + x, y), expected[eye].At(x, y))), Is.LessThan(most), $"eye {eye}");
            }

            Assert.That(Share(width, height, (x, y) => Differ(expected[0].At(x, y), expected[1].At(x, y))), Is.GreaterThan(0.02), "the eyes see different pictures");
        });
    }

    private static bool Differ(Color32 a, Color32 b) => Math.Max(Math.Abs(a.r - b.r), Math.Max(Math.Abs(a.g - b.g), Math.Abs(a.b - b.b))) > 3;

    private static double Share(int width, int height, Func<int, int, bool> holds)
    {
        int count = 0;
        for (int i = 0; i < width * height; i++)
        {
            count += holds(i % width, i / width) ? 1 : 0;
        }

        return count / (double)(width * height);
    }
}
