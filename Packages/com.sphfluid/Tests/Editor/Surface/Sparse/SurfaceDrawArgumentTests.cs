using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What SurfaceDrawArguments leaves for the draw, whatever was in the buffer before.</summary>
    public sealed class SurfaceDrawArgumentTests
    {
        [Test]
        public void EveryArgumentIsWrittenOverWhatWasThere()
        {
            var grid = new SurfaceGrid(Vector3.zero, Vector3.one, 16);
            using (var rig = new BlockPolygonRig(SurfaceTestScene.LoadShaders(), grid, s => 0.5f + 0.1f * (6f - (s - new Vector3(8f, 8f, 8f)).magnitude)))
            {
                rig.Mesh.DrawArguments.SetData(new uint[] { 71, 72, 73, 74, 75 });
                int indices = rig.Polygonise().Indices.Length;
                Assert.Greater(indices, 0);
                CollectionAssert.AreEqual(new uint[] { (uint)indices, 1, 0, 0, 0 }, GpuTest.Read<uint>(rig.Mesh.DrawArguments, 5),
                    "indices, instances, first index, base vertex, first instance");
            }
        }
    }
}
