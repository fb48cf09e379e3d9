using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Block 6.2.4 at awkward numbers of cells.</summary>
    public sealed class ResetGridIndicesTests
    {
        [TestCase(1, 1, 1)]
        [TestCase(255, 1, 1)]
        [TestCase(1, 256, 1)]
        [TestCase(1, 1, 257)]
        [TestCase(1009, 1, 1)]
        [TestCase(13, 11, 7)]
        public void EveryCellIsEmpty(int x, int y, int z)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Vector3.one, 0.03f);
            settings.DomainSize = 2f * settings.SupportRadius * new Vector3(x - 0.5f, y - 0.5f, z - 0.5f);
            using (var rig = new ThesisRig(settings, new[] { new FluidParticle(Vector3.zero, Vector3.zero, 0u) }))
            {
                int cells = x * y * z;
                Assert.That(rig.State.Grid.CellCount, Is.EqualTo(cells));
                FluidBuffer ranges = rig.State.Published.GridIndices;
                ranges.SetData(Enumerable.Range(1, 2 * cells).Select(i => (uint)i).ToArray());
                var pass = new ResetGridIndicesPass(rig.Shaders);
                GpuTest.Run(cmd => pass.Record(cmd, rig.State));
                Assert.That(GpuTest.Read<uint>(ranges, 2 * cells), Is.EqualTo(new uint[2 * cells]));
            }
        }
    }
}
