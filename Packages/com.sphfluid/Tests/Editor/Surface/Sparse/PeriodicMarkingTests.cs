using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Blocks that are marked around drops in a periodic domain.</summary>
    public sealed class PeriodicMarkingTests
    {
        private const float Spacing = 0.05f;
        private const FluidAxes AllAxes = FluidAxes.X | FluidAxes.Y | FluidAxes.Z;
        private static readonly Vector3 Domain = Spacing * new Vector3(24f, 20f, 16f);

        [Test]
        public void ADropInThePeriodicCornerIsMarkedAtAllEightCorners()
        {
            HashSet<Vector3Int> marked = Marked(0.5f * Domain - 0.1f * Spacing * Vector3.one, AllAxes,
                out Vector3Int cells);
            for (int corner = 0; corner < 8; corner++)
            {
                // Samples begin one cube before the domain, so the last cube is in block cells / 8.
                var block = new Vector3Int((corner & 1) == 0 ? 0 : cells.x / 8, (corner & 2) == 0 ? 0 : cells.y / 8,
                    (corner & 4) == 0 ? 0 : cells.z / 8);
                Assert.IsTrue(marked.Contains(block),
                    $"corner block {block} of {cells} cells; {marked.Count} blocks are marked");
            }
        }

        // A drop in nine places within a block, so that its reach ends at every cube of a block along each axis.
        [Test]
        public void ADropFarFromTheFacesMarksWhatItMarksBetweenWalls([NUnit.Framework.Range(0, 8)] int place)
        {
            Vector3 position = (place - 4) / 3f * Spacing * new Vector3(1f, -1f, 0.5f);
            CollectionAssert.AreEquivalent(Marked(position, FluidAxes.None, out _).ToArray(),
                Marked(position, AllAxes, out _).ToArray());
        }

        // A drop at one face marks nothing beyond the two others.
        [Test]
        public void ADropAtOnePeriodicFaceMarksTheTwoSidesOfThatFace()
        {
            Vector3 position = new Vector3(0.5f * Domain.x - 0.1f * Spacing, 0f, 0f);
            Vector3 mirrored = Vector3.Scale(position, new Vector3(-1f, 1f, 1f));
            var between = new HashSet<Vector3Int>(Marked(position, FluidAxes.None, out _));
            between.UnionWith(Marked(mirrored, FluidAxes.None, out _));
            Assert.That(Marked(position, AllAxes, out _), Is.SubsetOf(between));
        }

        private static HashSet<Vector3Int> Marked(Vector3 position, FluidAxes periodic, out Vector3Int cells)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings.OctantSearch = false;
            settings.Boundaries.Periodic = periodic;
            SurfaceFieldSettings field = SurfaceFieldSettings.For(FluidSurfaceQuality.Default, settings);
            SurfaceGrid grid = SurfaceGrid.OverDomain(Domain, field.CellSize);
            cells = grid.Cells;
            var drop = new[] { new FluidParticle(position, Vector3.zero, 0u) };
            using (var rig = new BlockFieldRig(SurfaceTestScene.LoadShaders(), settings, drop))
            {
                rig.Record(field, grid, wallsClosed: false);
                return new HashSet<Vector3Int>(rig.Read().Keys);
            }
        }
    }
}
