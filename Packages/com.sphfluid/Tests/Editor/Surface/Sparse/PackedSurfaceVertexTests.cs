using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Normals of 32 bits, packed on the GPU, unpacked there and here.</summary>
    public sealed class PackedSurfaceVertexTests
    {
        private const string KernelPath = "Packages/com.sphfluid/Tests/Editor/Surface/Sparse/PackNormals.compute";
        private const float WorstDegrees = 0.004f;

        [Test]
        public void NormalsSurviveTheRoundTrip()
        {
            GpuTest.Require();
            var normals = new List<Vector3> { Vector3.right, Vector3.left, Vector3.up, Vector3.down, Vector3.forward,
                Vector3.back };
            for (int k = 0; k < 8; k++) normals.Add(new Vector3((k & 1) * 2 - 1, (k & 2) - 1, (k >> 2) * 2 - 1).normalized);
            normals.Add(new Vector3(1f, -1e-7f, -1e-7f).normalized);
            var random = new System.Random(4);
            while (normals.Count < 1009) normals.Add(ParticleSets.RandomVector(random).normalized);

            var kernel = new ComputeKernel(TestAssets.Load<ComputeShader>(KernelPath), "PackNormals");
            using (GraphicsBuffer given = GpuBuffers.Create("Normals", normals.Count, 12))
            using (GraphicsBuffer packed = GpuBuffers.Create("Packed", normals.Count, sizeof(uint)))
            using (GraphicsBuffer unpacked = GpuBuffers.Create("Unpacked", normals.Count, 12))
            {
                given.SetData(normals);
                GpuTest.Run(cmd =>
                {
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_Normals"), given);
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_Packed"), packed);
                    kernel.SetBuffer(cmd, Shader.PropertyToID("_Unpacked"), unpacked);
                    kernel.SetInt(cmd, Shader.PropertyToID("_Count"), normals.Count);
                    kernel.DispatchThreads(cmd, normals.Count, 1, 1);
                });
                uint[] bits = GpuTest.Read<uint>(packed, normals.Count);
                Vector3[] onGpu = GpuTest.Read<Vector3>(unpacked, normals.Count);
                for (int i = 0; i < normals.Count; i++)
                {
                    Vector3 here = new PackedSurfaceVertex { PackedNormal = bits[i] }.Normal;
                    Assert.Less(Degrees(normals[i], here), WorstDegrees, $"{normals[i]:F7} became {here:F7}");
                    Assert.Less((here - onGpu[i]).magnitude, 1e-6f, $"{here:F7} here, {onGpu[i]:F7} on the GPU");
                }
            }
        }

        // By the sine: the cosine of so small an angle is 1 in floats.
        private static float Degrees(Vector3 a, Vector3 b) =>
            Vector3.Dot(a, b) > 0f ? Mathf.Asin(Mathf.Min(Vector3.Cross(a, b).magnitude, 1f)) * Mathf.Rad2Deg : 180f;
    }
}
