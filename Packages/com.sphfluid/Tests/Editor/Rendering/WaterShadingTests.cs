using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>Colours of water before a background of known colours, against the formulas they come from.</summary>
    public sealed class WaterShadingTests
    {
        const int Size = 64;
        const float HalfWidth = 0.5f;
        const float Near = 0.1f;
        const float Far = 10f;
        const float Distance = 2f;
        const float Reflectance = 0.02f;
        const int ForwardPass = 0;
        const int ShadowPass = 1;

        static readonly Vector3 Eye = new Vector3(0f, 0f, -Distance);
        static readonly Matrix4x4 View = SurfaceTestScene.LookAtOrigin(Eye);
        static readonly Matrix4x4 Parallel = Matrix4x4.Ortho(-HalfWidth, HalfWidth, -HalfWidth, HalfWidth, Near, Far);

        WaterDrawing water;
        UploadedSurface surface;
        FluidWaterLook look;
        Texture2D scene;
        Texture2D depth;
        Cubemap mirror;

        [SetUp]
        public void SetUp()
        {
            water = new WaterDrawing(SurfaceTestScene.LoadShaders());
            look = new FluidWaterLook { ColorAtOneMetre = new Color(0.3f, 0.6f, 0.8f), Visibility = 8f, Refraction = 1f };
            scene = NewTexture((x, y) => new Color(0.7f, 0.5f, 0.3f));
            depth = NewTexture((x, y) => Color.clear);
        }

        [TearDown]
        public void TearDown()
        {
            water?.Dispose();
            surface?.Dispose();
            Object.DestroyImmediate(scene);
            Object.DestroyImmediate(depth);
            if (mirror != null)
                Object.DestroyImmediate(mirror);
        }

        // 0.4 m of water straight on: exp(-extinction x 0.4 m) of 98 % of the background, no other light.
        [Test]
        public void BackgroundFadesByBeersLaw()
        {
            Box(0.4f);
            Color pixel = Centre(Render());
            for (int c = 0; c < 3; c++)
                Assert.AreEqual(scene.GetPixel(0, 0)[c] * Mathf.Exp(-0.4f * look.Extinction[c]) * (1f - Reflectance), pixel[c], 2e-3f, $"channel {c}");
            Assert.AreEqual(1f, pixel.a, 1e-4f);
        }

        // The bottom lies 0.1 m behind the front: only that much water counts. Depth is reversed on the device of Direct3D.
        [Test]
        public void WaterEndsAtTheSceneBehindIt()
        {
            Box(0.4f);
            SetDepth((x, y) => Distance - 0.2f + 0.1f);
            Color pixel = Centre(Render());
            for (int c = 0; c < 3; c++)
                Assert.AreEqual(scene.GetPixel(0, 0)[c] * Mathf.Exp(-0.1f * look.Extinction[c]) * (1f - Reflectance), pixel[c], 2e-3f, $"channel {c}");
        }

        [Test]
        public void ScatteredLightFillsDeepWater()
        {
            Box(0.4f);
            ReplaceScene((x, y) => Color.black);
            Color pixel = Centre(Render(block => block.SetVector("_FluidLightColour", Vector4.one)));
            for (int c = 0; c < 3; c++)
            {
                float share = look.Albedo[c] * (1f - Mathf.Exp(-0.4f * look.Extinction[c]));
                Assert.AreEqual(0.5f * share * (1f - Reflectance), pixel[c], 2e-3f, $"channel {c}");
            }
        }

        [Test]
        public void FlatWaterShiftsNothingAndSlopingWaterByTheLawOfRefraction()
        {
            ReplaceScene((x, y) => new Color((x + 0.5f) / Size, (y + 0.5f) / Size, 0f));
            look.ColorAtOneMetre = Color.white;
            look.Visibility = 1e6f;
            Box(0.4f);
            Color[] flat = Render();
            Assert.AreEqual((Size / 2 + 0.5f) / Size * (1f - Reflectance), Centre(flat).r, 2e-3f);

            surface.Dispose();
            var sloping = new Vector3(Mathf.Sin(0.5f), 0f, -Mathf.Cos(0.5f));
            surface = new UploadedSurface().Box(Vector3.zero, new Vector3(4f, 4f, 0.4f))
                .Quad(new Vector3(0f, 0f, -0.2f), Vector3.up * 2f, Vector3.right * 2f, sloping).Quad(new Vector3(0f, 0f, -0.2f), Vector3.right * 2f, Vector3.up * 2f, sloping);
            // 0.5 rad to the normal in air, asin(0.75 sin 0.5) in water.
            float turned = 0.5f - Mathf.Asin(0.75f * Mathf.Sin(0.5f));
            float shift = 0.4f * Mathf.Sin(turned) / (2f * HalfWidth);
            Color moved = Centre(Render());
            Assert.AreEqual(Centre(flat).r - shift, moved.r, 0.01f, "to the left, as the normal leans to the right");
            Assert.AreEqual(Centre(flat).g, moved.g, 0.01f);
        }

        // A thing in front of the water must not be smeared into it: there the undisplaced pixel is taken.
        [Test]
        public void ThingsInFrontOfTheWaterAreNotRefracted()
        {
            look.ColorAtOneMetre = Color.white;
            look.Visibility = 1e6f;
            ReplaceScene((x, y) => x < Size / 2 ? Color.red : Color.green);
            SetDepth((x, y) => x < Size / 2 ? 0.5f : Far);
            Slope(new Vector3(0.4f, 0f, -0.9f));
            Color pixel = Render()[Size / 2 * Size + Size / 2 + 1];
            Assert.Less(pixel.r, 0.02f);
            Assert.Greater(pixel.g, 0.8f);
        }

        [Test]
        public void MirrorGrowsFromTwoPercentToAll()
        {
            ReplaceScene((x, y) => Color.black);
            look.Visibility = 1e6f;
            Box(0.4f);
            Assert.AreEqual(Reflectance, Centre(Render(AmbientOfOne)).g, 2e-3f, "straight on");
            Slope(new Vector3(1f, 0f, -1e-4f));
            Assert.AreEqual(1f, Centre(Render(AmbientOfOne)).g, 0.01f, "grazing");
        }

        [Test]
        public void ReflectionMapIsMirroredWhereItIsGiven()
        {
            ReplaceScene((x, y) => Color.black);
            look.Visibility = 1e6f;
            mirror = NewCube(CubemapFace.NegativeZ, Color.red);
            Box(0.4f);
            Color pixel = Centre(Render(block =>
            {
                block.SetTexture("_FluidReflectionMap", mirror);
                block.SetVector("_FluidReflection", new Vector4(1f, 0f, 0f, 0f));
                block.SetVector("_FluidReflectionDecode", new Vector4(2f, 1f, 0f, 0f));
            }));
            Assert.AreEqual(2f * Reflectance, pixel.r, 2e-3f, "what lies behind the camera");
            Assert.AreEqual(0f, pixel.g, 1e-3f);
        }

        // As Unity 6 hands it over where the scene has no lighting data; a black map of the user's is mirrored as it is.
        [TestCase(1f, Reflectance)]
        [TestCase(0f, 0f)]
        public void AMapThatWasNeverBakedYieldsToTheAmbientLight(float mayBeUnbaked, float expected)
        {
            ReplaceScene((x, y) => Color.black);
            look.Visibility = 1e6f;
            mirror = NewCube(CubemapFace.NegativeZ, Color.black);
            Box(0.4f);
            Color pixel = Centre(Render(block =>
            {
                AmbientOfOne(block);
                block.SetTexture("_FluidReflectionMap", mirror);
                block.SetVector("_FluidReflection", new Vector4(1f, 0f, mayBeUnbaked, 0f));
                block.SetVector("_FluidReflectionDecode", new Vector4(1f, 1f, 0f, 0f));
            }));
            Assert.AreEqual(expected, pixel.g, 2e-3f);
        }

        // Without the scene's colour the water is blended over it: what it lets through is left to the blending.
        [Test]
        public void WithoutTheSceneWaterIsBlended()
        {
            Box(0.4f);
            Color pixel = Centre(Render(block => block.SetVector("_FluidScene", Vector4.zero)));
            float left = 0f;
            for (int c = 0; c < 3; c++)
                left += Mathf.Exp(-0.4f * look.Extinction[c]) / 3f;
            Assert.AreEqual(1f - left * (1f - Reflectance), pixel.a, 2e-3f);
        }

        // A surface without its wall faces: the water reaches to the domain's wall.
        [Test]
        public void OpenSurfaceEndsAtTheDomain()
        {
            surface = new UploadedSurface().Quad(new Vector3(0f, 0f, -0.2f), Vector3.up * 2f, Vector3.right * 2f, Vector3.back);
            Color pixel = Centre(Render());
            Assert.AreEqual(scene.GetPixel(0, 0).r * Mathf.Exp(-2.2f * look.Extinction.x) * (1f - Reflectance), pixel.r, 4e-3f);
        }

        [TestCase(0f, 0)]
        [TestCase(0.25f, 2)]
        [TestCase(0.5f, 5)]
        [TestCase(1f, 9)]
        public void ShadowCoversItsShareOfTheTexels(float strength, int ofNine)
        {
            Box(0.4f);
            look.Shadow = strength;
            int covered = 0;
            Color[] picture = Render(null, ShadowPass, Color.white);
            for (int y = 0; y < 9; y++)
            {
                for (int x = 0; x < 9; x++)
                    covered += picture[y * Size + x].r < 0.5f ? 1 : 0;
            }
            Assert.AreEqual(9 * ofNine, covered);
        }

        void Box(float thickness) => surface = new UploadedSurface().Box(Vector3.zero, new Vector3(4f, 4f, thickness));

        // 0.4 m of water whose front has another normal than its shape.
        void Slope(Vector3 normal)
        {
            surface?.Dispose();
            surface = new UploadedSurface()
                .Quad(new Vector3(0f, 0f, -0.2f), Vector3.up * 2f, Vector3.right * 2f, normal)
                .Quad(new Vector3(0f, 0f, 0.2f), Vector3.right * 2f, Vector3.up * 2f, Vector3.forward);
        }

        Color[] Render(Action<MaterialPropertyBlock> change = null, int pass = ForwardPass, Color background = default)
        {
            var placement = new DrawPlacement(Matrix4x4.identity, Vector3.one * 4f, 0f, 0, false);
            SurfaceBuffers buffers = surface.Buffers;
            water.Fill(buffers, new SurfaceGrid(Vector3.one * -2f, Vector3.one * 4f, 64), SurfaceWalls.Closed, placement);
            water.SetLook(buffers, look, Vector2Int.one * Size, placement);
            water.SetSurface(look);
            MaterialPropertyBlock block = water.Block;
            block.SetVector("_FluidLightDirection", Vector3.up);
            block.SetVector("_FluidLightColour", Vector4.zero);
            block.SetVectorArray("_FluidAmbient", new Vector4[7]);
            block.SetVector("_FluidReflection", Vector4.zero);
            block.SetVector("_FluidScene", new SceneTextures(SceneColourSource.Copy, true).ToVector());
            block.SetVector("_FluidThicknessView", new Vector4(Size, Size, 0f, 0f));
            block.SetTexture("_FluidSceneColour", scene);
            block.SetTexture("_CameraDepthTexture", depth);
            block.SetVector("unity_OrthoParams", new Vector4(HalfWidth, HalfWidth, 0f, 1f));
            change?.Invoke(block);
            GpuTest.Run(cmd => water.Thickness.Record(cmd, View, Parallel, Vector2Int.one * Size));
            return SurfaceTestScene.Render(Size, View, Parallel, cmd =>
            {
                cmd.ClearRenderTarget(false, true, background);
                cmd.SetGlobalVector("_WorldSpaceCameraPos", Eye);
                cmd.SetGlobalVector("_ProjectionParams", new Vector4(-1f, Near, Far, 1f / Far));
                cmd.DrawProceduralIndirect(buffers.Indices, Matrix4x4.identity, water.Material, pass, MeshTopology.Triangles, buffers.Arguments, 0, block);
            });
        }

        static Color Centre(Color[] picture) => picture[Size / 2 * Size + Size / 2];

        static void AmbientOfOne(MaterialPropertyBlock block)
        {
            var ambient = new Vector4[7];
            for (int c = 0; c < 3; c++)
                ambient[c] = new Vector4(0f, 0f, 0f, 1f);
            block.SetVectorArray("_FluidAmbient", ambient);
        }

        void ReplaceScene(Func<int, int, Color> colour)
        {
            Object.DestroyImmediate(scene);
            scene = NewTexture(colour);
        }

        // Metres from the camera as an orthographic depth texture holds them.
        void SetDepth(Func<int, int, float> metres)
        {
            Object.DestroyImmediate(depth);
            depth = NewTexture((x, y) =>
            {
                float between = (metres(x, y) - Near) / (Far - Near);
                return new Color(SystemInfo.usesReversedZBuffer ? 1f - between : between, 0f, 0f);
            });
        }

        static Texture2D NewTexture(Func<int, int, Color> colour)
        {
            var made = new Texture2D(Size, Size, TextureFormat.RGBAFloat, false, true) { wrapMode = TextureWrapMode.Clamp };
            for (int i = 0; i < Size * Size; i++)
                made.SetPixel(i % Size, i / Size, colour(i % Size, i / Size));
            made.Apply();
            return made;
        }

        static Cubemap NewCube(CubemapFace lit, Color colour)
        {
            var made = new Cubemap(4, TextureFormat.RGBAFloat, false);
            for (int face = 0; face < 6; face++)
            {
                for (int i = 0; i < 16; i++)
                    made.SetPixel((CubemapFace)face, i % 4, i / 4, face == (int)lit ? colour : Color.black);
            }
            made.Apply();
            return made;
        }
    }
}
