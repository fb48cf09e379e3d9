using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A liquid's mesh as a camera sees it, drawn with a material that knows nothing of liquids.</summary>
    public sealed class DrawnMeshTests
    {
        private SimulationRig rig;
        private PictureRig picture;
        private Material material;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig();
            picture = new PictureRig(96, 96, 0.3f);
            RenderPipelineAsset pipeline = GraphicsSettings.currentRenderPipeline;
            Shader lit = pipeline != null ? pipeline.defaultShader : Shader.Find("Standard");
            if (lit == null) Assert.Ignore("The pipeline has no lit shader of its own here.");
            material = new Material(lit) { color = Color.red };
        }

        [TearDown]
        public void TearDown()
        {
            Object.DestroyImmediate(material);
            picture.Dispose();
            rig.Dispose();
        }

        [UnityTest]
        public IEnumerator AnyMaterialDrawsTheLiquid()
        {
            FluidSimulation simulation = rig.Create();
            Show(simulation.gameObject);
            yield return PictureRig.Frames(3);
            int red = Count(picture.Pixels(), IsRed);

            // A cube of 0.2 m in a picture of 0.6 m, 96 pixels wide.
            Assert.AreEqual(32 * 32, red, 0.25 * 32 * 32);

            simulation.StopSimulation();
            yield return PictureRig.Frames(2);
            Assert.AreEqual(0, Count(picture.Pixels(), IsRed), "no liquid, no mesh");
        }

        [UnityTest]
        public IEnumerator AMirroredObjectShowsTheOutsideToo()
        {
            // A box of liquid lit from the camera's side: seen from inside, its faces would be lit from behind.
            picture.Light.transform.rotation = Quaternion.identity;
            FluidSimulation simulation = rig.Create();
            GameObject plain = Child(simulation, Vector3.one);
            yield return PictureRig.Frames(3);
            float before = Brightness(picture.Pixels());
            plain.SetActive(false);
            Child(simulation, new Vector3(-1f, 2f, 1f));
            yield return PictureRig.Frames(2);
            Assert.AreEqual(before, Brightness(picture.Pixels()), 0.05f * before);
            Assert.Greater(before, 0.2f);
        }

        [UnityTest]
        public IEnumerator TheMeshThrowsItsShadow()
        {
            // The liquid hangs before a wall; the light comes from above, so that its shadow falls below it.
            GameObject wall = GameObject.CreatePrimitive(PrimitiveType.Quad);
            wall.transform.position = new Vector3(0f, 0f, 0.25f);
            wall.GetComponent<Renderer>().sharedMaterial = new Material(material) { color = Color.white };
            picture.Light.shadows = LightShadows.Hard;
            picture.Light.transform.rotation = Quaternion.Euler(45f, 0f, 0f);
            FluidSimulation simulation = rig.Create();
            var seen = Show(simulation.gameObject);
            seen.shadowCastingMode = ShadowCastingMode.ShadowsOnly;
            yield return PictureRig.Frames(3);

            // From the middle of the liquid 0.25 m down and back lies the middle of its shadow.
            var inShadow = new Vector3(0f, -0.22f, 0.25f);
            Color[] pixels = picture.Pixels();
            float shadow = picture.PixelAt(pixels, inShadow).maxColorComponent;
            float beside = picture.PixelAt(pixels, inShadow + Vector3.right * 0.25f).maxColorComponent;
            Object.DestroyImmediate(wall.GetComponent<Renderer>().sharedMaterial);
            Object.DestroyImmediate(wall);
            Assert.Less(shadow, 0.7f * beside);
        }

        private GameObject Child(FluidSimulation simulation, Vector3 scale)
        {
            GameObject child = rig.NewObject("Mesh");
            child.transform.position = new Vector3(0.1f, 0f, 0f);
            child.transform.localScale = scale;
            Show(child);
            child.GetComponent<FluidSurfaceMesh>().Simulation = simulation;
            return child;
        }

        private MeshRenderer Show(GameObject holder)
        {
            holder.AddComponent<FluidSurfaceMesh>();
            var seen = holder.AddComponent<MeshRenderer>();
            seen.sharedMaterial = material;
            return seen;
        }

        private static bool IsRed(Color pixel) => pixel.r > 2f * pixel.g && pixel.r > 0.1f;

        private static int Count(Color[] pixels, System.Predicate<Color> which)
        {
            int count = 0;
            foreach (Color pixel in pixels) count += which(pixel) ? 1 : 0;
            return count;
        }

        private static float Brightness(Color[] pixels)
        {
            float sum = 0f;
            int count = 0;
            foreach (Color pixel in pixels)
            {
                sum += IsRed(pixel) ? pixel.r : 0f;
                count += IsRed(pixel) ? 1 : 0;
            }
            Assert.Greater(count, 300, "pixels of the liquid");
            return sum / count;
        }
    }
}
