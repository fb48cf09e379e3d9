using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Whose cameras a surface is made for.</summary>
    public sealed class LiquidViewsTests
    {
        private static readonly Quaternion Away = Quaternion.Euler(0f, 180f, 0f);

        private SimulationRig rig;
        private PictureRig picture;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            picture = new PictureRig(64, 64, 0.3f);
        }

        [TearDown]
        public void TearDown()
        {
            picture.Dispose();
            rig.Dispose();
        }

        [UnityTest]
        public IEnumerator WhatNobodySeesIsNotMade()
        {
            FluidSurfaceRenderer drawing = Show(FluidSurfaceLook.Opaque);
            yield return PictureRig.Frames(3);
            Assert.Greater(Lit(), 100);
            int made = drawing.Recordings;
            Assert.Greater(made, 0);
            picture.Camera.transform.rotation = Away;
            yield return PictureRig.Frames(3);
            Assert.AreEqual(made, drawing.Recordings);
            Assert.AreEqual(0, Lit());
        }

        [UnityTest]
        public IEnumerator ACameraThatTurnsBackSeesTheLiquidAsItIsThen([Values] FluidSurfaceLook look)
        {
            FluidSurfaceRenderer drawing = Show(look);
            picture.Camera.transform.rotation = Away;
            yield return PictureRig.Frames(20);
            Assert.AreEqual(0, drawing.Recordings);
            picture.Camera.transform.rotation = Quaternion.identity;
            yield return PictureRig.Frames(1);
            Assert.Greater(drawing.Recordings, 0);
            Assert.Greater(Lit(), 100);
        }

        // Turned in LateUpdate, after the liquid was drawn.
        [UnityTest]
        public IEnumerator ACameraThatTurnsLateSeesTheLiquidInThatFrame([Values] FluidSurfaceLook look)
        {
            FluidSurfaceRenderer drawing = Show(look);
            picture.Camera.transform.rotation = Away;
            yield return PictureRig.Frames(5);
            Assert.AreEqual(0, drawing.Recordings);
            picture.Camera.gameObject.AddComponent<LateTurn>();
            yield return PictureRig.Frames(1);
            Assert.AreEqual(1, drawing.Recordings);
            Assert.Greater(Lit(), 100);
        }

        [UnityTest]
        public IEnumerator ASecondCameraIsEnough()
        {
            FluidSurfaceRenderer drawing = Show(FluidSurfaceLook.Opaque);
            picture.Camera.transform.rotation = Away;
            GameObject second = rig.NewObject("Second");
            second.transform.position = new Vector3(0f, 0f, -2f);
            Camera other = second.AddComponent<Camera>();
            other.targetTexture = picture.Camera.targetTexture;
            yield return PictureRig.Frames(2);
            int made = drawing.Recordings;
            Assert.Greater(made, 0);
            other.cullingMask = ~(1 << SimulationRig.Layer);
            yield return PictureRig.Frames(2);
            Assert.AreEqual(made, drawing.Recordings, "made for a camera without the liquid's layer");
        }

        [UnityTest]
        public IEnumerator AShadowThatFallsIntoTheViewIsSeen()
        {
            FluidSurfaceRenderer drawing = Show(FluidSurfaceLook.Opaque);
            picture.Camera.transform.position = new Vector3(0f, -2f, -2f);
            yield return PictureRig.Frames(2);
            Assert.AreEqual(0, drawing.Recordings);
            picture.Light.shadows = LightShadows.Hard;
            yield return PictureRig.Frames(2);
            Assert.Greater(drawing.Recordings, 0);
        }

        [UnityTest]
        public IEnumerator AProbeThatIsDrawnWhilePlayingSeesTheLiquid()
        {
            FluidSurfaceRenderer drawing = Show(FluidSurfaceLook.Opaque);
            picture.Camera.transform.rotation = Away;
            yield return PictureRig.Frames(2);
            Assert.AreEqual(0, drawing.Recordings);
            ReflectionProbe probe = rig.NewObject("Probe").AddComponent<ReflectionProbe>();
            (probe.mode, probe.cullingMask) = (ReflectionProbeMode.Realtime, 0);
            yield return PictureRig.Frames(2);
            Assert.AreEqual(0, drawing.Recordings, "a probe that shows the sky alone");
            probe.cullingMask = -1;
            yield return PictureRig.Frames(2);
            Assert.Greater(drawing.Recordings, 0);
        }

        [UnityTest]
        public IEnumerator ALiquidAtAStandstillIsDrawnFromTheSurfaceThatItHas()
        {
            FluidSurfaceRenderer drawing = Show(FluidSurfaceLook.Opaque);
            yield return PictureRig.Frames(3);
            Time.captureDeltaTime = 0f;
            Time.timeScale = 0f;
            try
            {
                yield return PictureRig.Frames(10);
                int made = drawing.Recordings;
                int lit = Lit();
                yield return PictureRig.Frames(5);
                Assert.AreEqual(made, drawing.Recordings);
                Assert.AreEqual(lit, Lit());
                Assert.Greater(lit, 100);
            }
            finally
            {
                Time.timeScale = 1f;
            }
        }

        private FluidSurfaceRenderer Show(FluidSurfaceLook look)
        {
            FluidSimulation simulation = rig.Create();
            var drawing = simulation.gameObject.AddComponent<FluidSurfaceRenderer>();
            drawing.Look = look;
            return drawing;
        }

        private int Lit()
        {
            int lit = 0;
            foreach (Color pixel in picture.Pixels()) lit += pixel.maxColorComponent > 0.02f ? 1 : 0;
            return lit;
        }

        [DefaultExecutionOrder(1000)]
        private sealed class LateTurn : MonoBehaviour
        {
            private void LateUpdate() => transform.rotation = Quaternion.identity;
        }
    }
}
