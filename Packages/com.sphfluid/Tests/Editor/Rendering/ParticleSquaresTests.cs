using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Particles as squares: what one particle covers.</summary>
    public sealed class ParticleSquaresTests
    {
        private const int Size = 200;
        private const float ViewHeight = 2f; // m across the picture, so 100 pixels a metre

        private FluidShaderSet shaders;
        private ParticleSquares squares;

        [SetUp]
        public void SetUp()
        {
            shaders = SurfaceTestScene.LoadShaders();
            squares = new ParticleSquares(shaders);
        }

        [TearDown]
        public void TearDown() => squares?.Dispose();

        [Test]
        public void OneParticleCoversADisc()
        {
            Color[] picture = Draw(0.8f, null, Matrix4x4.identity, new Vector3(0.1f, -0.2f, 0f));
            Assert.AreEqual(Math.PI * 40 * 40, Covered(picture), 0.03 * Math.PI * 40 * 40);
            Vector2 centre = Centre(picture);
            Assert.AreEqual(Size / 2 + 10, centre.x, 1f);
            Assert.AreEqual(Size / 2 - 20, centre.y, 1f);
        }

        [Test]
        public void OwnSpriteWithoutHolesCoversTheSquare()
        {
            Color[] picture = Draw(0.8f, Texture2D.whiteTexture, Matrix4x4.identity, Vector3.zero);
            Assert.AreEqual(80 * 80, Covered(picture), 200);
        }

        [Test]
        public void SquaresFaceTheCameraAndGoWithTheTransform()
        {
            Matrix4x4 turned = Matrix4x4.TRS(new Vector3(0f, 0.3f, 0f), Quaternion.Euler(20f, 70f, 10f), Vector3.one);
            Color[] picture = Draw(0.8f, null, turned, Vector3.zero);
            Assert.AreEqual(Math.PI * 40 * 40, Covered(picture), 0.03 * Math.PI * 40 * 40);
            Assert.AreEqual(Size / 2 + 30, Centre(picture).y, 1f);
        }

        [Test]
        public void EachParticleIsDrawn()
        {
            Color[] picture = Draw(0.2f, null, Matrix4x4.identity, new Vector3(-0.5f, 0f, 0f), new Vector3(0.5f, 0f, 0f),
                new Vector3(0f, 0.5f, 0.1f));
            Assert.AreEqual(3 * Math.PI * 10 * 10, Covered(picture), 0.08 * 3 * Math.PI * 10 * 10);
        }

        [Test]
        public void BoundsHoldTheTurnedDomainAndItsMargin()
        {
            Matrix4x4 turned = Matrix4x4.TRS(new Vector3(1f, 2f, 3f), Quaternion.Euler(0f, 45f, 0f), Vector3.one);
            Bounds bounds = new DrawPlacement(turned, new Vector3(2f, 1f, 2f), 0.5f, 3, true).WorldBounds;
            Assert.AreEqual(new Vector3(1f, 2f, 3f), bounds.center);
            Assert.AreEqual(3f * Mathf.Sqrt(2f), bounds.size.x, 1e-4f);
            Assert.AreEqual(2f, bounds.size.y, 1e-4f);
            Assert.AreEqual(3f * Mathf.Sqrt(2f), bounds.size.z, 1e-4f);
        }

        [Test]
        public void RenderParametersAreAllSet()
        {
            var placement = new DrawPlacement(Matrix4x4.identity, Vector3.one, 0f, 5, true);
            var properties = new MaterialPropertyBlock();
            RenderParams parameters = placement.Parameters(squares.Material, properties);
            Assert.AreSame(squares.Material, parameters.material);
            Assert.AreSame(properties, parameters.matProps);
            Assert.AreEqual(5, parameters.layer);
            Assert.AreEqual(Vector3.one, parameters.worldBounds.size);
            Assert.AreEqual(UnityEngine.Rendering.ShadowCastingMode.On, parameters.shadowCastingMode);
            Assert.IsNull(parameters.camera);
        }

        [Test]
        public void MissingShaderIsNamed()
        {
            var empty = ScriptableObject.CreateInstance<FluidShaderSet>();
            try
            {
                var exception = Assert.Throws<FluidDeviceException>(() => new ParticleSquares(empty).Dispose());
                StringAssert.Contains("SPH Fluid/Particles", exception.Message);
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(empty);
            }
        }

        private Color[] Draw(float size, Texture2D sprite, Matrix4x4 localToWorld, params Vector3[] positions)
        {
            var particles = new FluidParticle[positions.Length];
            for (int i = 0; i < positions.Length; i++) particles[i] = new FluidParticle(positions[i], Vector3.zero, (uint)i);
            var look = new ParticleLook { Size = size, Color = Color.white, FastColor = Color.red, Sprite = sprite };
            var placement = new DrawPlacement(localToWorld, Vector3.one, size, 0, false);
            Matrix4x4 projection = Matrix4x4.Ortho(-ViewHeight / 2f, ViewHeight / 2f, -ViewHeight / 2f, ViewHeight / 2f, 0.1f, 10f);
            using (GraphicsBuffer buffer = GpuBuffers.Create("Particles", particles.Length, FluidParticle.Stride))
            {
                buffer.SetData(particles);
                MaterialPropertyBlock properties = squares.Properties(buffer, look, placement);
                return SurfaceTestScene.Render(Size, SurfaceTestScene.LookAtOrigin(new Vector3(0f, 0f, -3f)), projection, cmd =>
                    cmd.DrawProcedural(Matrix4x4.identity, squares.Material, 0, MeshTopology.Triangles,
                        particles.Length * ParticleSquares.VerticesPerParticle, 1, properties));
            }
        }

        private static int Covered(Color[] picture)
        {
            int covered = 0;
            foreach (Color pixel in picture) covered += pixel.a > 0f ? 1 : 0;
            return covered;
        }

        private static Vector2 Centre(Color[] picture)
        {
            Vector2 sum = Vector2.zero;
            for (int i = 0; i < picture.Length; i++)
            {
                if (picture[i].a > 0f) sum += new Vector2(i % Size + 0.5f, i / Size + 0.5f);
            }
            return sum / Covered(picture);
        }
    }
}
