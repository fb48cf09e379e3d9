using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>ResetMCGrid at awkward numbers of grid vertices.</summary>
    public sealed class ResetMCGridTests
    {
        // Grid vertices: fewer than a group of 8 x 8 x 4 along each axis, a group, one more, primes.
        [TestCase(1, 1, 1)]
        [TestCase(6, 6, 2)]
        [TestCase(7, 7, 3)]
        [TestCase(8, 8, 4)]
        [TestCase(12, 16, 18)]
        [TestCase(32, 32, 32)]
        public void EveryVertexIsEmpty(int x, int y, int z)
        {
            FluidShaderSet shaders = SurfaceTestScene.LoadShaders();
            var grid = new SurfaceGrid(Vector3.zero, Vector3.one, new Vector3Int(x, y, z));
            var pass = new ResetMCGridPass(shaders);
            using (SurfaceField field = SurfaceTestScene.Field(shaders, grid, _ => 7f))
            {
                GpuTest.Run(cmd => pass.Record(cmd, field));
                Assert.That(GpuTest.Read<float>(field.Values, grid.VertexCount).All(value => value == 0f));
            }
        }
    }
}
