using System;
using static System.FormattableString;

namespace SphFluid
{
    /// <summary>Detectors of particles where they should not be.</summary>
    internal static class ParticleDetectors
    {
        private const double ClumpedLimit = 0.01;

        // At κ = 2 a tenth of the thesis method's particles pairs at rest and no setting cures it; at 2.5 it is two fifths.
        private const double WideKernel = 2.25;
        private const double EscapedLimit = 0.001;
        private const double AtWallsLimit = 0.01;

        // The thesis's walls gather 1.5 (κ = 2) to 1.9 (κ = 2.5) layers at rest: the density misses what would be behind the wall.
        private const double CrowdingLimit = 2.25;

        // Where no pressure acts, at walls and surfaces, pairs of the thesis method end in one place: 2 % of the particles in a few
        // seconds.
        private const double MergedLimit = 0.05;

        private const double CrowdedNeighbours = 3.0;
        private const double StartCompression = 0.1;
        private const long StartSteps = 20;
        private const double StartSpeed = 2.0;

        public static FluidFinding? TensileClumping(FluidEvidence e)
        {
            if (e.Settings.PressureClamp || !(e.Now.MinDensityRatio < 1.0) || !(e.ClumpedShare > ClumpedLimit)) return null;
            return new FluidFinding(FluidFailure.TensileClumping, e.ClumpedShare, ClumpedLimit,
                Invariant($"{100.0 * e.ClumpedShare:0.#} % of the particles have another nearer than half a spacing: suction draws them ") +
                "into clumps.",
                "Set Thesis Switches > Pressure Clamp in the profile.");
        }

        public static FluidFinding? Pairing(FluidEvidence e)
        {
            if (!e.Has(FluidMethodFeatures.TwoKernels) || !(e.SupportRatio > WideKernel) || !(e.ClumpedShare > ClumpedLimit)) return null;
            return new FluidFinding(FluidFailure.Pairing, e.ClumpedShare, ClumpedLimit,
                Invariant($"{100.0 * e.ClumpedShare:0.#} % of the particles have another nearer than half a spacing: a support radius ") +
                Invariant($"of {e.SupportRatio:0.##} spacings lets them pair."),
                "Lower the profile's Support Ratio to 2.");
        }

        public static FluidFinding? CoincidentParticles(FluidEvidence e)
        {
            double limit = e.Now.Step == 0 ? 0.0 : MergedLimit;
            double share = e.Share(e.Now.Coincident);
            if (!(share > limit)) return null;
            return new FluidFinding(FluidFailure.CoincidentParticles, share, limit,
                Invariant($"{e.Now.Coincident} particles lie in the place of another, where no pressure can part them in a definite ") +
                "direction.",
                e.Now.Step == 0 ? "Give each particle a place of its own, or use Start Jitter."
                    : "Lower the profile's Support Ratio to 2, or raise its Viscosity Ratio.");
        }

        public static FluidFinding? Escaped(FluidEvidence e)
        {
            double share = e.Share(e.Now.Escaped + e.NewDomainClamps);
            if (!(share > EscapedLimit)) return null;
            return new FluidFinding(FluidFailure.Escaped, share, EscapedLimit,
                Invariant($"{e.Now.Escaped} particles are outside the domain and {e.NewDomainClamps} were put back onto its faces since ") +
                "the last measurement.",
                e.Has(FluidMethodFeatures.PenaltyWalls) ? "Raise Expected Speed, or the profile's Wall Stiffness Ratio." : Stiffer(e));
        }

        public static FluidFinding? WallStacking(FluidEvidence e)
        {
            double share = e.Share(e.Now.AtWalls);
            if (share > AtWallsLimit)
            {
                return new FluidFinding(FluidFailure.WallStacking, share, AtWallsLimit,
                    Invariant($"{100.0 * share:0.#} % of the particles touch the domain's walls, nearer than a tenth of a spacing."),
                    e.Has(FluidMethodFeatures.PenaltyWalls) ? "Raise the profile's Wall Stiffness Ratio or Wall Distance Ratio."
                        : Stiffer(e));
            }
            if (!(e.Now.WallCrowding > CrowdingLimit)) return null;
            return new FluidFinding(FluidFailure.WallStacking, e.Now.WallCrowding, CrowdingLimit,
                Invariant($"The layer next to the domain's walls holds {e.Now.WallCrowding:0.##} times the particles of one layer: they ") +
                "stack there.",
                e.Has(FluidMethodFeatures.TwoKernels) ? "Raise the profile's Viscosity Ratio, and set Thesis Switches > Pressure Clamp."
                    : Stiffer(e));
        }

        public static FluidFinding? Overflow(FluidEvidence e)
        {
            double limit = CrowdedNeighbours * 4.0 / 3.0 * Math.PI * Math.Pow(e.SupportRatio, 3.0);
            if (!(e.Now.MaxNeighbours > limit)) return null;
            return new FluidFinding(FluidFailure.Overflow, e.Now.MaxNeighbours, limit,
                Invariant($"A particle has {e.Now.MaxNeighbours} neighbours, over three times those of liquid at rest, and a cell holds ") +
                Invariant($"{e.Now.MaxCellCount}: ") +
                "nothing is lost, but steps take that much longer.",
                $"Look for liquid that starts inside other liquid; else {e.StifferLiquid}.");
        }

        // The walls of such a method push as the liquid does.
        private static string Stiffer(FluidEvidence e) => $"{char.ToUpperInvariant(e.StifferLiquid[0])}{e.StifferLiquid.Substring(1)}.";

        public static FluidFinding? OverlappingStart(FluidEvidence e)
        {
            double compression = e.Now.MaxDensityRatio - 1.0;
            if (e.Now.Step == 0 && compression > StartCompression)
            {
                return new FluidFinding(FluidFailure.OverlappingStart, compression, StartCompression,
                    Invariant($"The liquid starts compressed by {100.0 * compression:0} % somewhere: it will burst apart."),
                    "Move liquid apart that starts inside other liquid, and use a Start Jitter of 0.1 or less.");
            }
            double limit = StartSpeed * Math.Max(e.Settings.MaxSpeed, e.First.MaxSpeed);
            if (e.First.Step != 0 || e.Now.Step > StartSteps || e.TimeStep > e.Advice.Acoustic || !(e.Now.MaxSpeed > limit)) return null;
            return new FluidFinding(FluidFailure.OverlappingStart, e.Now.MaxSpeed, limit,
                Invariant($"After {e.Now.Step} steps a particle moves at {e.Now.MaxSpeed:G3} m/s, over twice the fastest speed ") +
                "expected: the liquid starts inside something.",
                "Move the liquid volume and the colliders apart.");
        }

        public static FluidFinding? StaleGrid(FluidEvidence e)
        {
            long missing = e.Now.Misplaced + Math.Abs(e.Now.Listed - e.Now.ParticleCount);
            if (missing == 0) return null;
            return new FluidFinding(FluidFailure.StaleGrid, missing, 0.0,
                Invariant($"The neighbour grid does not match the present positions: {e.Now.Misplaced} particles are not in their cell, ") +
                Invariant($"and all cells together hold {e.Now.Listed} of {e.Now.ParticleCount}."),
                "Record the neighbour setup after every change of the particles; from a script, start a new solver instead of writing " +
                "its buffers.");
        }
    }
}
