using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What counts as seen by a camera.</summary>
    public sealed class ViewVolumeTests
    {
        private GameObject holder;
        private Camera camera;

        [SetUp]
        public void SetUp()
        {
            holder = new GameObject("Camera");
            camera = holder.AddComponent<Camera>();
            camera.nearClipPlane = 0.5f;
            camera.farClipPlane = 20f;
            camera.fieldOfView = 60f;
            camera.aspect = 1f;
        }

        [TearDown]
        public void TearDown() => Object.DestroyImmediate(holder);

        [TestCase(0f, 0f, 5f, true)]
        [TestCase(0f, 0f, -5f, false)]
        [TestCase(0f, 0f, 21f, true)]
        [TestCase(0f, 0f, 21.6f, false)]
        [TestCase(10f, 0f, 5f, false)]
        [TestCase(-10f, 0f, 5f, false)]
        [TestCase(0f, 10f, 5f, false)]
        [TestCase(0f, -10f, 5f, false)]
        [TestCase(3.5f, 0f, 5f, true)]
        [TestCase(0f, 0f, -0.6f, false)]
        [TestCase(0f, 0f, -0.4f, true)]
        public void ABoxIsSeenWhereItReachesTheView(float x, float y, float z, bool seen) =>
            Assert.AreEqual(seen, new ViewVolume(camera).Touches(new Bounds(new Vector3(x, y, z), 2f * Vector3.one)));

        // The box stands above the view.
        [TestCase(0f, -1f, 0f, true)]
        [TestCase(0f, 1f, 0f, false)]
        [TestCase(1f, 0f, 0f, false)]
        [TestCase(1f, -1f, 0f, true)]
        public void WhatMovesTowardsTheViewIsSeen(float x, float y, float z, bool seen) =>
            Assert.AreEqual(seen, new ViewVolume(camera).Touches(new Bounds(new Vector3(0f, 10f, 5f), Vector3.one), new Vector3(x, y, z)));

        [Test]
        public void ATurnedCameraSeesWhatLiesBehind()
        {
            var box = new Bounds(new Vector3(0f, 0f, -5f), Vector3.one);
            Assert.IsFalse(new ViewVolume(camera).Touches(box));
            holder.transform.rotation = Quaternion.Euler(0f, 180f, 0f);
            Assert.IsTrue(new ViewVolume(camera).Touches(box));
        }

        [Test]
        public void LayerAndShadowsDecideToo()
        {
            GameObject lamp = new GameObject("Light");
            try
            {
                var light = lamp.AddComponent<Light>();
                light.type = LightType.Directional;
                light.shadows = LightShadows.Hard;
                light.transform.rotation = Quaternion.LookRotation(Vector3.down);
                Matrix4x4 above = Matrix4x4.Translate(new Vector3(0f, 10f, 5f));
                Assert.IsTrue(LiquidViews.IsSeenBy(camera, new DrawPlacement(above, Vector3.one, 0f, 3, true)));
                Assert.IsFalse(LiquidViews.IsSeenBy(camera, new DrawPlacement(above, Vector3.one, 0f, 3, false)));
                light.shadows = LightShadows.None;
                Assert.IsFalse(LiquidViews.IsSeenBy(camera, new DrawPlacement(above, Vector3.one, 0f, 3, true)));
                light.type = LightType.Point;
                light.shadows = LightShadows.Hard;
                light.range = 11f;
                Assert.IsTrue(LiquidViews.IsSeenBy(camera, new DrawPlacement(above, Vector3.one, 0f, 3, true)));
                light.range = 8f;
                Assert.IsFalse(LiquidViews.IsSeenBy(camera, new DrawPlacement(above, Vector3.one, 0f, 3, true)));

                Matrix4x4 ahead = Matrix4x4.Translate(new Vector3(0f, 0f, 5f));
                Assert.IsTrue(LiquidViews.IsSeenBy(camera, new DrawPlacement(ahead, Vector3.one, 0f, 3, false)));
                camera.cullingMask = ~(1 << 3);
                Assert.IsFalse(LiquidViews.IsSeenBy(camera, new DrawPlacement(ahead, Vector3.one, 0f, 3, true)));
            }
            finally
            {
                Object.DestroyImmediate(lamp);
            }
        }
    }
}
