using System.Diagnostics;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
namespace SphFluid.Tests
{
    public sealed class ScratchTimesB
    {
        [TestCase(96)]
        [TestCase(470)]
        public void Times(int cells)
        {
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            var grid = new SurfaceGrid(Vector3.zero, new Vector3(cells, 24, cells), new Vector3Int(cells, 24, cells));
            float H(int x, int z) => 11f + 3.4f * Mathf.Sin(x * 0.11f) * Mathf.Cos(z * 0.13f);
            float V(Vector3Int s) => Mathf.Clamp01(0.5f + 0.3f * (H(s.x, s.z) - s.y));
            using (var rig = new BlockPolygonRig(shaders, grid, V, b => {
                float lo = 99, hi = -99;
                for (int k = 0; k < 81; k++) { float h = H(b.x * 8 - 1 + k % 9, b.z * 8 - 1 + k / 9); lo = Mathf.Min(lo, h); hi = Mathf.Max(hi, h); }
                return b.y * 8 - 1 <= hi && b.y * 8 + 7 >= lo; }) { Walls = SurfaceWalls.Open })
            {
                rig.Mesh.Reserve(1 << 20, 1 << 22);
                uint[] counters = GpuTest.Read<uint>(rig.Blocks.Counters, 16);
                double bestCount = 1e9, bestEmit = 1e9;
                double Cpu() => Process.GetCurrentProcess().TotalProcessorTime.TotalMilliseconds;
                int reps = cells < 100 ? 20 : 4;
                for (int i = 0; i < 5; i++)
                {
                    double c0 = 0, e0 = 0;
                    for (int r = 0; r < reps; r++)
                    {
                    rig.Blocks.Counters.SetData(counters);
                    double t = Cpu();
                    GpuTest.Run(rig.RecordCount);
                    GpuTest.Read<uint>(rig.Blocks.Counters, 16);
                    c0 += Cpu() - t; t = Cpu();
                    GpuTest.Run(rig.RecordEmit);
                    GpuTest.Read<uint>(rig.Blocks.Counters, 16);
                    e0 += Cpu() - t;
                    }
                    bestCount = System.Math.Min(bestCount, c0 / reps);
                    bestEmit = System.Math.Min(bestEmit, e0 / reps);
                }
                SurfaceStatus st = rig.Status();
                System.Console.WriteLine($"blocks {st.Blocks} v {st.Vertices} t {st.Triangles} late {st.LateBlocks} open {st.OpenFaces}: CPU count {bestCount:F2} ms, emit {bestEmit:F2} ms");
            }
        }
    }
}
