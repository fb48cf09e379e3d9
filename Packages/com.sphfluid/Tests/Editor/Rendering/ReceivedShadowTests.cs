using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// Shadows from a map of two cascades side by side, placed by the variables of the Built-in pipeline and of the Universal Render
    /// Pipeline. A blind over z above 0.1 m hangs in the first cascade, and over z below -0.1 m in the second; the light comes straight
    /// from above.
    /// </summary>
    public sealed class ReceivedShadowTests
    {
        private const int Size = 64;
        private const int Texels = 512; // of a cascade, 1.2 m wide
        private const float CascadeWidth = 1.2f;
        private const float Height = 1f; // of the light's eye and of the camera [m]

        private static readonly Matrix4x4 fromAbove = SurfaceTestScene.LookAtOrigin(new Vector3(0f, Height, -1e-4f));

        private OpaqueDrawing drawing;
        private UploadedSurface plane, far, near;
        private RenderTexture map;
        private Texture2D constants;

        [SetUp]
        public void SetUp()
        {
            drawing = new OpaqueDrawing(SurfaceTestScene.LoadShaders());
            plane = new UploadedSurface().Quad(Vector3.zero, Vector3.forward, Vector3.right, Vector3.up);
            far = Blind(0.6f);
            near = Blind(-0.6f);
            map = new RenderTexture(2 * Texels, Texels, 32, RenderTextureFormat.Shadowmap);
            constants = new Texture2D(24, 1, TextureFormat.RGBAFloat, false, true);
            GpuTest.Run(DrawMap);
        }

        [TearDown]
        public void TearDown()
        {
            drawing?.Dispose();
            plane?.Dispose();
            far?.Dispose();
            near?.Dispose();
            Object.DestroyImmediate(map);
            Object.DestroyImmediate(constants);
        }

        // The first cascade reaches to 0.25 m from the middle, by a sphere, or from the camera, by depth: here everything is as deep.
        [TestCase(MainLightShadows.Whole, 1f)]
        [TestCase(MainLightShadows.BySpheres, 1f)]
        [TestCase(MainLightShadows.BySpheres, 0.4f)]
        [TestCase(MainLightShadows.ByDepth, 1f)]
        [TestCase(MainLightShadows.Universal, 1f)]
        [TestCase(MainLightShadows.Universal, 0.4f)]
        public void ThePointsCascadeDecides(float source, float strength)
        {
            float[] lit = Draw(block => block.SetVector("_FluidReceived", Vector4.zero));
            float[] shaded = Draw(block => Place(block, source, strength, 2, 0f));
            CheckAll(lit, shaded, (x, z) =>
            {
                float fromMiddle = new Vector2(x, z).magnitude;
                bool byDistance = source == MainLightShadows.BySpheres || source == MainLightShadows.Universal;
                int cascade = source == MainLightShadows.Whole ? 0 : source == MainLightShadows.ByDepth ? 1 : fromMiddle < 0.25f ? 0
                    : fromMiddle < 0.45f ? 1 : 2;
                bool isAtEdge = Mathf.Abs(Mathf.Abs(z) - 0.1f) < 0.02f ||
                    (byDistance && (Mathf.Abs(fromMiddle - 0.25f) < 0.01f || Mathf.Abs(fromMiddle - 0.45f) < 0.01f));
                bool isUnder = cascade == 0 ? z > 0.1f : cascade == 1 && z < -0.1f;
                return isAtEdge ? float.NaN : isUnder ? 1f - strength : 1f;
            });
        }

        [Test]
        public void WithoutCascadesUniversalHasOneMatrix()
        {
            float[] lit = Draw(block => block.SetVector("_FluidReceived", Vector4.zero));
            float[] shaded = Draw(block => Place(block, MainLightShadows.Universal, 1f, 1, 0f));
            CheckAll(lit, shaded, (x, z) => Mathf.Abs(z - 0.1f) < 0.02f ? float.NaN : z > 0.1f ? 0f : 1f);
        }

        // Before the camera draws the package sets the strength to 0; where the pipeline draws no map it stays so.
        [Test]
        public void WithoutAMapUniversalIsLit()
        {
            float[] lit = Draw(block => block.SetVector("_FluidReceived", Vector4.zero));
            float[] shaded = Draw(block =>
            {
                Place(block, MainLightShadows.Universal, 1f, 2, 0f);
                block.SetVector("_MainLightShadowParams", Vector4.zero);
            });
            Assert.That(shaded, Is.EqualTo(lit).Within(1e-5f));
        }

        [TestCase(MainLightShadows.Whole, 0.5f)]
        [TestCase(MainLightShadows.Whole, 1f)]
        [TestCase(MainLightShadows.Universal, 0.5f)]
        [TestCase(MainLightShadows.Universal, 1f)]
        public void ShadowsFadeWithTheDistance(float source, float faded)
        {
            float[] lit = Draw(block => block.SetVector("_FluidReceived", Vector4.zero));
            float[] shaded = Draw(block => Place(block, source, 1f, 1, faded));
            CheckAll(lit, shaded, (x, z) => Mathf.Abs(z - 0.1f) < 0.02f ? float.NaN : z > 0.1f ? faded : 1f);
        }

        [Test]
        public void ASourceOfNoneIsLit()
        {
            float[] lit = Draw(block => block.SetVector("_FluidReceived", Vector4.zero));
            Assert.That(Draw(block => Place(block, MainLightShadows.None, 1f, 2, 0f)), Is.EqualTo(lit).Within(1e-5f));
        }

        private static UploadedSurface Blind(float z) =>
            new UploadedSurface().Quad(new Vector3(0f, 0.3f, z), Vector3.forward * 0.5f, Vector3.right, Vector3.up);

        private static void CheckAll(float[] lit, float[] shaded, Func<float, float, float> expected)
        {
            for (int i = 0; i < lit.Length; i++)
            {
                float x = (i % Size + 0.5f) / Size - 0.5f, z = (i / Size + 0.5f) / Size - 0.5f;
                float share = expected(x, z);
                Assert.Greater(lit[i], 0.1f);
                if (!float.IsNaN(share)) Assert.AreEqual(share, shaded[i] / lit[i], 5e-3f, $"at x {x}, z {z}");
            }
        }

        private static Matrix4x4 Light(int cascade) =>
            Matrix4x4.Ortho(-0.5f * CascadeWidth, 0.5f * CascadeWidth, -0.5f * CascadeWidth, 0.5f * CascadeWidth, 0f, 2f * Height);

        private void DrawMap(CommandBuffer cmd)
        {
            cmd.SetRenderTarget(map);
            cmd.ClearRenderTarget(true, false, Color.clear);
            for (int cascade = 0; cascade < 2; cascade++)
            {
                cmd.SetViewport(new Rect(cascade * Texels, 0f, Texels, Texels));
                cmd.SetViewProjectionMatrices(fromAbove, Light(cascade));
                SurfaceBuffers blind = (cascade == 0 ? far : near).Buffers;
                MaterialPropertyBlock block = Fill(blind);
                cmd.DrawProceduralIndirect(blind.Indices, Matrix4x4.identity, drawing.Material, 1, MeshTopology.Triangles,
                    blind.Arguments, 0, block);
            }
        }

        private MaterialPropertyBlock Fill(in SurfaceBuffers surface)
        {
            var placement = new DrawPlacement(Matrix4x4.identity, Vector3.one * 4f, 0f, 0, false, true, 0.02f);
            drawing.Fill(surface, new SurfaceGrid(Vector3.one * -2f, Vector3.one * 4f, 64), SurfaceWalls.Closed, placement);
            drawing.SetLook(new Color(0.5f, 0.6f, 0.7f), 0.5f);
            drawing.Block.SetVector("_FluidLightDirection", Vector3.up);
            drawing.Block.SetVector("_FluidLightColour", Vector4.one);
            drawing.Block.SetVectorArray("_FluidAmbient", new Vector4[7]);
            return drawing.Block;
        }

        // World to the cascade's half of the map, as Unity's pipelines make it.
        private static Matrix4x4 WorldToMap(int cascade)
        {
            Matrix4x4 projection = Light(cascade);
            if (SystemInfo.usesReversedZBuffer) projection.SetRow(2, -projection.GetRow(2));
            Matrix4x4 toUnit = Matrix4x4.Translate(Vector3.one * 0.5f) * Matrix4x4.Scale(Vector3.one * 0.5f);
            Matrix4x4 toHalf = Matrix4x4.Translate(new Vector3(0.5f * cascade, 0f, 0f)) * Matrix4x4.Scale(new Vector3(0.5f, 1f, 1f));
            return toHalf * toUnit * projection * fromAbove;
        }

        // faded: how far the shadow has gone at the distance of the plane, which is about a metre from the camera everywhere.
        private void Place(MaterialPropertyBlock block, float source, float strength, int cascades, float faded)
        {
            var nothing = new Matrix4x4 { m22 = 1f };
            Matrix4x4 second = cascades > 1 ? WorldToMap(1) : nothing;
            block.SetVector("_FluidShadowSource", new Vector4(source, 0f, 0f, 0f));
            if (source == MainLightShadows.Universal)
            {
                block.SetTexture("_MainLightShadowmapTexture", map);
                block.SetMatrixArray("_MainLightWorldToShadow", new[] { WorldToMap(0), second, nothing, nothing, nothing });
                block.SetVector("_CascadeShadowSplitSpheres0", new Vector4(0f, 0f, 0f, 0.25f));
                block.SetVector("_CascadeShadowSplitSpheres1", new Vector4(0f, 0f, 0f, 0.45f));
                block.SetVector("_CascadeShadowSplitSphereRadii", new Vector4(0.25f * 0.25f, 0.45f * 0.45f, 0f, 0f));
                block.SetVector("_MainLightShadowParams", new Vector4(strength, 1f, 0f, faded));
                return;
            }
            for (int cascade = 0; cascade < 4; cascade++)
                for (int row = 0; row < 4; row++)
                {
                    constants.SetPixel(4 * cascade + row, 0, (cascade == 0 ? WorldToMap(0) : cascade == 1 ? second : nothing).GetRow(row));
                }
            constants.SetPixel(16, 0, new Color(0f, 0f, 0f, 0.25f * 0.25f));
            constants.SetPixel(17, 0, new Color(0f, 0f, 0f, 0.45f * 0.45f));
            constants.SetPixel(18, 0, Color.clear);
            constants.SetPixel(19, 0, Color.clear);
            constants.SetPixel(20, 0, new Color(0.1f, 0.9f * Height, float.MaxValue, float.MaxValue));
            constants.SetPixel(21, 0, new Color(0.9f * Height, 1.1f * Height, float.MinValue, float.MinValue));
            constants.SetPixel(22, 0, new Color(1f - strength, 0f, 0f, faded));
            constants.SetPixel(23, 0, Color.clear);
            constants.Apply();
            block.SetTexture("_FluidShadowMap", map);
            block.SetTexture("_FluidShadowConstants", constants);
        }

        private float[] Draw(Action<MaterialPropertyBlock> change)
        {
            SurfaceBuffers buffers = plane.Buffers;
            MaterialPropertyBlock block = Fill(buffers);
            change(block);
            Color[] picture = SurfaceTestScene.Render(Size, fromAbove, Matrix4x4.Ortho(-0.5f, 0.5f, -0.5f, 0.5f, 0.1f, 10f), cmd =>
            {
                cmd.SetGlobalVector("_WorldSpaceCameraPos", new Vector3(0f, Height, 0f));
                cmd.DrawProceduralIndirect(buffers.Indices, Matrix4x4.identity, drawing.Material, 0, MeshTopology.Triangles,
                    buffers.Arguments, 0, block);
            });
            return Array.ConvertAll(picture, p => p.g);
        }
    }
}
