using System.Collections.Generic;
using System.IO;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What the drawings promise every render pipeline, and what they do in HDRP.</summary>
    public sealed class DrawPipelineTests
    {
        private const int Size = 128;

        private static readonly Vector3 Eye = new Vector3(1.5f, 1f, -2f);

        private static readonly string[] shaderFiles =
        {
            "Rendering/FluidParticles.shader", "Rendering/ParticleSquares.hlsl", "Rendering/FluidShading.hlsl",
            "Rendering/FluidSurface.shader", "Rendering/FluidWater.shader", "Rendering/WaterThickness.shader",
            "Rendering/WaterDepth.shader",
            "Rendering/SurfaceDrawing.hlsl",
            "Rendering/WaterPath.hlsl", "Rendering/WaterShading.hlsl", "Rendering/WaterThickness.hlsl",
            "../Thesis/Shaders/Surface/FluidSurfaceGeometry.shader", "Surface/SurfaceFragment.hlsl",
            "../Thesis/Shaders/Surface/SurfaceGeometry.hlsl",
            "Surface/SurfaceShading.hlsl",
            "Surface/SurfaceGrid.hlsl", "Surface/MarchingCubes.hlsl", "Surface/Sparse/SurfaceVertices.hlsl",
        };

        [TestCase("Rendering/FluidParticles.shader")]
        [TestCase("Rendering/FluidSurface.shader")]
        [TestCase("../Thesis/Shaders/Surface/FluidSurfaceGeometry.shader")]
        public void PassesServeBuiltInAndScriptablePipelines(string file) =>
            CheckPasses(file, "ShadowCaster", "DepthOnly", "DepthNormalsOnly");

        // Of transparent things no pipeline wants the depth.
        [Test]
        public void WaterIsTransparentAndCastsShadows()
        {
            CheckPasses("Rendering/FluidWater.shader", "ShadowCaster");
            string text = Text("Rendering/FluidWater.shader");
            StringAssert.Contains("\"Queue\" = \"Transparent\"", text);
            StringAssert.Contains("Blend One OneMinusSrcAlpha", text);
        }

        private static void CheckPasses(string file, params string[] expected)
        {
            string text = Text(file);
            var modes = new List<string>();
            foreach (Match match in Regex.Matches(text, "\"LightMode\" = \"(\\w+)\"")) modes.Add(match.Groups[1].Value);
            Assert.AreEqual(expected, modes.ToArray());
            StringAssert.IsMatch("Name \"Forward\"\\s+Cull", text, "the first pass has no LightMode: every pipeline draws it");
            StringAssert.DoesNotContain("RenderPipeline", text, "one SubShader for all pipelines");
        }

        [TestCaseSource(nameof(shaderFiles))]
        public void NothingOfAPipelineIsIncludedOrRead(string file)
        {
            string text = Text(file);
            foreach (Match match in Regex.Matches(text, "#include \"([^\"]+)\""))
            {
                StringAssert.DoesNotMatch("^Packages/(?!com.sphfluid/)|UnityCG|Lighting|Core", match.Groups[1].Value);
            }
            StringAssert.DoesNotMatch("_WorldSpaceLightPos0|_LightColor0|_MainLight|unity_SH[ABC]", text);
            StringAssert.DoesNotMatch("UNITY_MATRIX_|CGPROGRAM", text);
        }

        [TestCase("UniversalRenderPipelineAsset", false, true)]
        [TestCase("HDRenderPipelineAsset", true, false)]
        [TestCase("SomebodysPipelineAsset", false, true)]
        public void PipelinesAreRecognisedByTheirAsset(string assetClass, bool highDefinition, bool shadows)
        {
            DrawPipelineKind kind = DrawPipeline.Identify(assetClass);
            Assert.AreEqual(highDefinition, kind == DrawPipelineKind.HighDefinition);
            Assert.AreEqual(shadows, DrawPipeline.HasShadows(kind));
            Assert.IsTrue(DrawPipeline.HasShadows(DrawPipelineKind.BuiltIn));

            var properties = new MaterialPropertyBlock();
            DrawPipeline.Apply(properties, kind);
            Assert.AreEqual(1f, properties.GetFloat("_FluidShadowClamp"));
            DrawPipeline.Apply(properties, DrawPipelineKind.BuiltIn);
            Assert.AreEqual(0f, properties.GetFloat("_FluidShadowClamp"));
        }

        // HDRP's matrices may be absolute or camera-relative; the liquid must lie in the same place for both, exposed.
        [TestCase(false)]
        [TestCase(true)]
        public void HighDefinitionDrawsTheSamePicture(bool cameraRelative)
        {
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            using (var squares = new ParticleSquares(shaders))
            {
                Matrix4x4 view = SurfaceTestScene.LookAtOrigin(Eye);
                Color[] builtIn = Draw(squares, view, DrawPipelineKind.BuiltIn);
                if (cameraRelative) view.SetColumn(3, new Vector4(0f, 0f, 0f, 1f));
                Color[] highDefinition = Draw(squares, view, DrawPipelineKind.HighDefinition);

                int covered = 0, moved = 0;
                for (int i = 0; i < builtIn.Length; i++)
                {
                    covered += builtIn[i].a > 0f ? 1 : 0;
                    moved += builtIn[i].a != highDefinition[i].a ? 1 : 0;
                }
                Assert.Greater(covered, 500, "pixels of the particles");
                Assert.LessOrEqual(moved, covered / 50, "pixels at the rims may differ by rounding");
                Assert.AreEqual(0.25f, Sum(highDefinition) / Sum(builtIn), 0.01f, "exposure of a quarter; only ambient light here");
            }
        }

        private static Color[] Draw(ParticleSquares squares, Matrix4x4 view, DrawPipelineKind kind)
        {
            var particles = new[] { new FluidParticle(Vector3.zero, Vector3.zero, 0),
                new FluidParticle(new Vector3(0.3f, 0.1f, 0.2f), Vector3.zero, 1) };
            var look = new ParticleLook { Size = 0.4f, Color = Color.white, FastColor = Color.white };
            var placement = new DrawPlacement(Matrix4x4.identity, Vector3.one, 0.4f, 0, false);
            var exposure = new Texture2D(1, 1, TextureFormat.RGBAFloat, false, true);
            exposure.SetPixel(0, 0, new Color(0.25f, 0f, 0f, 0f));
            exposure.Apply();
            DrawPipeline.Prepare(squares.Material, kind);
            try
            {
                using (GraphicsBuffer buffer = GpuBuffers.Create("Particles", particles.Length, FluidParticle.Stride))
                {
                    buffer.SetData(particles);
                    MaterialPropertyBlock properties = squares.Properties(buffer, look, placement);
                    properties.SetVector("_FluidLightColour", Vector4.zero);
                    return SurfaceTestScene.Render(Size, view, Matrix4x4.Perspective(40f, 1f, 0.1f, 10f), cmd =>
                    {
                        cmd.SetGlobalVector("_WorldSpaceCameraPos", Eye);
                        cmd.SetGlobalTexture("_ExposureTexture", exposure);
                        cmd.DrawProcedural(Matrix4x4.identity, squares.Material, 0, MeshTopology.Triangles,
                            particles.Length * ParticleSquares.VerticesPerParticle, 1, properties);
                    });
                }
            }
            finally
            {
                Object.DestroyImmediate(exposure);
            }
        }

        private static float Sum(Color[] picture)
        {
            float sum = 0f;
            foreach (Color pixel in picture) sum += pixel.r + pixel.g + pixel.b;
            return sum;
        }

        // Of what the files of the package say, comments left out.
        private static string Text(string file)
        {
            string path = AssetDatabase.GetAssetPath(SurfaceTestScene.LoadShaders().Find("SPH Fluid/Particles"));
            string folder = Path.GetFullPath(Path.Combine(Path.GetDirectoryName(path), ".."));
            return Regex.Replace(File.ReadAllText(Path.Combine(folder, file)), "//.*", "");
        }
    }
}
