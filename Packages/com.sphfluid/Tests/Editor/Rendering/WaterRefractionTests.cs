using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Which place of the scene is seen through water, against the law of refraction.</summary>
    public sealed class WaterRefractionTests
    {
        private const int Size = WaterRig.Size;
        private const float Passing = 0.98f; // at normal incidence 2 % is mirrored
        private const float Tilt = 0.5f;     // of the front's normal, in radians, to the right

        // In water light makes asin(0.75 sin 0.5) with that normal: it is turned to the left by the difference.
        private static readonly float Turned = Tilt - Mathf.Asin(0.75f * Mathf.Sin(Tilt));

        private static readonly Vector3 Tilted = new Vector3(Mathf.Sin(Tilt), 0f, -Mathf.Cos(Tilt));

        private WaterRig rig;

        [SetUp]
        public void SetUp()
        {
            rig = new WaterRig();
            rig.ShowPlaces();
        }

        [TearDown]
        public void TearDown() => rig.Dispose();

        [Test]
        public void FlatWaterShiftsNothing([Values] FluidWaterQuality quality)
        {
            rig.Look.Quality = quality;
            rig.Box(0.4f);
            Color seen = WaterRig.Centre(rig.Render());
            Assert.AreEqual(PlaceAt(Size / 2), seen.r / Passing, 2e-3f);
            Assert.AreEqual(PlaceAt(Size / 2), seen.g / Passing, 2e-3f);
        }

        // URP's opaque texture at a quarter of the size: left of the middle a thing in the water, right of it what is behind. The second
        // pixel from the edge has an eighth of the other side's colour by distance, and none by depth.
        [TestCase(1, 1f)]
        [TestCase(-2, 0f)]
        public void ACoarsePictureOfTheSceneIsReadByDepth(int fromMiddle, float green)
        {
            rig.Box(0.4f);
            rig.SetDepth((x, y) => WaterRig.Distance + (x < Size / 2 ? 0.1f : 1f));
            var coarse = new Texture2D(Size / 4, Size / 4, TextureFormat.RGBAFloat, false, true) { wrapMode = TextureWrapMode.Clamp };
            for (int i = 0; i < coarse.width * coarse.height; i++)
            {
                coarse.SetPixel(i % coarse.width, i / coarse.width, i % coarse.width < Size / 8 ? Color.red : Color.green);
            }
            coarse.Apply();
            Color[] seen = rig.Render(block =>
            {
                block.SetVector("_FluidScene", new SceneTextures(SceneColourSource.OpaqueTexture, true).ToVector());
                block.SetTexture("_CameraOpaqueTexture", coarse);
            });
            Object.DestroyImmediate(coarse);
            Color pixel = seen[Size / 2 * Size + Size / 2 + fromMiddle];
            Assert.AreEqual(green, pixel.g / Passing, 0.01f);
            Assert.AreEqual(1f - green, pixel.r / Passing, 0.01f);
        }

        [Test]
        public void SlopingWaterShiftsByTheLawOfRefraction([Values] FluidWaterQuality quality)
        {
            rig.Look.Quality = quality;
            rig.Slope(Tilted);
            Color seen = WaterRig.Centre(rig.Render());
            float length = quality == FluidWaterQuality.Fast ? 0.4f : 0.4f / Mathf.Cos(Turned);
            AssertShifted(length, seen);
            Assert.AreEqual(PlaceAt(Size / 2), seen.g / Passing, 0.01f);
        }

        // What lies 0.25 m behind the front is reached after that way, in the middle of two steps as well as at one.
        [TestCase(0.2f)]
        [TestCase(0.25f)]
        [TestCase(0.331f)]
        public void ThingsInTheWaterAreSeenWhereTheLineMeetsThem(float metres)
        {
            rig.Slope(Tilted);
            rig.SetDepth((x, y) => WaterRig.Distance - 0.2f + metres);
            AssertShifted(metres / Mathf.Cos(Turned), WaterRig.Centre(rig.Render()));
        }

        // A second layer, 1 m behind the first, is not part of the way on which light is bent.
        [Test]
        public void OnlyTheNearestLayerBends()
        {
            rig.Surface = new UploadedSurface()
                .Quad(new Vector3(0f, 0f, -0.2f), Vector3.up * 2f, Vector3.right * 2f, Tilted)
                .Quad(new Vector3(0f, 0f, 0.2f), Vector3.right * 2f, Vector3.up * 2f, Vector3.forward)
                .Box(new Vector3(0f, 0f, 1.4f), new Vector3(4f, 4f, 0.4f));
            AssertShifted(0.4f / Mathf.Cos(Turned), WaterRig.Centre(rig.Render()));
        }

        [Test]
        public void AllLayersAbsorb()
        {
            rig.Look.ColorAtOneMetre = new Color(0.3f, 0.6f, 0.8f);
            rig.ReplaceScene((x, y) => Color.white);
            rig.Surface = new UploadedSurface().Box(Vector3.zero, new Vector3(4f, 4f, 0.4f))
                .Box(new Vector3(0f, 0f, 1.4f), new Vector3(4f, 4f, 0.3f));
            Color seen = WaterRig.Centre(rig.Render());
            for (int c = 0; c < 3; c++)
            {
                Assert.AreEqual(Mathf.Exp(-0.7f * rig.Look.Extinction[c]), seen[c] / Passing, 3e-3f, $"channel {c}");
            }
        }

        // A thing in front of the water must not be smeared into it.
        [Test]
        public void ThingsInFrontOfTheWaterAreNotRefracted([Values] FluidWaterQuality quality)
        {
            rig.Look.Quality = quality;
            rig.ReplaceScene((x, y) => x < Size / 2 ? Color.red : Color.green);
            rig.SetDepth((x, y) => x < Size / 2 ? 0.5f : WaterRig.Far);
            rig.Slope(new Vector3(0.4f, 0f, -0.9f));
            Color pixel = rig.Render()[Size / 2 * Size + Size / 2 + 1];
            Assert.Less(pixel.r, 0.02f);
            Assert.Greater(pixel.g, 0.8f);
        }

        // Light meets the wall at x = -0.25 m at a grazing angle and goes back to the right.
        [TestCase(FluidWaterQuality.Fine, true)]
        [TestCase(FluidWaterQuality.Balanced, false)]
        public void APaneMirrorsWhatGrazesIt(FluidWaterQuality quality, bool mirrors)
        {
            rig.Look.Quality = quality;
            rig.Domain = new Bounds(Vector3.zero, Vector3.one * 0.5f);
            rig.Surface = new UploadedSurface()
                .Quad(new Vector3(0f, 0f, -0.2f), Vector3.up * 0.25f, Vector3.right * 0.25f, Tilted)
                .Quad(new Vector3(0f, 0f, 0.25f), Vector3.right * 0.25f, Vector3.up * 0.25f, Vector3.forward);
            const int column = 18;
            float start = (PlaceAt(column) - 0.5f) * 2f * WaterRig.HalfWidth;
            float beforeWall = (start + 0.25f) / Mathf.Tan(Turned);
            float place = mirrors ? -0.25f + (0.45f - beforeWall) * Mathf.Tan(Turned) : -0.25f;
            Color seen = rig.Render()[Size / 2 * Size + column];
            Assert.AreEqual(0.5f + place / (2f * WaterRig.HalfWidth), seen.r / Passing, 0.01f);
        }

        // What stands at the wall is the wall: it is seen, and nothing is mirrored.
        [Test]
        public void AnOpaqueWallMirrorsNothing()
        {
            rig.Domain = new Bounds(Vector3.zero, Vector3.one * 0.5f);
            rig.Surface = new UploadedSurface()
                .Quad(new Vector3(0f, 0f, -0.2f), Vector3.up * 0.25f, Vector3.right * 0.25f, Tilted)
                .Quad(new Vector3(0f, 0f, 0.25f), Vector3.right * 0.25f, Vector3.up * 0.25f, Vector3.forward);
            const int column = 18;
            float beforeWall = ((PlaceAt(column) - 0.5f) * 2f * WaterRig.HalfWidth + 0.25f) / Mathf.Tan(Turned);
            rig.SetDepth((x, y) => WaterRig.Distance - 0.2f + beforeWall + 0.01f);
            Color seen = rig.Render()[Size / 2 * Size + column];
            Assert.AreEqual(0.5f - 0.25f / (2f * WaterRig.HalfWidth), seen.r / Passing, 0.012f);
        }

        // A film of 5 mm on a pane of a tank full of air, whose bumps let light graze the pane: what the pane mirrors has gone through the
        // film twice, not through the tank.
        [Test]
        public void AFilmOnAPaneIsClear([Values] FluidWaterQuality quality, [Values(0.2f, 0.35f, 0.5f, 0.8f)] float bump)
        {
            rig.Look.Quality = quality;
            rig.Look.Visibility = 8f;
            rig.Look.ColorAtOneMetre = new Color(0.3f, 0.6f, 0.8f);
            rig.ReplaceScene((x, y) => Color.white);
            rig.Domain = new Bounds(Vector3.zero, Vector3.one);
            rig.Eye = new Vector3(-1f, 0f, -2f);
            rig.Surface = new UploadedSurface()
                .Quad(new Vector3(0.495f, 0f, 0f), Vector3.up * 0.5f, Vector3.back * 0.5f,
                    new Vector3(-Mathf.Cos(bump), 0f, -Mathf.Sin(bump)))
                .Quad(new Vector3(0.5f, 0f, 0f), Vector3.back * 0.5f, Vector3.up * 0.5f, Vector3.right);
            Color[] clear = rig.Render(block => block.SetVector("_FluidExtinction", Vector4.zero));
            Color[] film = rig.Render();
            int seen = 0;
            for (int i = 0; i < film.Length; i++)
            {
                if (clear[i].a < 0.5f || clear[i].r < 0.1f) continue;
                seen++;
                Assert.Greater(film[i].r, 0.9f * clear[i].r, $"pixel {i % Size}, {i / Size}");
            }
            Assert.Greater(seen, 200, "pixels of the film");
        }

        private static void AssertShifted(float metres, Color seen) =>
            Assert.AreEqual(PlaceAt(Size / 2) - metres * Mathf.Sin(Turned) / (2f * WaterRig.HalfWidth), seen.r / Passing, 0.006f,
                "to the left");

        private static float PlaceAt(int pixel) => (pixel + 0.5f) / Size;
    }
}
