using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>The water look as cameras see it in play, and what it leaves behind.</summary>
    public sealed class WaterTests
    {
        private const int Width = 128;
        private const int Height = 64;

        private SimulationRig rig;
        private PictureRig view;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            view = new PictureRig(Width, Height, 0.25f);
            view.Camera.backgroundColor = new Color(0.6f, 0.6f, 0.6f);
        }

        [TearDown]
        public void TearDown()
        {
            view.Dispose();
            rig.Dispose();
        }

        [UnityTest]
        public IEnumerator BackgroundIsSeenThroughTintedWater()
        {
            FluidSurfaceRenderer drawing = Create("Fluid", Vector3.zero, new Color(0.02f, 0.5f, 1f));
            yield return PictureRig.Frames(3);
            Color seen = view.PixelAt(view.Pixels(), drawing.transform.position);
            Assert.Less(seen.r, 0.75f * 0.6f, "red is swallowed");
            Assert.Greater(seen.b, 0.8f * 0.6f, "blue comes through");
        }

        [UnityTest]
        public IEnumerator TwoLiquidsAreTintedEachByItsOwn()
        {
            FluidSurfaceRenderer left = Create("Left", new Vector3(-0.25f, 0f, 0f), new Color(1f, 0.02f, 0.02f));
            FluidSurfaceRenderer right = Create("Right", new Vector3(0.25f, 0f, 0f), new Color(0.02f, 1f, 0.02f));
            yield return PictureRig.Frames(3);
            Color[] picture = view.Pixels();
            Color red = view.PixelAt(picture, left.transform.position);
            Color green = view.PixelAt(picture, right.transform.position);
            Assert.Greater(red.r, 1.3f * red.g);
            Assert.Greater(green.g, 1.3f * green.r);
        }

        // Places in the world have steps of 1 mm there, an eighth of a pixel: so far the camera's matrix moves the picture as a whole.
        [UnityTest]
        public IEnumerator TenKilometresAwayWaterLooksTheSame() =>
            LooksTheSameFarAway(10000f, place => Create("Fluid", place, new Color(0.02f, 0.5f, 1f)), 0.97);

        // A pixel is half as wide as such a step. Powers of two keep the camera's matrix exact, and of several particles rounding might
        // decide which is in front.
        [UnityTest]
        public IEnumerator EightKilometresAwayAParticleIsDrawnTheSame()
        {
            view.Camera.orthographicSize = 1f / 64f;
            return LooksTheSameFarAway(8192f, OneParticle, 0.9999);
        }

        private FluidView OneParticle(Vector3 place)
        {
            FluidSimulation simulation = rig.Create(liquid: false, position: place);
            rig.AddVolume(simulation).Size = SimulationRig.Spacing * Vector3.one;
            return simulation.gameObject.AddComponent<FluidParticleRenderer>();
        }

        private IEnumerator LooksTheSameFarAway(float distance, Func<Vector3, FluidView> create, double likeness)
        {
            var pictures = new List<Picture>();
            foreach (Vector3 place in new[] { Vector3.zero, new Vector3(distance, 0f, distance) })
            {
                FluidView drawing = create(place);
                view.Camera.transform.position = place - 2f * Vector3.forward;
                while (drawing.Simulation.SimulatedTime < 0.055) yield return null;
                pictures.Add(new Picture(Width, Height, view.Pixels()));
                drawing.gameObject.SetActive(false);
            }
            Assert.That(StructuralSimilarity.Of(pictures[0], pictures[1]), Is.GreaterThan(likeness));
        }

        // The second camera is smaller, so that it fills only a part of the thickness picture, and it sees the same.
        [UnityTest]
        public IEnumerator CamerasOfDifferentSizeSeeTheSameWater()
        {
            FluidSurfaceRenderer drawing = Create("Fluid", Vector3.zero, new Color(0.02f, 0.5f, 1f));
            using (var small = new PictureRig(Width / 2, Height / 2, 0.25f))
            {
                small.Light.enabled = false;
                small.Camera.backgroundColor = view.Camera.backgroundColor;
                small.Camera.depth = 1f;
                yield return PictureRig.Frames(3);
                Vector3 point = drawing.transform.position;
                Color large = view.PixelAt(view.Pixels(), point);
                Color seen = small.PixelAt(small.Pixels(), point);
                Assert.AreEqual(large.r, seen.r, 0.02f);
                Assert.AreEqual(large.b, seen.b, 0.02f);
                Assert.Less(seen.r, 0.75f * 0.6f);
            }
        }

        // Of the Built-in pipeline, where the picture is copied by a command buffer of the camera.
        [UnityTest]
        public IEnumerator NothingIsLeftOnCamerasAfterwards()
        {
            using PipelineSwitch builtIn = PipelineSwitch.ToBuiltIn();
            FluidSurfaceRenderer drawing = Create("Fluid", Vector3.zero, Color.white);
            yield return PictureRig.Frames(2);
            Assert.IsTrue(WaterCameras.IsListening);
            Assert.AreEqual(1, view.Camera.GetCommandBuffers(CameraEvent.BeforeForwardAlpha).Length);
            Assert.AreEqual(1, Thicknesses());

            drawing.enabled = false;
            yield return null;
            AssertNothingLeft();
            drawing.enabled = true;
            yield return PictureRig.Frames(2);
            Assert.AreEqual(1, view.Camera.GetCommandBuffers(CameraEvent.BeforeForwardAlpha).Length);
            Object.DestroyImmediate(drawing.gameObject);
            yield return null;
            AssertNothingLeft();
        }

        [UnityTest]
        public IEnumerator OpaqueLookNeedsNothingOfCameras()
        {
            FluidSurfaceRenderer drawing = Create("Fluid", Vector3.zero, Color.white);
            yield return PictureRig.Frames(2);
            drawing.Look = FluidSurfaceLook.Opaque;
            drawing.Color = Color.red;
            yield return PictureRig.Frames(2);
            AssertNothingLeft();
            Color seen = view.PixelAt(view.Pixels(), drawing.transform.position);
            Assert.Greater(seen.r, 3f * seen.g, "a red body");
        }

        // A camera's own wish for a depth texture is not the water's to take away.
        [UnityTest]
        public IEnumerator CameraKeepsWhatItHadBefore()
        {
            view.Camera.depthTextureMode = DepthTextureMode.Depth;
            view.Camera.forceIntoRenderTexture = true;
            FluidSurfaceRenderer drawing = Create("Fluid", Vector3.zero, Color.white);
            yield return PictureRig.Frames(2);
            drawing.enabled = false;
            Assert.AreEqual(DepthTextureMode.Depth, view.Camera.depthTextureMode);
            Assert.IsTrue(view.Camera.forceIntoRenderTexture);
        }

        [UnityTest]
        public IEnumerator ShadowIsAsDarkAsItsStrength()
        {
            view.Light.shadows = LightShadows.Soft;
            view.Light.transform.rotation = Quaternion.LookRotation(Vector3.forward);
            GameObject wall = GameObject.CreatePrimitive(PrimitiveType.Cube);
            try
            {
                wall.layer = 0;
                wall.transform.position = new Vector3(0f, 0f, 0.8f);
                wall.transform.localScale = new Vector3(4f, 4f, 0.1f);
                FluidSurfaceRenderer drawing = Create("Fluid", Vector3.zero, Color.white);
                drawing.Water.Visibility = 1e6f;
                drawing.Water.Smoothness = 0f;
                drawing.Water.Shadow = 0f;
                yield return PictureRig.Frames(2);
                float lit = view.PixelAt(view.Pixels(), drawing.transform.position).linear.g;
                drawing.Water.Shadow = 0.5f;
                yield return PictureRig.Frames(2);
                float half = view.PixelAt(view.Pixels(), drawing.transform.position).linear.g;
                drawing.Water.Shadow = 1f;
                yield return PictureRig.Frames(2);
                float dark = view.PixelAt(view.Pixels(), drawing.transform.position).linear.g;
                Assert.Less(dark, 0.8f * lit);
                Assert.Greater(half, dark + 0.15f * (lit - dark));
                Assert.Less(half, dark + 0.85f * (lit - dark));
            }
            finally
            {
                Object.DestroyImmediate(wall);
            }
        }

        // As long as the Built-in pipeline draws a liquid that receives shadows, two command buffers are on the light, whoever else is
        // there.
        [UnityTest]
        public IEnumerator NothingIsLeftOnTheLightAfterwards()
        {
            using PipelineSwitch builtIn = PipelineSwitch.ToBuiltIn();
            view.Light.shadows = LightShadows.Soft;
            FluidSurfaceRenderer drawing = Create("Fluid", Vector3.zero, Color.white);
            var squares = rig.Create("Squares", position: Vector3.right).gameObject.AddComponent<FluidParticleRenderer>();
            yield return PictureRig.Frames(2);
            Assert.AreEqual(2, view.Light.commandBufferCount);
            drawing.enabled = false;
            Assert.AreEqual(2, view.Light.commandBufferCount, "the other one is there");
            squares.ReceiveShadows = false;
            yield return PictureRig.Frames(2);
            Assert.AreEqual(0, view.Light.commandBufferCount, "nobody receives");
            drawing.enabled = true;
            yield return PictureRig.Frames(2);
            Assert.AreEqual(2, view.Light.commandBufferCount);
            drawing.Simulation.StopSimulation();
            yield return PictureRig.Frames(2);
            Assert.AreEqual(0, view.Light.commandBufferCount, "nothing is drawn");
            squares.ReceiveShadows = true;
            yield return PictureRig.Frames(2);
            Assert.AreEqual(2, view.Light.commandBufferCount);
            Object.DestroyImmediate(squares.gameObject);
            Assert.AreEqual(0, view.Light.commandBufferCount);
            Assert.IsFalse(MainLightShadows.IsListening);
            yield return null;
            Assert.AreEqual(0, Resources.FindObjectsOfTypeAll<RenderTexture>().Count(t => t.name == "Fluid Shadow Constants"));
        }

        private FluidSurfaceRenderer Create(string name, Vector3 position, Color colourAtOneMetre)
        {
            var drawing = rig.Create(name, position: position).gameObject.AddComponent<FluidSurfaceRenderer>();
            drawing.Water.ColorAtOneMetre = colourAtOneMetre;
            return drawing;
        }

        private void AssertNothingLeft()
        {
            Assert.IsFalse(WaterCameras.IsListening);
            Assert.AreEqual(0, view.Camera.commandBufferCount);
            Assert.AreEqual(DepthTextureMode.None, view.Camera.depthTextureMode);
            Assert.IsFalse(view.Camera.forceIntoRenderTexture);
            Assert.AreEqual(0, Thicknesses());
        }

        private static int Thicknesses() => Resources.FindObjectsOfTypeAll<RenderTexture>().Count(t => t.name == "Water Thickness");
    }
}
