using System.Runtime.InteropServices;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Structs that C# and HLSL share have the same layout.</summary>
    public sealed class LayoutTests
    {
        private static readonly int Particles = Shader.PropertyToID("_Particles");
        private static readonly int Triangles = Shader.PropertyToID("_Triangles");
        private static readonly int Colliders = Shader.PropertyToID("_Colliders");
        private static readonly int Values = Shader.PropertyToID("_Values");

        [Test]
        public void StrideIsTheSizeOfTheStruct()
        {
            Assert.That(Marshal.SizeOf<FluidParticle>(), Is.EqualTo(FluidParticle.Stride));
            Assert.That(Marshal.SizeOf<CollisionTriangle>(), Is.EqualTo(CollisionTriangle.Stride));
            Assert.That(Marshal.SizeOf<CollisionCollider>(), Is.EqualTo(CollisionCollider.Stride));
            Assert.That(Marshal.SizeOf<CollisionBody>(), Is.EqualTo(CollisionBody.Stride));
            Assert.That(Marshal.SizeOf<BodyTriangle>(), Is.EqualTo(BodyTriangle.Stride));
            Assert.That(Marshal.SizeOf<FloatingState>(), Is.EqualTo(FloatingState.Stride));
            Assert.That(Marshal.SizeOf<FloatingInput>(), Is.EqualTo(FloatingInput.Stride));
            Assert.That(Marshal.SizeOf<FloatingPart>(), Is.EqualTo(FloatingPart.Stride));
        }

        [Test]
        public void ParticleFieldsArriveAtTheirPlaces()
        {
            var kernel = new ComputeKernel(TestShaders.Load("Tests/Editor/Gpu/LayoutEcho.compute"), "EchoParticle");
            var particle = new FluidParticle
            {
                Position = new Vector3(1f, 2f, 3f),
                Id = 4,
                VelT0 = new Vector3(5f, 6f, 7f),
                Removed = 8f,
                VelT1 = new Vector3(9f, 10f, 11f),
                DensityOffset = 12f,
            };
            using (GraphicsBuffer particles = GpuBuffers.Create("Particles", 2, FluidParticle.Stride))
            using (GraphicsBuffer values = GpuBuffers.Create("Values", 12, sizeof(float)))
            {
                particles.SetData(new[] { default, particle });
                GpuTest.Run(cmd =>
                {
                    kernel.SetBuffer(cmd, Particles, particles);
                    kernel.SetBuffer(cmd, Values, values);
                    kernel.DispatchThreads(cmd, 1);
                });
                Assert.That(GpuTest.Read<float>(values, 12), Is.EqualTo(new float[] { 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12 }));
            }
        }

        [Test]
        public void CollisionFieldsArriveAtTheirPlaces()
        {
            var kernel = new ComputeKernel(TestShaders.Load("Tests/Editor/Gpu/LayoutEcho.compute"), "EchoCollision");
            var triangle = new CollisionTriangle { A = new Vector3(1, 2, 4), B = new Vector3(8, 16, 32), C = new Vector3(64, 128, 256) };
            var collider = new CollisionCollider
            {
                BoundsMin = new Vector3(1, 2, 4),
                FirstTriangle = 17,
                BoundsMax = new Vector3(8, 16, 32),
                TriangleCount = 23,
            };
            using (GraphicsBuffer triangles = GpuBuffers.Create("Triangles", 2, CollisionTriangle.Stride))
            using (GraphicsBuffer colliders = GpuBuffers.Create("Colliders", 2, CollisionCollider.Stride))
            using (GraphicsBuffer values = GpuBuffers.Create("Values", 7, sizeof(float)))
            {
                triangles.SetData(new[] { default, triangle });
                colliders.SetData(new[] { default, collider });
                GpuTest.Run(cmd =>
                {
                    kernel.SetBuffer(cmd, Triangles, triangles);
                    kernel.SetBuffer(cmd, Colliders, colliders);
                    kernel.SetBuffer(cmd, Values, values);
                    kernel.DispatchThreads(cmd, 1);
                });
                Assert.That(GpuTest.Read<float>(values, 7), Is.EqualTo(new float[] { 7, 56, 448, 7, 17, 56, 23 }));
            }
        }

        [Test]
        public void BodyFieldsArriveAtTheirPlaces()
        {
            var kernel = new ComputeKernel(TestShaders.Load("Tests/Editor/Gpu/LayoutEcho.compute"), "EchoBodies");
            var body = new CollisionBody
            {
                Rotation0 = new Quaternion(1, 2, 4, 8),
                Rotation1 = new Quaternion(16, 32, 64, 128),
                Position0 = new Vector3(1, 2, 4),
                FirstCell = 17,
                Position1 = new Vector3(8, 16, 32),
                Flags = 19,
                GridOrigin = new Vector3(64, 128, 256),
                CellSide = 23,
                GridCounts = new Vector3Int(1, 2, 4),
                BodyCount = 29,
                BoundsMin = new Vector3(8, 16, 32),
                BoundsMax = new Vector3(64, 128, 256),
                PartsPerMetre = 31,
                StretchDiagonal0 = new Vector3(1, 2, 4),
                StretchShear0 = new Vector3(8, 16, 32),
                StretchDiagonal1 = new Vector3(64, 128, 256),
                StretchShear1 = new Vector3(512, 1024, 2048),
                EndTriangles = 37,
            };
            var triangle = new BodyTriangle
            {
                A = new Vector3(1, 2, 4), NormalX = 8, B = new Vector3(16, 32, 64), NormalY = 128,
                C = new Vector3(1, 2, 4), NormalZ = 16
            };
            using (GraphicsBuffer bodies = GpuBuffers.Create("Bodies", 2, CollisionBody.Stride))
            using (GraphicsBuffer triangles = GpuBuffers.Create("BodyTriangles", 2, BodyTriangle.Stride))
            using (GraphicsBuffer values = GpuBuffers.Create("Values", 21, sizeof(float)))
            {
                bodies.SetData(new[] { default, body });
                triangles.SetData(new[] { default, triangle });
                GpuTest.Run(cmd =>
                {
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_Bodies"), bodies);
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_BodyTriangles"), triangles);
                    kernel.SetBuffer(cmd, Values, values);
                    kernel.DispatchThreads(cmd, 1);
                });
                float[] expected = { 15, 240, 7, 17, 56, 19, 448, 23, 7, 29, 56, 448, 15, 240, 23, 31, 7, 56, 448, 3584, 37 };
                Assert.That(GpuTest.Read<float>(values, 21), Is.EqualTo(expected));
            }
        }
    }
}
