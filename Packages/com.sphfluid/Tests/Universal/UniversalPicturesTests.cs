using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Rendering.Universal;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>
    /// Water by each setting of the Universal Render Pipeline that changes what it reads, beside the Built-in pipeline's picture.
    /// </summary>
    public sealed class UniversalPicturesTests : UniversalTest
    {
        [UnityTest]
        public IEnumerator ShadowsOfCascadesLieOnTheWater([Values(1, 4)] int cascades)
        {
            Cascades(cascades);
            Scene.Water.Water.Visibility = 0.3f; // milky, so that the water itself is lit
            yield return DrawBoth();
            AssertAlike();
            Color shaded = Universal.At(Scene.Camera.WorldToViewportPoint(OnTopInShadow));
            Scene.Sun.shadows = LightShadows.None;
            yield return DrawUniversal();
            Color lit = Universal.At(Scene.Camera.WorldToViewportPoint(OnTopInShadow));
            Assert.That(shaded.grayscale, Is.LessThan(0.9f * lit.grayscale));
        }

        [UnityTest]
        public IEnumerator WithoutACasterAllIsLit()
        {
            Scene.CastsShadows = false;
            yield return DrawBoth();
            AssertAlike();
            Picture withShadows = Universal;
            Scene.Sun.shadows = LightShadows.None;
            yield return DrawUniversal();
            AssertAlike(Universal, withShadows, 0.999);
        }

        [UnityTest]
        public IEnumerator MultisampledPicturesAgree()
        {
            yield return DrawUniversal();
            Picture jagged = Universal;
            Scene.Samples = 4;
            Asset.msaaSampleCount = 4;
            yield return DrawBoth();
            AssertAlike();
            Assert.That(StructuralSimilarity.Of(Universal, BuiltIn), Is.GreaterThan(StructuralSimilarity.Of(jagged, BuiltIn)),
                "edges are smooth");
        }

        // Half as many pixels, drawn over the whole picture: reduced, they are those of a picture of half the size. 0.95, as enlarging and
        // reducing takes away some of the contrast of neighbours.
        [UnityTest]
        public IEnumerator AtHalfTheScaleAllStaysInItsPlace()
        {
            yield return DrawUniversal();
            float red = Universal.PlaceOfRed(Scene.Front);
            Asset.renderScale = 0.5f;
            yield return DrawUniversal();
            Picture scaled = Universal.Halved();
            Assert.That(Universal.PlaceOfRed(Scene.Front), Is.EqualTo(red).Within(0.01f), "the block seen through the water");
            Scene.SetTarget(WaterScene.Width / 2, WaterScene.Height / 2);
            yield return DrawBuiltIn();
            AssertAlike(scaled, BuiltIn, 0.95);
        }

        [UnityTest]
        public IEnumerator AtTwiceTheScaleFourPixelsAreOne()
        {
            Asset.renderScale = 2f;
            yield return DrawUniversal();
            Picture scaled = Universal;
            Scene.SetTarget(2 * WaterScene.Width, 2 * WaterScene.Height);
            yield return DrawBuiltIn();
            AssertAlike(scaled, BuiltIn.Halved());
        }

        // Through a copy of a quarter of the size the red block has soft edges: they are compared less strictly.
        [UnityTest]
        public IEnumerator ThroughASmallerCopyTheBlockIsSeenInItsPlace(
            [Values(Downsampling.None, Downsampling._2xBilinear, Downsampling._4xBox, Downsampling._4xBilinear)] Downsampling downsampling)
        {
            AssetFields.Set(Asset, "m_OpaqueDownsampling", downsampling);
            yield return DrawBoth();
            bool isQuarter = downsampling == Downsampling._4xBox || downsampling == Downsampling._4xBilinear;
            AssertAlike(isQuarter ? 0.93 : 0.97);
            Assert.That(Universal.PlaceOfRed(Scene.Front), Is.EqualTo(BuiltIn.PlaceOfRed(Scene.Front)).Within(isQuarter ? 0.02f : 0.01f));
        }

        [UnityTest]
        public IEnumerator DepthPrimingChangesNothing()
        {
            yield return DrawUniversal();
            Picture plain = Universal;
            Renderer.depthPrimingMode = DepthPrimingMode.Forced;
            yield return DrawBoth();
            AssertAlike();
            AssertAlike(Universal, plain, 0.999);
        }

        [UnityTest]
        public IEnumerator TwoCamerasSeeTheWaterEachFromItsPlace()
        {
            Camera second = Scene.NewCamera("Second");
            second.transform.position = new Vector3(-0.7f, 0.3f, -0.8f);
            second.transform.LookAt(new Vector3(0f, -0.05f, 0f));
            second.fieldOfView = 40f;
            second.depth = 1f;
            var target = new RenderTexture(80, 60, 24);
            second.targetTexture = target;
            try
            {
                yield return DrawBuiltIn();
                Picture other = Picture.Of(target);
                yield return DrawUniversal();
                AssertAlike();
                AssertAlike(Picture.Of(target), other);
                Assert.That(StructuralSimilarity.Of(Picture.Of(target), Universal.Halved()), Is.LessThan(0.8));
            }
            finally
            {
                second.targetTexture = null;
                Object.DestroyImmediate(target);
            }
        }

        [UnityTest]
        public IEnumerator AnOverlayCameraDrawsOverTheWater()
        {
            const int layer = SimulationRig.Layer + 1;
            Scene.CastsShadows = false; // on what another camera draws
            GameObject block = Scene.NewBlock(new Vector3(0.1f, -0.06f, 0.1f), Vector3.one * 0.1f);
            block.layer = layer;
            block.GetComponent<Renderer>().shadowCastingMode = ShadowCastingMode.Off;
            Scene.Camera.cullingMask &= ~(1 << layer);
            Camera over = Scene.NewCamera("Over");
            over.transform.SetParent(Scene.Camera.transform, false);
            over.fieldOfView = Scene.Camera.fieldOfView;
            over.cullingMask = 1 << layer;
            over.clearFlags = CameraClearFlags.Depth;
            over.depth = 1f;
            over.targetTexture = Scene.Camera.targetTexture;
            yield return DrawBuiltIn();
            over.targetTexture = null;
            over.GetUniversalAdditionalCameraData().renderType = CameraRenderType.Overlay;
            Scene.Camera.GetUniversalAdditionalCameraData().cameraStack.Add(over);
            yield return DrawUniversal();
            AssertAlike();
            Color seen = Universal.At(Scene.Camera.WorldToViewportPoint(block.transform.position));
            Assert.That(seen.r, Is.GreaterThan(2f * seen.g), "a red block behind the water, drawn over it");
        }

        [UnityTest]
        public IEnumerator WaterReflectsTheProbeAroundIt()
        {
            Cubemap red = Map(Color.red), green = Map(Color.green);
            var probe = Scene.NewObject("Probe").AddComponent<ReflectionProbe>();
            probe.mode = ReflectionProbeMode.Custom;
            probe.size = Vector3.one * 4f;
            probe.customBakedTexture = green;
            try
            {
                yield return DrawUniversal();
                Color before = Universal.Mean(Scene.Front);
                probe.customBakedTexture = red;
                yield return DrawBoth();
                AssertAlike();
                Color after = Universal.Mean(Scene.Front);
                Assert.That(after.r, Is.GreaterThan(before.r + 0.01f));
                Assert.That(after.g, Is.LessThan(before.g - 0.01f));
            }
            finally
            {
                Object.DestroyImmediate(probe.gameObject);
                Object.DestroyImmediate(red);
                Object.DestroyImmediate(green);
            }
        }

        // The Scene view is drawn at its own size, whatever the asset's scale.
        [UnityTest]
        public IEnumerator TheSceneViewShowsTheWater()
        {
            Scene.Camera.cameraType = CameraType.SceneView;
            Asset.renderScale = 0.5f;
            yield return DrawBoth();
            AssertAlike();
            Scene.Water.enabled = false;
            yield return DrawUniversal();
            Assert.That(StructuralSimilarity.Of(Universal, BuiltIn), Is.LessThan(0.9), "without the water");
        }

        // What is brighter than white behind the water is white in a copy without HDR, and darker through the water.
        [UnityTest]
        public IEnumerator WithoutHdrTheCopyEndsAtWhite()
        {
            Scene.Camera.allowHDR = false;
            Asset.supportsHDR = false;
            yield return DrawBoth();
            AssertAlike();

            Scene.Camera.allowHDR = true;
            Scene.Sun.intensity = 6f;
            yield return DrawUniversal();
            Color cut = Universal.Mean(Scene.Front);
            Asset.supportsHDR = true;
            yield return DrawUniversal();
            Assert.That(Universal.Mean(Scene.Front).r, Is.GreaterThan(1.2f * cut.r));
        }

        // Lamps of the Built-in pipeline fall off by a table, Universal's by the square of the distance: pictures differ near lamps.
        [UnityTest]
        public IEnumerator SixLampsOfForwardPlusAreThoseOfForward()
        {
            Scene.Sun.intensity = 0.3f;
            QualitySettings.pixelLightCount = 6;
            Asset.maxAdditionalLightsCount = 6;
            yield return DrawUniversal();
            Picture dark = Universal;
            var places = new Vector3[6];
            for (int i = 0; i < places.Length; i++)
            {
                places[i] = new Vector3(-0.3f + 0.12f * i, -0.12f, -0.3f - 0.04f * (i % 2));
                Light lamp = Scene.NewObject("Lamp").AddComponent<Light>();
                lamp.transform.position = places[i];
                lamp.type = LightType.Point;
                lamp.range = 0.4f;
                lamp.intensity = 0.003f;
                lamp.color = i % 2 == 0 ? Color.green : Color.white;
            }
            yield return DrawUniversal();
            Picture forward = Universal;
            Renderer.renderingMode = RenderingMode.ForwardPlus;
            yield return DrawBoth();
            AssertAlike(Universal, forward, 0.995);
            AssertAlike(0.93);
            foreach (Vector3 place in places)
            {
                Vector3 below = Scene.Camera.WorldToViewportPoint(new Vector3(place.x, -0.2f, place.z));
                Assert.That(Universal.At(below).g, Is.GreaterThan(1.1f * dark.At(below).g), $"the floor below {place}");
            }
        }

        [UnityTest]
        public IEnumerator AParallelCameraSeesTheSame()
        {
            Scene.Camera.orthographic = true;
            Scene.Camera.orthographicSize = 0.32f;
            yield return DrawBoth();
            AssertAlike();
            Assert.That(Universal.PlaceOfRed(Scene.Front), Is.EqualTo(BuiltIn.PlaceOfRed(Scene.Front)).Within(0.01f));
        }

        // From below the water's top, the sky is seen through the water alone.
        [UnityTest]
        public IEnumerator TheSkyIsSeenThroughTheWater()
        {
            Scene.Behind.SetActive(false);
            Scene.Camera.transform.position = new Vector3(0f, -0.16f, -0.9f);
            Scene.Camera.transform.LookAt(new Vector3(0f, -0.04f, 0f));
            Vector3 place = Scene.Camera.WorldToViewportPoint(new Vector3(-0.1f, -0.04f, -0.2f));
            yield return DrawBoth();
            AssertAlike();
            Color noon = Universal.At(place);
            RenderSettings.skybox.SetColor("_Horizon", Color.black);
            RenderSettings.skybox.SetColor("_Zenith", Color.black);
            yield return DrawUniversal();
            Assert.That(Universal.At(place).b, Is.LessThan(0.7f * noon.b), "under a black sky");
        }

        private static Vector3 OnTopInShadow => new Vector3(0.14f, 0.05f, -0.08f);

        private static Cubemap Map(Color colour)
        {
            var map = new Cubemap(4, TextureFormat.RGBA32, false);
            var pixels = new Color[16];
            for (int i = 0; i < pixels.Length; i++) pixels[i] = colour;
            for (int face = 0; face < 6; face++) map.SetPixels(pixels, (CubemapFace)face);
            map.Apply();
            return map;
        }
    }
}
