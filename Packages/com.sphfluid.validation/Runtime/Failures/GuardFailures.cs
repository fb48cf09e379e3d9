using System;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What guards do, and what would overflow if there were lists.</summary>
    internal static class GuardFailures
    {
        /// <summary>A small block hits a large one above the limit on accelerations as 6.3.3 prints it; cured: none is needed.</summary>
        public static FailureExperiment Clamp()
        {
            float dx = FailureBlocks.Spacing;
            Vector3 domain = 16f * dx * Vector3.one;
            FluidParticle[] large =
                FailureBlocks.Lattice(new Vector3Int(5, 6, 6), dx, dx * new Vector3(0.5f, -3f, -3f), 0.01 * dx, 0.5f * domain);
            FluidParticle[] small =
                FailureBlocks.Lattice(new Vector3Int(4, 4, 4), dx, dx * new Vector3(-4.5f, -2.5f, -1.5f), 0.01 * dx, 0.5f * domain, 2);
            var cured = new FailureRun
            {
                Settings = FailureBlocks.Settings(domain),
                Start = FailureBlocks.Join(FailureBlocks.Moving(large, _ => new Vector3(-1f, 0f, 0f)),
                    FailureBlocks.Moving(small, _ => new Vector3(1f, 0f, 0f))),
                Steps = 20,
            };
            ThesisSwitches printed = ThesisSwitches.Corrected;
            printed.AccelerationLimit = ThesisAccelerationLimit.AsPrinted;
            printed.OctantSearch = false;
            return new FailureExperiment("clamp", FluidFailure.ClampActs, cured.With(cured.Settings.With(printed)), cured,
                "change of Σmv over Σm|v|",
                r => (r.EndStatistics.Momentum - r.Statistics[0].Momentum).magnitude / r.Statistics[0].MomentumScale);
        }

        /// <summary>Five times as many particles in one place as fit there.</summary>
        public static FailureExperiment Overflow()
        {
            float dx = FailureBlocks.Spacing;
            Vector3 domain = 14f * dx * Vector3.one;
            var counts = new Vector3Int(8, 8, 8);
            FailureRun Dump(double density)
            {
                float spacing = (float)(dx / Math.Pow(density, 1.0 / 3.0));
                return new FailureRun
                {
                    Settings = FailureBlocks.Settings(domain),
                    Start = FailureBlocks.Lattice(counts, spacing, -4f * spacing * Vector3.one, 0.01 * spacing, 0.5f * domain),
                    Steps = 60,
                };
            }
            return new FailureExperiment("overflow", FluidFailure.Overflow, Dump(5.0), Dump(1.0),
                "most neighbours of a particle", r => r.Statistics.Max(v => v.MaxNeighbours))
            { Survived = true };
        }
    }
}
