using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>
    /// Where drops of spray are drawn: after the water, or into the picture that the water refracts; never in both of a pixel.
    /// </summary>
    public sealed class SprayDrawingTests
    {
        private const float Spacing = 0.1f;

        private WaterRig rig;

        [SetUp]
        public void SetUp()
        {
            rig = new WaterRig();
            rig.SetDepth((x, y) => 4f);
        }

        [TearDown]
        public void TearDown() => rig.Dispose();

        // Water from z = -0.2 m to 0.2 m, and a camera 2 m before the origin.
        [TestCase(-0.6f, true, false, TestName = "{m}(before the water)")]
        [TestCase(0.6f, true, true, TestName = "{m}(behind it, where the surface's depth hides what was drawn after the water)")]
        public void FromOutside(float z, bool after, bool refracted)
        {
            rig.Box(0.4f);
            Shows(z, after, refracted);
        }

        // The water reaches from behind the camera to z = 0.
        [TestCase(-0.6f, true, false, TestName = "{m}(in the water)")]
        [TestCase(0.6f, false, true, TestName = "{m}(in the air, seen through the water's window only)")]
        public void FromWithin(float z, bool after, bool refracted)
        {
            rig.Domain = new Bounds(Vector3.zero, Vector3.one * 8f);
            rig.Surface = new UploadedSurface().Quad(Vector3.zero, Vector3.right * 3.9f, Vector3.up * 3.9f, Vector3.forward);
            Shows(z, after, refracted);
        }

        [Test]
        public void WhatTheSceneHidesIsNotRefracted()
        {
            rig.Box(0.4f);
            rig.SetDepth((x, y) => WaterRig.Distance + 0.3f);
            Assert.IsFalse(IsShown(rig.RenderSpray(new Vector3(0f, 0f, 0.6f), Spacing, behind: true)));
        }

        private void Shows(float z, bool after, bool refracted)
        {
            Assert.AreEqual(after, IsShown(rig.RenderSpray(new Vector3(0f, 0f, z), Spacing, behind: false)), "after the water");
            Assert.AreEqual(refracted, IsShown(rig.RenderSpray(new Vector3(0f, 0f, z), Spacing, behind: true)),
                "into the picture that the water refracts");
        }

        private static bool IsShown(Color[] picture) => picture.Any(pixel => pixel.a > 0.01f);
    }
}
