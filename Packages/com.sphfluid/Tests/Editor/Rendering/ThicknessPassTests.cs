using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>The thickness picture against lines cut with boxes and balls on the CPU.</summary>
    public sealed class ThicknessPassTests
    {
        private const int Size = 33;
        private const float Distance = 2f;

        private static readonly Vector3 Eye = new Vector3(0f, 0f, -Distance);
        private static readonly Matrix4x4 Perspective = Matrix4x4.Perspective(40f, 1f, 0.05f, 10f);
        private static readonly Matrix4x4 Parallel = Matrix4x4.Ortho(-0.8f, 0.8f, -0.8f, 0.8f, 0.05f, 10f);

        private FluidShaderSet shaders;

        [SetUp]
        public void SetUp()
        {
            shaders = SurfaceTestScene.LoadShaders();
            if (!SystemInfo.SupportsBlendingOnRenderTextureFormat(RenderTextureFormat.RGHalf))
            {
                Assert.Ignore("The device does not blend half floats.");
            }
        }

        [TestCase(false)]
        [TestCase(true)]
        public void BoxIsAsThickAsItIs(bool parallel)
        {
            var centre = new Vector3(0.1f, -0.05f, 0.1f);
            var size = new Vector3(0.9f, 0.7f, 0.6f);
            Compare(new UploadedSurface().Box(centre, size), parallel, ray => BoxSpan(ray, centre, size));
        }

        [TestCase(false)]
        [TestCase(true)]
        public void BallIsAsThickAsItIs(bool parallel)
        {
            var centre = new Vector3(-0.1f, 0.05f, 0.2f);
            Compare(new UploadedSurface().Ball(centre, 0.45f, 192), parallel, ray => BallSpan(ray, centre, 0.45f));
        }

        [Test]
        public void LayersAddUp()
        {
            Vector3 near = new Vector3(0.05f, 0f, -0.4f), far = new Vector3(0f, 0.1f, 0.5f);
            var size = new Vector3(0.8f, 0.8f, 0.2f);
            Compare(new UploadedSurface().Box(near, size).Box(far, size), false, ray => BoxSpan(ray, near, size) + BoxSpan(ray, far, size));
        }

        // Only the far face is seen: red and green together give its depth.
        [Test]
        public void CameraWithinTheWaterSeesTheFarFace()
        {
            var size = new Vector3(1f, 1f, 6f);
            using (UploadedSurface box = new UploadedSurface().Box(Vector3.zero, size))
            {
                foreach (Color pixel in Measure(box, Perspective, new Vector2Int(Size, Size), false, new RectInt(Size / 2, Size / 2, 1, 1)))
                {
                    Assert.AreEqual(1f, pixel.g, 1e-3f, "faces without a partner");
                    Assert.AreEqual(Distance + 3f, pixel.r + pixel.g * Distance, 0.01f * 5f);
                }
            }
        }

        [TestCase(33, 17)]
        [TestCase(32, 16)]
        public void HalfResolutionRoundsUp(int view, int expected)
        {
            var size = new Vector3(3f, 3f, 0.5f);
            using (UploadedSurface box = new UploadedSurface().Box(Vector3.zero, size))
            {
                Color[] picture = Measure(box, Parallel, new Vector2Int(view, view), true, new RectInt(0, 0, expected, expected));
                Assert.AreEqual(expected * expected, picture.Length);
                foreach (Color pixel in picture) Assert.AreEqual(0.5f, pixel.r, 0.005f);
            }
        }

        [Test]
        public void SmallerViewFillsTheLowerLeftPart()
        {
            using (UploadedSurface box = new UploadedSurface().Box(new Vector3(0.4f, 0.4f, 0f), new Vector3(0.8f, 0.8f, 0.5f)))
            using (var pass = new ThicknessPass(shaders))
            {
                pass.Prepare(box.Buffers, Placement(), new Vector2Int(40, 30), false);
                Color[] picture = Read(pass, Parallel, new Vector2Int(20, 16), new RectInt(0, 0, 40, 30));
                for (int y = 0; y < 30; y++)
                {
                    for (int x = 0; x < 40; x++)
                    {
                        Assert.AreEqual(x >= 10 && x < 20 && y >= 8 && y < 16 ? 0.5f : 0f, picture[y * 40 + x].r, 0.005f,
                            $"pixel {x}, {y}");
                    }
                }
            }
        }

        [Test]
        public void NothingIsLeftAfterDisposal()
        {
            using (UploadedSurface box = new UploadedSurface().Box(Vector3.zero, Vector3.one))
            {
                var pass = new ThicknessPass(shaders);
                pass.Prepare(box.Buffers, Placement(), Vector2Int.one * 8, false);
                RenderTexture texture = pass.Texture;
                Assert.IsTrue(texture != null);
                pass.Dispose();
                Assert.IsTrue(texture == null);
            }
        }

        private void Compare(UploadedSurface surface, bool parallel, Func<Ray, float> span)
        {
            using (surface)
            {
                Color[] picture =
                    Measure(surface, parallel ? Parallel : Perspective, Vector2Int.one * Size, false, new RectInt(0, 0, Size, Size));
                int covered = 0;
                for (int i = 0; i < picture.Length; i++)
                {
                    Ray ray = RayOf(i % Size, i / Size, parallel);
                    float expected = span(ray) * ray.direction.z;
                    if (expected < 0.15f) continue;
                    covered++;
                    Assert.AreEqual(expected, picture[i].r, 0.01f * expected, $"pixel {i % Size}, {i / Size}");
                    Assert.AreEqual(0f, picture[i].g, 1e-3f);
                }
                Assert.Greater(covered, 100, "pixels with water");
            }
        }

        [Test]
        public void BothEyesAtOnceHaveASliceEach()
        {
            Matrix4x4 projection = Matrix4x4.Perspective(40f, 1f, 0.1f, 10f);
            Matrix4x4 left = SurfaceTestScene.LookAtOrigin(Eye), right = SurfaceTestScene.LookAtOrigin(Eye + 0.4f * Vector3.right);
            var view = new Vector2Int(Size, Size);
            var whole = new RectInt(0, 0, Size, Size);
            using (var surface = new UploadedSurface().Box(new Vector3(0.1f, 0f, 0f), new Vector3(0.5f, 0.4f, 0.3f)))
            using (var pass = new ThicknessPass(shaders))
            {
                pass.Prepare(surface.Buffers, Placement(), view, false);
                GpuTest.Run(cmd => pass.Record(cmd, new CameraViews(left, projection, right, projection), view));
                Color[] first = ReadSlice(pass.Eyes, 0, whole), second = ReadSlice(pass.Eyes, 1, whole);
                GpuTest.Run(cmd => pass.Record(cmd, new CameraViews(left, projection), view));
                CollectionAssert.AreEqual(Read(pass.Texture, whole), first);
                GpuTest.Run(cmd => pass.Record(cmd, new CameraViews(right, projection), view));
                CollectionAssert.AreEqual(Read(pass.Texture, whole), second);
                CollectionAssert.AreNotEqual(first, second);
            }
        }

        private static Color[] ReadSlice(RenderTexture slices, int slice, RectInt part)
        {
            var single = new RenderTexture(slices.width, slices.height, 0, slices.format, RenderTextureReadWrite.Linear);
            try
            {
                Graphics.CopyTexture(slices, slice, single, 0);
                return Read(single, part);
            }
            finally
            {
                single.Release();
                Object.DestroyImmediate(single);
            }
        }

        private Color[] Measure(UploadedSurface surface, Matrix4x4 projection, Vector2Int view, bool half, RectInt part)
        {
            using (var pass = new ThicknessPass(shaders))
            {
                pass.Prepare(surface.Buffers, Placement(), view, half);
                return Read(pass, projection, view, part);
            }
        }

        private static Color[] Read(ThicknessPass pass, Matrix4x4 projection, Vector2Int view, RectInt part)
        {
            GpuTest.Run(cmd => pass.Record(cmd, new CameraViews(SurfaceTestScene.LookAtOrigin(Eye), projection), view));
            return Read(pass.Texture, part);
        }

        private static Color[] Read(RenderTexture texture, RectInt part)
        {
            RenderTexture copy = RenderTexture.GetTemporary(texture.width, texture.height, 0, RenderTextureFormat.ARGBFloat,
                RenderTextureReadWrite.Linear);
            var picture = new Texture2D(part.width, part.height, TextureFormat.RGBAFloat, false, true);
            RenderTexture before = RenderTexture.active;
            try
            {
                Graphics.Blit(texture, copy);
                RenderTexture.active = copy;
                picture.ReadPixels(new Rect(part.x, part.y, part.width, part.height), 0, 0);
                picture.Apply();
                return picture.GetPixels();
            }
            finally
            {
                RenderTexture.active = before;
                RenderTexture.ReleaseTemporary(copy);
                Object.DestroyImmediate(picture);
            }
        }

        private static DrawPlacement Placement() => new DrawPlacement(Matrix4x4.identity, Vector3.one, 0f, 0, false);

        // Through the middle of a pixel; the camera looks along z.
        private static Ray RayOf(int x, int y, bool parallel)
        {
            var across = new Vector2((x + 0.5f) / Size * 2f - 1f, (y + 0.5f) / Size * 2f - 1f);
            if (parallel) return new Ray(Eye + (Vector3)(across * 0.8f), Vector3.forward);
            across *= Mathf.Tan(20f * Mathf.Deg2Rad);
            return new Ray(Eye, new Vector3(across.x, across.y, 1f));
        }

        private static float BoxSpan(Ray ray, Vector3 centre, Vector3 size)
        {
            float entry = 0f, exit = float.PositiveInfinity;
            for (int axis = 0; axis < 3; axis++)
            {
                float offset = centre[axis] - ray.origin[axis], half = 0.5f * size[axis];
                if (ray.direction[axis] == 0f)
                {
                    if (Mathf.Abs(offset) > half) return 0f;
                    continue;
                }
                float a = (offset - half) / ray.direction[axis], b = (offset + half) / ray.direction[axis];
                entry = Mathf.Max(entry, Mathf.Min(a, b));
                exit = Mathf.Min(exit, Mathf.Max(a, b));
            }
            return Mathf.Max(exit - entry, 0f);
        }

        private static float BallSpan(Ray ray, Vector3 centre, float radius)
        {
            Vector3 offset = centre - ray.origin;
            float along = Vector3.Dot(offset, ray.direction);
            float squared = radius * radius - (offset.sqrMagnitude - along * along);
            return squared > 0f ? 2f * Mathf.Sqrt(squared) : 0f;
        }
    }
}
