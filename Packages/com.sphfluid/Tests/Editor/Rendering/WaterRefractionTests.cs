using System;
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
            UnityEngine.Object.DestroyImmediate(coarse);
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

        // Films on a pane of a tank full of air, whose bumps let light graze the pane: what goes through the tank's air is no water.
        [Test]
        public void AFilmOnAPaneIsAsClearAtFineAsAtBalanced([Values(0.005f, 0.02f, 0.035f, 0.05f)] float thickness,
            [Values(0.2f, 0.35f, 0.5f, 0.8f)] float bump)
        {
            rig.Look.Visibility = 8f;
            rig.Look.ColorAtOneMetre = new Color(0.1f, 0.52f, 0.83f);
            rig.ReplaceScene((x, y) => Color.white);
            rig.Domain = new Bounds(Vector3.zero, Vector3.one);
            rig.Eye = new Vector3(-1f, 0f, -2f);
            rig.Surface = new UploadedSurface()
                .Quad(new Vector3(0.5f - thickness, 0f, 0f), Vector3.up * 0.5f, Vector3.back * 0.5f,
                    new Vector3(-Mathf.Cos(bump), 0f, -Mathf.Sin(bump)))
                .Quad(new Vector3(0.5f, 0f, 0f), Vector3.back * 0.5f, Vector3.up * 0.5f, Vector3.right);
            rig.Look.Quality = FluidWaterQuality.Balanced;
            Color[] balanced = rig.Render();
            rig.Look.Quality = FluidWaterQuality.Fine;
            Color[] fine = rig.Render();
            int seen = 0;
            for (int i = 0; i < fine.Length; i++)
            {
                if (balanced[i].a < 0.5f || balanced[i].grayscale < 0.1f) continue;
                seen++;
                Assert.Greater(fine[i].grayscale, 0.95f * balanced[i].grayscale, $"pixel {i % Size}, {i / Size}");
            }
            Assert.Greater(seen, 200, "pixels of the film");
        }

        // A pool 0.15 m deep, seen from 14 degrees above. Its floor, or a floor 0.25 m below its bottom, is red on one side of a line.
        [Test]
        public void AtAGrazingViewAStraightEdgeHasNoSteps(
            [Values(FluidWaterQuality.Balanced, FluidWaterQuality.Fine)] FluidWaterQuality quality, [Values(-0.15f, -0.4f)] float floor,
            [Values] bool perspective)
        {
            const float deep = 0.15f;
            rig.Look.Quality = quality;
            rig.Perspective = perspective;
            rig.Eye = new Vector3(0f, 0.5f, -2f);
            rig.Domain = new Bounds(new Vector3(0f, 0f, 0.3f), new Vector3(5f, 2f, 5f));
            rig.Surface = new UploadedSurface().Box(new Vector3(0f, -0.5f * deep, 0.3f), new Vector3(4.9f, deep, 4.9f));
            rig.SetDepth((x, y) => Depth(Floor(x, y)));
            rig.ReplaceScene((x, y) => Color.Lerp(Color.green, Color.red, RedShare(x, y)));
            Color[] seen = rig.Render();
            int rows = 0;
            for (int y = 0; y < Size; y++)
            {
                float expected = Crossing(x => Beyond(Refracted(x, y)));
                float place = Crossing(x => seen[y * Size + x].g / (seen[y * Size + x].r + seen[y * Size + x].g) - 0.5f);
                if (float.IsNaN(expected) || !IsSeen(Refracted(expected, y)) || expected < 2f || expected > Size - 3f) continue;
                rows++;
                Assert.AreEqual(expected, place, 1f, $"row {y}");
            }
            Assert.Greater(rows, Size / 3, "rows in which the edge is seen");

            Vector3 Floor(float x, float y) => Down(Start(x, y), Sight(x, y), floor);

            // How far a point of the floor lies on the green side.
            float Beyond(Vector3 point) => point.x - 0.25f * point.z - (perspective ? -0.05f : 0f);

            float RedShare(int x, int y)
            {
                int red = 0;
                for (int i = 0; i < 64; i++) red += Beyond(Floor(x + (i % 8 - 3.5f) / 8f, y + (i / 8 - 3.5f) / 8f)) < 0f ? 1 : 0;
                return red / 64f;
            }

            Vector3 Refracted(float x, float y)
            {
                Vector3 sight = Sight(x, y), level = new Vector3(sight.x, 0f, sight.z) * 0.75f;
                Vector3 bent = level + Vector3.down * Mathf.Sqrt(1f - level.sqrMagnitude);
                Vector3 bottom = Down(Down(Start(x, y), sight, 0f), bent, -deep);
                return Down(bottom, sight, floor);
            }

            bool IsSeen(Vector3 point)
            {
                Vector3 local = SurfaceTestScene.LookAtOrigin(rig.Eye).MultiplyPoint(point);
                return Mathf.Abs(local.y) < 0.95f * (perspective ? WaterRig.HalfAngle * -local.z : WaterRig.HalfWidth);
            }

            float Depth(Vector3 point) => -SurfaceTestScene.LookAtOrigin(rig.Eye).MultiplyPoint(point).z;
        }

        private static Vector3 Down(Vector3 from, Vector3 direction, float height) =>
            from + direction * ((height - from.y) / direction.y);

        // The first column in which a function turns from negative to positive, between pixels.
        private static float Crossing(Func<int, float> at)
        {
            for (int x = 1; x < Size; x++)
            {
                float before = at(x - 1), after = at(x);
                if (before < 0f && after >= 0f) return x - after / (after - before);
            }
            return float.NaN;
        }

        private Vector3 Start(float x, float y) => rig.Perspective ? rig.Eye : rig.Eye + Aside(x, y) * WaterRig.HalfWidth;

        private Vector3 Sight(float x, float y) =>
            rig.Perspective ? (-rig.Eye.normalized + Aside(x, y) * WaterRig.HalfAngle).normalized : -rig.Eye.normalized;

        // From the middle of the picture, in halves of its width.
        private Vector3 Aside(float x, float y) =>
            Quaternion.LookRotation(-rig.Eye, Vector3.up) * new Vector3(2f * PlaceAt(x) - 1f, 2f * PlaceAt(y) - 1f, 0f);

        private static void AssertShifted(float metres, Color seen) =>
            Assert.AreEqual(PlaceAt(Size / 2) - metres * Mathf.Sin(Turned) / (2f * WaterRig.HalfWidth), seen.r / Passing, 0.006f,
                "to the left");

        private static float PlaceAt(float pixel) => (pixel + 0.5f) / Size;
    }
}
