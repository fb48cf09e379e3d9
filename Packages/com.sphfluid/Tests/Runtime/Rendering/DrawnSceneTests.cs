using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Whole frames as a camera sees them: two liquids at once, each with its own drawing.</summary>
    public sealed class DrawnSceneTests
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
        }

        [TearDown]
        public void TearDown()
        {
            view.Dispose();
            rig.Dispose();
        }

        [UnityTest]
        public IEnumerator TwoLiquidsKeepTheirColours()
        {
            var left = rig.Create("Left", position: new Vector3(-0.25f, 0f, 0f)).gameObject.AddComponent<FluidParticleRenderer>();
            var right = rig.Create("Right", position: new Vector3(0.25f, 0f, 0f)).gameObject.AddComponent<FluidGeometrySurfaceRenderer>();
            if (right.MissingSupport() != null) Assert.Ignore(right.MissingSupport());
            left.Color = Color.red;
            right.Color = Color.green;
            right.GridSize = SurfaceGridSize.Cells32;
            yield return PictureRig.Frames(3);

            Color[] picture = Picture();
            Assert.Greater(Count(picture, 0, Width / 2, p => p.r > 2f * p.g && p.r > 0.2f), 200, "red pixels on the left");
            Assert.Greater(Count(picture, Width / 2, Width, p => p.g > 2f * p.r && p.g > 0.2f), 200, "green pixels on the right");
            Assert.AreEqual(0, Count(picture, 0, Width / 2, p => p.g > 2f * p.r && p.g > 0.2f), "green pixels on the left");

            left.enabled = false;
            right.gameObject.SetActive(false);
            yield return PictureRig.Frames(2);
            Assert.AreEqual(0, Count(Picture(), 0, Width, p => p.maxColorComponent > 0.05f), "pixels of liquids that are switched off");
        }

        [UnityTest]
        public IEnumerator SurfaceFallsWithItsLiquidInATurnedTank()
        {
            FluidSimulation simulation = rig.Create();
            simulation.transform.rotation = Quaternion.Euler(0f, 0f, 90f);
            var drawing = simulation.gameObject.AddComponent<FluidGeometrySurfaceRenderer>();
            if (drawing.MissingSupport() != null) Assert.Ignore(drawing.MissingSupport());
            drawing.GridSize = SurfaceGridSize.Cells32;
            yield return PictureRig.Frames(2);
            float before = MeanRow(Picture());
            yield return PictureRig.Frames(15);
            float after = MeanRow(Picture());
            Assert.Less(after, before - 2f, "the liquid falls in the picture");
        }

        [UnityTest]
        public IEnumerator ThreeDrawingsOfOneLiquidDiffer()
        {
            FluidSimulation simulation = rig.Create();
            var surface = simulation.gameObject.AddComponent<FluidGeometrySurfaceRenderer>();
            if (surface.MissingSupport() != null) Assert.Ignore(surface.MissingSupport());
            surface.GridSize = SurfaceGridSize.Cells32;
            yield return PictureRig.Frames(2);
            int mesh = Lit(Picture());

            surface.Style = FluidSurfaceStyle.Cubes;
            yield return PictureRig.Frames(2);
            int cubes = Lit(Picture());
            Assert.Greater(cubes, 100, "pixels of wires");
            Assert.Greater(mesh, 200, "pixels of the surface");

            surface.enabled = false;
            simulation.gameObject.AddComponent<FluidParticleRenderer>();
            yield return PictureRig.Frames(2);
            Assert.Greater(Lit(Picture()), 200, "pixels of particles");
        }

        [UnityTest]
        public IEnumerator LiquidIsLitByTheMainLight()
        {
            rig.Create().gameObject.AddComponent<FluidParticleRenderer>().Color = Color.white;
            view.Light.transform.rotation = Quaternion.LookRotation(Vector3.forward);
            yield return PictureRig.Frames(2);
            float front = Brightness(Picture());
            view.Light.transform.rotation = Quaternion.LookRotation(Vector3.back);
            yield return PictureRig.Frames(2);
            float back = Brightness(Picture());
            Assert.Greater(front, 2f * back, "lit from the camera's side and from behind");
            Assert.Greater(back, 0f, "ambient light remains");
        }

        private static int Lit(Color[] picture) => Count(picture, 0, Width, p => p.maxColorComponent > 0.05f);

        private static float Brightness(Color[] picture)
        {
            float sum = 0f;
            foreach (Color pixel in picture) sum += pixel.linear.maxColorComponent;
            return sum;
        }

        private Color[] Picture() => view.Pixels();

        private static int Count(Color[] picture, int from, int to, System.Predicate<Color> which)
        {
            int count = 0;
            for (int i = 0; i < picture.Length; i++)
            {
                int x = i % Width;
                count += x >= from && x < to && which(picture[i]) ? 1 : 0;
            }
            return count;
        }

        private static float MeanRow(Color[] picture)
        {
            float sum = 0f;
            int count = 0;
            for (int i = 0; i < picture.Length; i++)
            {
                if (picture[i].maxColorComponent <= 0.05f) continue;
                sum += i / Width;
                count++;
            }
            Assert.Greater(count, 100, "pixels of the liquid");
            return sum / count;
        }
    }
}
