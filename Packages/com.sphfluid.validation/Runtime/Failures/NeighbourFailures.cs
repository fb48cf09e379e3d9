using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Neighbour searches that are wrong; <see cref="NeighbourAudit"/> compares them with brute force.</summary>
    internal static class NeighbourFailures
    {
        private static readonly Vector3Int Counts = new Vector3Int(12, 12, 12);

        /// <summary>The octant's 8 cells in a grid of cells R wide; cured: all 27.</summary>
        public static FailureExperiment AsymmetricPairs()
        {
            FailureRun cured = Block(0f);
            FailureRun failing = cured.With(cured.Settings);
            failing.EightCellsOfRadius = true;
            return new FailureExperiment("asymmetric-pairs", FluidFailure.AsymmetricPairs, failing, cured,
                "share of pairs that only one particle finds", r => r.Audit == null ? double.NaN
                    : r.Audit.OneWay.Count / (double)r.Audit.Pairs);
        }

        /// <summary>All particles move by a cell and the ranges of the cells that they left stay; cured: Reset Grid Indices runs.</summary>
        public static FailureExperiment StaleGrid()
        {
            FailureRun cured = Block(0f);
            cured.Later = Block(2f * FailureBlocks.Spacing).Start;
            FailureRun failing = cured.With(cured.Settings);
            failing.RangesKept = true;
            return new FailureExperiment("stale-grid", FluidFailure.StaleGrid, failing, cured,
                "share of pairs that are met twice", r => r.Audit == null ? double.NaN : r.Audit.Double.Count / (double)r.Audit.Pairs);
        }

        // 1,728 particles about a lattice somewhat wider than at rest, moved along all axes.
        private static FailureRun Block(float shift)
        {
            float dx = FailureBlocks.Spacing;
            Vector3 domain = 20f * dx * Vector3.one;
            FluidParticle[] start = FailureBlocks.Lattice(Counts, 1.2f * dx, (shift - 9f * dx) * Vector3.one, 0.3 * dx, 0.5f * domain);
            return new FailureRun { Settings = FailureBlocks.Settings(domain), Start = start };
        }
    }
}
