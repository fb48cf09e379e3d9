using System.Diagnostics;
using Headless.Engine;
using NUnit.Framework;
using UnityEngine;
namespace Headless.Tests.Rendering;
public sealed class ZzBench : SceneFixture
{
    [TestCase(1)] [TestCase(4)]
    public void Bench(int aa)
    {
        QualitySettings.antiAliasing = aa;
        ScreenTarget.Resize(1280, 720);
        Camera camera = Camera(new Vector3(3f, 3f, -5f), Vector3.zero);
        camera.clearFlags = CameraClearFlags.Skybox;
        Sun(new Vector3(-1f, -1.5f, 0.5f));
        Primitive(PrimitiveType.Plane, new Vector3(0f, -0.5f, 0f));
        Primitive(PrimitiveType.Cube, Vector3.zero, Color.red);
        Primitive(PrimitiveType.Sphere, new Vector3(1.6f, 0f, 1f), Color.green);
        for (int i = 0; i < 6; i++)
        {
            var w = Stopwatch.StartNew();
            Frame();
            double cpu = w.Elapsed.TotalMilliseconds;
            GraphicsDevice.Device.WaitIdle();
            TestContext.Progress.WriteLine($"aa {aa}: record {cpu:f2} ms, done {w.Elapsed.TotalMilliseconds:f2} ms");
        }
        Picture.OfScreen().Keep("scene720-" + aa);
    }
}
