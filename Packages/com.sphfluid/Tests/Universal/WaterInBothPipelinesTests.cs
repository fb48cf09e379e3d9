using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>What water does with light, measured in the pictures of each pipeline.</summary>
    public sealed class WaterInBothPipelinesTests : UniversalTest
    {
        private const bool BuiltInPipeline = false;
        private const bool UniversalPipeline = true;

        [UnityTest]
        public IEnumerator TheBlockBesideItShadesTheWater([Values(BuiltInPipeline, UniversalPipeline)] bool universal)
        {
            Scene.Sun.intensity = 2f;
            Scene.Water.Water.Visibility = 0.3f; // milky, so that the water itself is lit
            yield return Draw(universal);
            Color shaded = At(universal, new Vector3(0.15f, 0.05f, -0.06f)), lit = At(universal, new Vector3(-0.15f, 0.05f, -0.06f));
            Scene.Beside.SetActive(false);
            yield return Draw(universal);
            Color free = At(universal, new Vector3(0.15f, 0.05f, -0.06f)), same = At(universal, new Vector3(-0.15f, 0.05f, -0.06f));
            Assert.That(shaded.grayscale, Is.LessThan(0.8f * free.grayscale), "in the shadow");
            Assert.That(lit.grayscale, Is.EqualTo(same.grayscale).Within(0.03f), "beyond it");
        }

        [UnityTest]
        public IEnumerator WaterDisplacesWhatIsBehindIt()
        {
            Scene.Camera.transform.position = new Vector3(-0.75f, 0.05f, -0.85f); // aslant through the front
            Scene.Camera.transform.LookAt(new Vector3(0f, -0.05f, 0f));
            Scene.Behind.transform.position += 0.4f * Vector3.right;
            Scene.Beside.SetActive(false);
            Scene.Water.Water.Refraction = 0f;
            yield return DrawBoth();
            AssertAlike();
            float straight = Universal.PlaceOfRed(Picture.All), straightBefore = BuiltIn.PlaceOfRed(Picture.All);
            Scene.Water.Water.Refraction = 1f;
            yield return DrawBoth();
            AssertAlike();
            float bent = Universal.PlaceOfRed(Picture.All), bentBefore = BuiltIn.PlaceOfRed(Picture.All);
            Assert.That(straight, Is.EqualTo(straightBefore).Within(0.005f));
            Assert.That(bent, Is.EqualTo(bentBefore).Within(0.005f));
            Assert.That(Mathf.Abs(bent - straight), Is.GreaterThan(0.03f));
            Scene.Water.enabled = false;
            yield return DrawUniversal();
            Assert.That(straight, Is.EqualTo(Universal.PlaceOfRed(Picture.All)).Within(0.02f), "not bent: where it is without water");
        }

        // Beer and Lambert: of what comes through d metres, c^d is left, with c at one metre. Both surfaces take the same from each block.
        [UnityTest]
        public IEnumerator TwiceAsMuchWaterSwallowsTheSquare([Values(BuiltInPipeline, UniversalPipeline)] bool universal)
        {
            const float red = 0.01f;
            Replace(new Bounds(new Vector3(-0.2f, -0.05f, -0.05f), new Vector3(0.3f, 0.3f, 0.1f)),
                new Bounds(new Vector3(0.2f, -0.05f, 0f), new Vector3(0.3f, 0.3f, 0.2f)));
            Scene.Water.Water.ColorAtOneMetre = new Color(red, 1f, 1f);
            Scene.Water.Water.Visibility = 1e6f;
            Scene.Beside.SetActive(false);
            Scene.Behind.transform.localPosition = new Vector3(0f, 0f, 0.35f);
            Scene.Behind.transform.localScale = new Vector3(2f, 1f, 0.02f);
            Scene.Sun.shadows = LightShadows.None;
            Scene.Camera.transform.SetPositionAndRotation(new Vector3(0f, -0.05f, -1f), Quaternion.identity);
            yield return Draw(universal);
            float thin = At(universal, new Vector3(-0.2f, -0.05f, -0.1f)).linear.r;
            float thick = At(universal, new Vector3(0.2f, -0.05f, -0.1f)).linear.r;
            Assert.That(thick / thin, Is.EqualTo(Mathf.Pow(red, 0.1f)).Within(0.06f));
        }

        // A layer of particles on the pane at the right, away from its edges.
        [UnityTest]
        public IEnumerator AFilmIsNoDarkerAtFineThanAtBalanced([Values(BuiltInPipeline, UniversalPipeline)] bool universal)
        {
            const float thickness = SimulationRig.Spacing;
            Replace(new Bounds(new Vector3(0.4f - 0.5f * thickness, 0f, 0f), new Vector3(thickness, 0.4f, 0.8f)));
            foreach (GameObject block in new[] { Scene.Floor, Scene.Behind, Scene.Beside }) block.SetActive(false);
            Scene.Camera.clearFlags = CameraClearFlags.SolidColor;
            Scene.Camera.backgroundColor = Color.white;
            Scene.Water.Water.Quality = FluidWaterQuality.Balanced;
            yield return Draw(universal);
            Picture balanced = universal ? Universal : BuiltIn;
            Scene.Water.Water.Quality = FluidWaterQuality.Fine;
            yield return Draw(universal);
            Picture fine = universal ? Universal : BuiltIn;
            Vector2 low = Scene.Camera.WorldToViewportPoint(new Vector3(0.4f, -0.12f, -0.3f));
            Vector2 high = Scene.Camera.WorldToViewportPoint(new Vector3(0.4f, 0.12f, 0.25f));
            int film = 0;
            for (int y = (int)(low.y * fine.Height); y < (int)(high.y * fine.Height); y++)
            {
                for (int x = (int)(high.x * fine.Width); x < (int)(low.x * fine.Width); x++)
                {
                    if (balanced.Luma(x, y) > 0.995) continue;
                    film++;
                    Assert.That(fine.Luma(x, y), Is.GreaterThan(0.95 * balanced.Luma(x, y)), $"pixel {x}, {y}");
                }
            }
            Assert.That(film, Is.GreaterThan(100), "pixels of the film");
        }

        // The red block behind a pool stands in its mirror, below the sky's.
        [UnityTest]
        public IEnumerator TheBlockBehindIsMirroredInTheWater([Values(BuiltInPipeline, UniversalPipeline)] bool universal)
        {
            Replace(new Bounds(new Vector3(0f, -0.1f, -0.1f), new Vector3(0.8f, 0.2f, 0.6f)));
            Scene.Behind.transform.position = new Vector3(0f, 0.05f, 0.3f);
            Scene.Behind.transform.localScale = new Vector3(0.3f, 0.25f, 0.1f);
            Scene.Camera.transform.position = new Vector3(0f, 0.12f, -1.1f);
            Scene.Camera.transform.LookAt(new Vector3(0f, 0f, 0f));
            Scene.Water.Water.Quality = FluidWaterQuality.Fast;
            var shown = new Vector3(0f, 0f, 0.12f);
            yield return Draw(universal);
            Color sky = At(universal, shown).linear;
            Scene.Water.Water.Quality = FluidWaterQuality.Fine;
            yield return Draw(universal);
            Color mirrored = At(universal, shown).linear;
            Assert.That(mirrored.r - mirrored.b, Is.GreaterThan(sky.r - sky.b + 0.1f));
            Color beside = At(universal, new Vector3(-0.3f, 0f, 0.12f)).linear;
            Assert.That(beside.b, Is.GreaterThan(beside.r), "the sky");
        }

        [UnityTest]
        public IEnumerator SprayIsSeenThroughTheWater()
        {
            var block = new Bounds(new Vector3(0f, -0.075f, -0.1f), new Vector3(0.4f, 0.25f, 0.2f));
            var drop = new Bounds(new Vector3(0.1f, -0.075f, 0.225f), Vector3.one * SimulationRig.Spacing);
            yield return ShowSpray(block);
            float builtIn = BuiltIn.Brightest(Around(drop.center)), universal = Universal.Brightest(Around(drop.center));
            yield return ShowSpray(block, drop);
            AssertAlike();
            Assert.That(BuiltIn.Brightest(Around(drop.center)), Is.GreaterThan(builtIn + 0.1f));
            Assert.That(Universal.Brightest(Around(drop.center)), Is.GreaterThan(universal + 0.1f));
        }

        [UnityTest]
        public IEnumerator FromWithinAllIsSeenThroughWater()
        {
            Replace(new Bounds(Vector3.zero, new Vector3(0.8f, 0.4f, 0.8f)));
            Scene.Water.Water.ColorAtOneMetre = new Color(0.05f, 0.5f, 0.7f);
            Scene.Camera.transform.SetPositionAndRotation(new Vector3(-0.1f, -0.06f, -0.25f), Quaternion.Euler(4f, 0f, 0f));
            yield return DrawBoth();
            AssertAlike();
            Vector2 block = Scene.Camera.WorldToViewportPoint(new Vector3(-0.08f, -0.1f, 0.22f));
            Color within = Universal.At(block).linear;
            Scene.Water.enabled = false;
            yield return DrawUniversal();
            Color without = Universal.At(block).linear;
            Assert.That(within.r, Is.LessThan(0.6f * without.r), "half a metre of water swallows red");
        }

        // Steps in the water bend light to the floor below them: at the left, as a wall shades the right half.
        [UnityTest]
        public IEnumerator CausticsFallOnTheFloorInTheSun()
        {
            Replace(Column(-0.3f, 0.2f), Column(-0.1f, 0.3f), Column(0.1f, 0.2f), Column(0.3f, 0.3f));
            Scene.Beside.SetActive(false);
            Scene.NewBlock(new Vector3(0.48f, 0.05f, 0f), new Vector3(0.05f, 0.5f, 2f));
            Scene.Samples = Asset.msaaSampleCount = 4;
            Scene.Camera.transform.position = new Vector3(0f, 1f, -0.7f);
            Scene.Camera.transform.LookAt(new Vector3(0f, -0.15f, 0f));
            yield return DrawBoth();
            Picture plainBefore = BuiltIn, plain = Universal;
            Scene.Water.Water.Caustics = 1f;
            yield return DrawBoth();
            AssertAlike();
            AssertChange(BuiltIn, plainBefore);
            AssertChange(Universal, plain);
        }

        private static Bounds Column(float middle, float height) =>
            new Bounds(new Vector3(middle, 0.5f * height - 0.2f, 0f), new Vector3(0.2f, height, 0.8f));

        private void AssertChange(Picture seen, Picture before)
        {
            Assert.That(MostApart(seen, before, -0.35f, -0.1f), Is.GreaterThan(0.05), "in the sun");
            Assert.That(MostApart(seen, before, 0.1f, 0.35f), Is.LessThan(0.01), "in the shadow");
        }

        // On the floor, from one x to another.
        private double MostApart(Picture a, Picture b, float from, float to)
        {
            Vector2 low = Scene.Camera.WorldToViewportPoint(new Vector3(from, -0.2f, -0.25f));
            Vector2 high = Scene.Camera.WorldToViewportPoint(new Vector3(to, -0.2f, 0.25f));
            double most = 0.0;
            for (int y = (int)(low.y * a.Height); y < (int)(high.y * a.Height); y++)
            {
                for (int x = (int)(low.x * a.Width); x < (int)(high.x * a.Width); x++)
                {
                    most = System.Math.Max(most, System.Math.Abs(a.Luma(x, y) - b.Luma(x, y)));
                }
            }
            return most;
        }

        private IEnumerator ShowSpray(params Bounds[] liquid)
        {
            Replace(liquid);
            Scene.Behind.transform.position = new Vector3(0f, 0f, 0.39f);
            Scene.Behind.transform.localScale = new Vector3(1f, 0.6f, 0.02f);
            Scene.Behind.GetComponent<Renderer>().sharedMaterial.color = Color.black;
            Scene.Water.Water.Refraction = 0f;
            yield return DrawBoth();
        }

        private Rect Around(Vector3 point)
        {
            Vector2 place = Scene.Camera.WorldToViewportPoint(point);
            return new Rect(place.x - 0.03f, place.y - 0.04f, 0.06f, 0.08f);
        }

        private IEnumerator Draw(bool universal) => universal ? DrawUniversal() : DrawBuiltIn();

        private Color At(bool universal, Vector3 point) =>
            (universal ? Universal : BuiltIn).At(Scene.Camera.WorldToViewportPoint(point));
    }
}
