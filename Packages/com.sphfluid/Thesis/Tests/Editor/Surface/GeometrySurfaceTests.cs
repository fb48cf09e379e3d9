using System;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>
    /// The geometry shader's triangles cannot be read back: it and its compute twin are compared by what they cover,
    /// how deep and how inclined.
    /// </summary>
    public sealed class GeometrySurfaceTests
    {
        private const int Size = 256;
        private const int Cells = 32;
        private const int GeometryPass = 0;
        private const int MeshPass = 1;
        private const string ShaderPath = "Packages/com.sphfluid/Thesis/Tests/Editor/Surface/SurfaceCompare.shader";

        private static readonly Vector3 Eye = new Vector3(0.9f, 0.7f, -1.4f);
        private static readonly int EyeId = Shader.PropertyToID("_Eye");

        private FluidShaderSet shaders;
        private Material material;

        [SetUp]
        public void SetUp()
        {
            shaders = SurfaceTestScene.LoadShaders();
            if (GeometrySurface.MissingSupport() != null) Assert.Ignore(GeometrySurface.MissingSupport());
            material = new Material(TestAssets.Load<Shader>(ShaderPath));
        }

        [TearDown]
        public void TearDown()
        {
            if (material != null) UnityEngine.Object.DestroyImmediate(material);
        }

        [Test]
        public void BallLooksTheSameFromBothBackends() =>
            CompareBackends(p => 0.5f + (0.35f - (p - new Vector3(0.02f, 0.01f, 0.03f)).magnitude), 0.14);

        [Test]
        public void LiquidAgainstWallsLooksTheSameFromBothBackends() =>
            CompareBackends(p => p.y < 0.1f + 0.1f * Mathf.Sin(7f * p.x) ? 1f : 0f, 0.2);

        [Test]
        public void NoiseLooksTheSameFromBothBackends()
        {
            var random = new System.Random(5);
            CompareBackends(_ => (float)random.NextDouble(), 0.2);
        }

        [Test]
        public void EmptyFieldDrawsNothing()
        {
            using (SurfaceField field = Field(_ => 0f))
            using (var surface = new GeometrySurface(shaders))
            {
                foreach (Color pixel in DrawGeometry(surface, field)) Assert.AreEqual(0f, pixel.a);
            }
        }

        [Test]
        public void BallIsDrawnAsDeepAsItIs()
        {
            using (SurfaceField field = Field(p => 0.5f + (0.35f - p.magnitude)))
            using (var surface = new GeometrySurface(shaders))
            {
                Color centre = DrawGeometry(surface, field)[Size / 2 * Size + Size / 2];
                Assert.AreEqual(Eye.magnitude - 0.35f, centre.r, 0.01f);
                Assert.AreEqual(Eye.normalized.x, centre.g, 0.05f);
                Assert.AreEqual(Eye.normalized.y, centre.b, 0.05f);
            }
        }

        // One grid vertex inside: the edges of the eight cubes around it, seen from the front three lines in each direction over
        // two cells.
        [Test]
        public void CubesAroundAVertexAreDrawnAsWires()
        {
            float cell = 1f / Cells;
            Color[] picture = DrawCubes(p => p.magnitude < 0.5f * cell ? 1f : 0f);
            int covered = 0;
            foreach (Color pixel in picture) covered += pixel.a > 0f ? 1 : 0;
            Assert.AreEqual(6 * Size / 2, covered, Size / 4, "pixels of six lines");
            Assert.AreEqual(0f, picture[Size * 3 / 8 * Size + Size * 3 / 8].a, "the middle of a face is empty");
            Assert.AreEqual(0f, picture[Size / 8 * Size + Size / 2].a, "cubes without a vertex inside are not drawn");
        }

        // Everything inside: cubes that no surface cuts, between near and far plane 0.2 m before and behind the middle.
        [Test]
        public void CubesWithinTheLiquidAreDrawn()
        {
            Color[] picture = DrawCubes(p => 1f, 0.8f, 1.2f);
            int covered = 0;
            foreach (Color pixel in picture) covered += pixel.a > 0f ? 1 : 0;
            Assert.Greater(covered, 5 * Size, "pixels of lines across the picture");
            Assert.AreEqual(0f, picture[Size * 3 / 8 * Size + Size * 3 / 8].a, "the middle of a face is empty");
        }

        private Color[] DrawCubes(Func<Vector3, float> density, float near = 0.1f, float far = 10f)
        {
            material.EnableKeyword("FLUID_CUBES");
            float cell = 1f / Cells;
            using (SurfaceField field = Field(density))
            using (var surface = new GeometrySurface(shaders))
            {
                Matrix4x4 projection = Matrix4x4.Ortho(-2f * cell, 2f * cell, -2f * cell, 2f * cell, near, far);
                Matrix4x4 view = SurfaceTestScene.LookAtOrigin(new Vector3(0f, 0f, -1f));
                return SurfaceTestScene.Render(Size, view, projection, cmd =>
                    cmd.DrawProcedural(Matrix4x4.identity, material, GeometryPass, MeshTopology.Points,
                        field.Grid.CubeCount, 1, Properties(surface, field)));
            }
        }

        private void CompareBackends(Func<Vector3, float> density, double leastCoverage)
        {
            using (SurfaceField field = Field(density))
            using (var surface = new GeometrySurface(shaders))
            using (var polygoniser = new SurfacePolygoniser(shaders))
            {
                Color[] geometry = DrawGeometry(surface, field);
                Color[] mesh = DrawMesh(polygoniser.Polygonise(field), Properties(surface, field));
                int covered = 0;
                int different = 0;
                for (int i = 0; i < geometry.Length; i++)
                {
                    covered += mesh[i].a > 0f ? 1 : 0;
                    different += IsDifferent(geometry[i], mesh[i]) ? 1 : 0;
                }
                Assert.Greater(covered, leastCoverage * Size * Size, "pixels covered");
                // Pixels whose nearest triangles lie equally deep may show either.
                Assert.LessOrEqual(different, covered / 1000, $"different pixels of {covered}");
            }
        }

        private static bool IsDifferent(Color a, Color b) =>
            a.a != b.a || Mathf.Abs(a.r - b.r) > 1e-4f || Mathf.Abs(a.g - b.g) > 1e-3f || Mathf.Abs(a.b - b.b) > 1e-3f;

        private SurfaceField Field(Func<Vector3, float> density) =>
            SurfaceTestScene.Field(shaders, new SurfaceGrid(Vector3.one * -0.5f, Vector3.one, Cells), density);

        private static MaterialPropertyBlock Properties(GeometrySurface surface, SurfaceField field)
        {
            var placement = new DrawPlacement(Matrix4x4.identity, field.Grid.Size, 0f, 0, false);
            MaterialPropertyBlock properties = surface.Properties(field, 0.5f, null, 0f, placement);
            properties.SetVector(EyeId, Eye);
            return properties;
        }

        private Color[] DrawGeometry(GeometrySurface surface, SurfaceField field) => Render(cmd =>
            cmd.DrawProcedural(Matrix4x4.identity, material, GeometryPass, MeshTopology.Points, field.Grid.CubeCount, 1,
                Properties(surface, field)));

        private Color[] DrawMesh(SurfaceMesh surface, MaterialPropertyBlock properties)
        {
            Mesh mesh = surface.ToMesh("Twin");
            try
            {
                return Render(cmd => cmd.DrawMesh(mesh, Matrix4x4.identity, material, 0, MeshPass, properties));
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(mesh);
            }
        }

        private static Color[] Render(Action<CommandBuffer> draw) =>
            SurfaceTestScene.Render(Size, SurfaceTestScene.LookAtOrigin(Eye), Matrix4x4.Perspective(45f, 1f, 0.1f, 10f),
                draw);
    }
}
