using System;
using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// Shadows of the main light on liquid of known shape, against where geometry says that they fall.
    /// </summary>
    public sealed class LiquidShadowTests
    {
        // Of the map, whose texels are 2 mm here: what its filter and the step beside the surface move an edge by.
        private const float EdgeDoubt = 0.015f;

        private readonly ShadowQuality quality = QualitySettings.shadows;
        private ShadowRig rig;

        [SetUp]
        public void SetUp()
        {
            GpuTest.Require();
            QualitySettings.shadows = ShadowQuality.All;
        }

        [TearDown]
        public void TearDown()
        {
            rig?.Dispose();
            rig = null;
            QualitySettings.shadows = quality;
        }

        private static readonly (FluidSurfaceLook Look, float Strength, Vector3 Towards)[] cases =
        {
            (FluidSurfaceLook.Opaque, 1f, new Vector3(0.5f, 1f, 0.2f)),
            (FluidSurfaceLook.Opaque, 0.5f, new Vector3(0.3f, 1f, -0.4f)),
            (FluidSurfaceLook.Water, 1f, new Vector3(0.5f, 1f, 0.2f)),
            (FluidSurfaceLook.Water, 0.5f, new Vector3(0.5f, 1f, 0.2f)),
            (FluidSurfaceLook.Water, 0.25f, new Vector3(0.1f, 1f, 0f)),
        };

        [UnityTest]
        public IEnumerator TheEdgeFallsWhereTheLightPutsIt([ValueSource(nameof(cases))] (FluidSurfaceLook Look, float Strength,
            Vector3 Towards) given)
        {
            rig = new ShadowRig(given.Look);
            rig.Light.transform.rotation = Quaternion.LookRotation(-given.Towards);
            rig.Light.shadowStrength = given.Strength;
            yield return rig.Frame();
            float[] shaded = rig.Pixels();
            rig.Light.intensity = 0f;
            yield return rig.Frame();
            float[] dark = rig.Pixels();
            rig.Light.intensity = 1f;
            rig.Occluder.SetActive(false);
            yield return rig.Frame();
            float[] lit = rig.Pixels();

            int inShadow = 0, inLight = 0;
            for (int i = 0; i < lit.Length; i++)
            {
                float beyond = ShadowRig.Place(i % ShadowRig.Size) - rig.EdgeOfShadow;
                float left = rig.Occluder.transform.position.x - 0.5f - 0.65f * given.Towards.x / given.Towards.y;
                if (Mathf.Abs(beyond) < EdgeDoubt || ShadowRig.Place(i % ShadowRig.Size) < left + EdgeDoubt) continue;
                Assert.Greater(lit[i] - dark[i], 0.005f, "there is sunlight to take away");
                float share = (shaded[i] - dark[i]) / (lit[i] - dark[i]);
                Assert.AreEqual(beyond > 0f ? 1f : 1f - given.Strength, share, 0.01f, $"{beyond} m from the edge");
                (inShadow, inLight) = (inShadow + (beyond < 0f ? 1 : 0), inLight + (beyond > 0f ? 1 : 0));
            }
            Assert.Greater(inShadow, 300);
            Assert.Greater(inLight, 300);
        }

        [UnityTest]
        public IEnumerator WithoutTheTickOrShadowsItIsLit([Values] FluidSurfaceLook look, [Values(0, 1, 2)] int without)
        {
            // The quality level's shadows are the Built-in pipeline's, and so are command buffers on lights.
            using PipelineSwitch builtIn = without == 2 ? PipelineSwitch.ToBuiltIn() : null;
            int onLight = GraphicsSettings.currentRenderPipeline == null ? 2 : 0;
            rig = new ShadowRig(look);
            rig.Occluder.SetActive(false);
            yield return rig.Frame();
            float[] lit = rig.Pixels();
            rig.Occluder.SetActive(true);
            yield return rig.Frame();
            Assert.Less(rig.Pixels().Sum(), 0.9f * lit.Sum(), "a shadow to take away");
            Assert.AreEqual(onLight, rig.Light.commandBufferCount);
            if (without == 0)
                rig.ReceiveShadows = false;
            else if (without == 1)
                rig.Light.shadows = LightShadows.None;
            else
                QualitySettings.shadows = ShadowQuality.Disable;
            yield return rig.Frame();
            Assert.That(rig.Pixels(), Is.EqualTo(lit).Within(1e-4f));
            Assert.AreEqual(without == 0 ? onLight : 0, rig.Light.commandBufferCount);
        }

        // Only the box casts, so that the map ends near it.
        [UnityTest]
        public IEnumerator OutsideTheMapItIsLit()
        {
            rig = new ShadowRig(FluidSurfaceLook.Opaque);
            rig.Occluder.transform.localScale = Vector3.one * 0.1f;
            rig.Occluder.transform.position = new Vector3(0f, 0.3f, 0f);
            yield return rig.Frame();
            float[] shaded = rig.Pixels();
            rig.ReceiveShadows = false;
            yield return rig.Frame();
            float[] lit = rig.Pixels();
            int dark = 0;
            Vector3 towards = -rig.Light.transform.forward;
            for (int i = 0; i < lit.Length; i++)
            {
                var place = new Vector3(ShadowRig.Place(i % ShadowRig.Size), 0f, ShadowRig.Place(i / ShadowRig.Size));
                bool isHidden = rig.Occluder.GetComponent<Renderer>().bounds.IntersectRay(new Ray(place, towards));
                float nearest = Vector3.Cross(place - rig.Occluder.transform.position, towards).magnitude;
                dark += shaded[i] < 0.01f * lit[i] ? 1 : 0;
                if (nearest > 0.1f) Assert.AreEqual(lit[i], shaded[i], 1e-4f, $"at {place}");
                if (nearest < 0.04f) Assert.IsTrue(isHidden && shaded[i] < 0.01f * lit[i], $"at {place}");
            }
            Assert.Greater(dark, 20);
        }

        [UnityTest]
        public IEnumerator CamerasSeeTheShadowInTheSamePlace()
        {
            rig = new ShadowRig(FluidSurfaceLook.Water);
            Camera second = ShadowRig.NewCamera(ShadowRig.Size / 2);
            second.transform.position += new Vector3(0.1f, 1f, 0f);
            second.depth = 1f;
            try
            {
                yield return rig.Frame();
                yield return rig.Frame();
                int middle = ShadowRig.Size / 2;
                float[] first = rig.Pixels();
                float[] other = ShadowRig.Pixels(second);
                float near = Edge(first, ShadowRig.Size, middle);
                float moved = Edge(other, ShadowRig.Size / 2, middle / 2) + 0.1f;
                Assert.AreEqual(rig.EdgeOfShadow, near, 1.5f / ShadowRig.Size);
                Assert.AreEqual(rig.EdgeOfShadow, moved, 3f / ShadowRig.Size);
            }
            finally
            {
                ShadowRig.Destroy(second);
            }
        }

        // By command buffers of the light, as the Built-in pipeline has them.
        [UnityTest]
        public IEnumerator TheMapOfTheMainLightIsKeptAndOfNoOther()
        {
            using PipelineSwitch builtIn = PipelineSwitch.ToBuiltIn();
            rig = new ShadowRig(FluidSurfaceLook.Opaque);
            Light first = rig.Light;
            Light second = ShadowRig.NewLight(Vector3.up);
            try
            {
                yield return rig.Frame();
                Assert.AreEqual(1, first.GetCommandBuffers(LightEvent.AfterShadowMap).Length);
                Assert.AreEqual(1, first.GetCommandBuffers(LightEvent.BeforeScreenspaceMask).Length);
                Assert.AreEqual(0, second.commandBufferCount);
                RenderSettings.sun = second;
                yield return rig.Frame();
                Assert.AreEqual(0, first.commandBufferCount);
                Assert.AreEqual(2, second.commandBufferCount);
                float right = rig.Pixels()[ShadowRig.Size / 2 * ShadowRig.Size + (int)(0.75f * ShadowRig.Size)];
                Assert.Less(right, 1e-4f, "the box is above it");
            }
            finally
            {
                Object.DestroyImmediate(second.gameObject);
            }
            yield return rig.Frame();
            Assert.AreEqual(2, first.commandBufferCount, "back to the one that is left");
            Object.DestroyImmediate(first.gameObject);
            rig.Light = null;
            yield return rig.Frame();
            Assert.IsTrue(MainLightShadows.Light == null);
        }

        // The liquid casts and receives: darkest pixel of what the light meets, over that of a liquid that receives nothing. Light from
        // steep to grazing.
        [UnityTest]
        public IEnumerator AFlatLiquidDoesNotShadeItself([Values] FluidSurfaceLook look, [Values(0f, 80f)] float fromAbove,
            [Values(0f, 0.6f)] float ownShadow)
        {
            rig = new ShadowRig(look) { CastShadows = true, OwnShadow = ownShadow };
            rig.Occluder.SetActive(false);
            rig.Light.transform.rotation = Quaternion.Euler(90f - fromAbove, 30f, 0f);
            yield return rig.Frame();
            float[] own = rig.Pixels();
            rig.ReceiveShadows = false;
            yield return rig.Frame();
            float[] lit = rig.Pixels();
            for (int i = 0; i < lit.Length; i++) Assert.AreEqual(lit[i], own[i], 0.01f * lit[i], $"pixel {i}");
        }

        // A ball of water on water: under it lies its own kind, whose partial shadow is given back.
        [UnityTest]
        public IEnumerator WaterUnderWaterIsNotDarkened([Values(0.25f, 0.5f)] float ownShadow)
        {
            rig = new ShadowRig(FluidSurfaceLook.Water) { CastShadows = true, OwnShadow = ownShadow };
            rig.Occluder.SetActive(false);
            rig.Surface = new UploadedSurface().Box(new Vector3(0f, -0.2f, 0f), new Vector3(1.2f, 0.4f, 1.2f))
                .Ball(new Vector3(0.1f, 0.3f, 0f), 0.2f, 24);
            yield return rig.Frame();
            float[] own = rig.Pixels();
            rig.ReceiveShadows = false;
            yield return rig.Frame();
            float[] lit = rig.Pixels();
            Assert.AreEqual(lit.Sum(), own.Sum(), 0.01f * lit.Sum(), "all of it");
            for (int i = 0; i < lit.Length; i++) Assert.AreEqual(lit[i], own[i], 0.05f * lit[i] + 1e-4f, $"pixel {i}");
        }

        [UnityTest]
        public IEnumerator AnOpaqueBallShadesWhatIsUnderIt()
        {
            rig = new ShadowRig(FluidSurfaceLook.Opaque) { CastShadows = true };
            rig.Occluder.SetActive(false);
            rig.Light.transform.rotation = Quaternion.Euler(45f, 90f, 0f); // towards -x
            rig.Surface = new UploadedSurface().Box(new Vector3(0f, -0.2f, 0f), new Vector3(1.2f, 0.4f, 1.2f))
                .Ball(new Vector3(-0.2f, 0.3f, 0f), 0.1f, 24);
            yield return rig.Frame();
            float[] own = rig.Pixels();
            rig.ReceiveShadows = false;
            yield return rig.Frame();
            float[] lit = rig.Pixels();
            for (int i = 0; i < lit.Length; i++)
            {
                var place = new Vector2(ShadowRig.Place(i % ShadowRig.Size), ShadowRig.Place(i / ShadowRig.Size));
                bool isBall = (place - new Vector2(-0.2f, 0f)).magnitude < 0.11f;
                float fromMiddle = new Vector2((place.x - 0.1f) * Mathf.Sqrt(0.5f), place.y).magnitude; // of a shadow 1.41 times as long
                if (!isBall && fromMiddle < 0.08f) Assert.Less(own[i], 0.01f * lit[i], $"under it, at {place}");
                if (!isBall && fromMiddle > 0.12f) Assert.AreEqual(lit[i], own[i], 0.01f * lit[i], $"beside it, at {place}");
                bool facesTheLight = isBall && place.x < -0.22f && (place - new Vector2(-0.2f, 0f)).magnitude < 0.08f;
                if (facesTheLight) Assert.AreEqual(lit[i], own[i], 0.02f * lit[i], $"on it, at {place}");
            }
        }

        // Water with spray and whitewater, and whatever else the components draw: under a lid it looks as it does without the sun.
        [UnityTest]
        public IEnumerator UnderALidNothingOfTheSunIsLeft([Values("water", "opaque", "particles", "thesis")] string drawn)
        {
            GameObject lid = GameObject.CreatePrimitive(PrimitiveType.Cube);
            using (var liquids = new SimulationRig())
            using (var view = new PictureRig(64, 64, 0.25f))
            {
                lid.GetComponent<Renderer>().shadowCastingMode = ShadowCastingMode.ShadowsOnly;
                lid.transform.position = new Vector3(0f, 1f, 0f);
                lid.transform.localScale = new Vector3(4f, 0.1f, 4f);
                view.Light.shadows = LightShadows.Soft;
                view.Light.transform.rotation = Quaternion.Euler(80f, 0f, 0f);
                FluidSimulation simulation = liquids.Create();
                FluidVolume lone = liquids.AddVolume(simulation, "Drop");
                lone.Size = Vector3.one * SimulationRig.Spacing;
                lone.transform.localPosition = new Vector3(0.15f, 0.15f, 0f);
                FluidWhitewater whitewater = Add(simulation, drawn);
                yield return PictureRig.Frames(12);
                Assert.IsTrue(whitewater == null || whitewater.Counts.Particles > 10, "there is whitewater to be seen");
                simulation.Paused = true;
                yield return PictureRig.Frames(2);
                Color[] covered = view.Pixels();
                view.Light.color = Color.black;
                yield return PictureRig.Frames(2);
                Color[] dark = view.Pixels();
                view.Light.color = Color.white;
                lid.SetActive(false);
                yield return PictureRig.Frames(2);
                float sunlit = view.Pixels().Sum(p => p.g), left = covered.Sum(p => p.g), nothing = dark.Sum(p => p.g);
                Assert.Greater(sunlit - nothing, 20f);
                Assert.AreEqual(nothing, left, 0.01f * (sunlit - nothing));
            }
            Object.DestroyImmediate(lid);
        }

        private static FluidWhitewater Add(FluidSimulation simulation, string drawn)
        {
            if (drawn == "particles")
                simulation.gameObject.AddComponent<FluidParticleRenderer>();
            else if (drawn == "thesis")
                simulation.gameObject.AddComponent<FluidGeometrySurfaceRenderer>().GridSize = SurfaceGridSize.Cells32;
            else
                simulation.gameObject.AddComponent<FluidSurfaceRenderer>().Look = drawn == "water" ? FluidSurfaceLook.Water
                    : FluidSurfaceLook.Opaque;
            if (drawn != "water") return null;
            var whitewater = simulation.gameObject.AddComponent<FluidWhitewater>();
            whitewater.Amount = 100f;
            return whitewater;
        }

        // Across the edge, where half of the light is taken away.
        private static float Edge(float[] pixels, int size, int row)
        {
            float most = Enumerable.Range(0, size).Max(x => pixels[row * size + x]);
            int last = Enumerable.Range(0, size).Last(x => pixels[row * size + x] < 0.5f * most);
            return ShadowRig.Place(last, size) + 0.5f / size;
        }
    }
}
