using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Coefficients of the water look from its two settings in metres.</summary>
    public sealed class FluidWaterLookTests
    {
        [Test]
        public void AMetreLeavesTheColourThatIsSet()
        {
            var look = new FluidWaterLook { ColorAtOneMetre = new Color(0.3f, 0.6f, 0.8f), Visibility = float.PositiveInfinity };
            Color expected = QualitySettings.activeColorSpace == ColorSpace.Linear ? look.ColorAtOneMetre.linear : look.ColorAtOneMetre;
            for (int c = 0; c < 3; c++) Assert.AreEqual(expected[c], Mathf.Exp(-look.Extinction[c]), 1e-5f);
            Assert.AreEqual(Vector4.zero, look.Albedo);
        }

        [Test]
        public void ThatColourMayBeForAnotherDistance()
        {
            var look = new FluidWaterLook { ColorAtOneMetre = new Color(0.3f, 0.6f, 0.8f), Visibility = float.PositiveInfinity };
            Vector4 perMetre = look.Extinction;
            look.AbsorptionDistance = 0.1f;
            for (int c = 0; c < 3; c++) Assert.AreEqual(10f * perMetre[c], look.Extinction[c], 1e-3f);
            look.AbsorptionDistance = 0f;
            Assert.IsFalse(float.IsInfinity(look.Extinction.x));
        }

        [TestCase(0.02f, 0.933f)]
        [TestCase(0.3f, 0f)]
        [TestCase(8f, 0f)]
        public void OnlyLiquidOfAShortSightIsLitAsAMattBody(float visibility, float matt) =>
            Assert.AreEqual(matt, new FluidWaterLook { Visibility = visibility }.Matt, 1e-3f);

        [Test]
        public void WaterShinesNotAndMirrorsTwoPercent()
        {
            var look = new FluidWaterLook();
            Assert.AreEqual(new Vector4(0f, 0f, 0f, 0.02f), look.Surface);
            look.Emission = new Color(3f, 0f, 0f);
            look.Reflectance = 2f;
            Assert.Greater(look.Surface.x, 1f);
            Assert.AreEqual(1f, look.Surface.w);
        }

        [Test]
        public void AtTheVisibilityTwoPercentAreLeft()
        {
            var look = new FluidWaterLook { ColorAtOneMetre = Color.white, Visibility = 5f };
            Assert.AreEqual(0.02f, Mathf.Exp(-5f * look.Extinction.y), 1e-4f);
            Assert.AreEqual(new Vector4(1f, 1f, 1f, 0f), look.Albedo);
        }

        [Test]
        public void ScatteringAndAbsorptionAddUp()
        {
            var look = new FluidWaterLook { ColorAtOneMetre = Color.black, Visibility = 1f, Scattering = new Color(1f, 0f, 0f) };
            Assert.AreEqual(6.908f + 3.912f, look.Extinction.x, 1e-3f, "of a black colour a thousandth is left");
            Assert.AreEqual(6.908f, look.Extinction.y, 1e-3f);
            Assert.AreEqual(3.912f / 10.82f, look.Albedo.x, 1e-3f);
            Assert.AreEqual(0f, look.Albedo.y);
        }

        [Test]
        public void ClearestWaterHasNoInfiniteNumbers()
        {
            var look = new FluidWaterLook { ColorAtOneMetre = Color.white, Visibility = float.PositiveInfinity };
            Assert.AreEqual(Vector4.zero, look.Extinction);
            Assert.AreEqual(Vector4.zero, look.Albedo);
            look.Visibility = 0f;
            Assert.IsFalse(float.IsInfinity(look.Extinction.x) || float.IsNaN(look.Albedo.x));
        }
    }
}
