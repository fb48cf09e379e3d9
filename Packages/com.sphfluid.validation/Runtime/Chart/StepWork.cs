namespace SphFluid.Validation
{
    /// <summary>
    /// Expected work of a step, before anything is measured: by it a plan fits into its time. The unit is what a particle of the thesis
    /// method costs at κ = 2 beside the step's own cost. On llvmpipe with two cores (2026-11-22, the runs of <c>./run chart --quick</c>) it
    /// is about 2 µs.
    /// </summary>
    internal static class StepWork
    {
        // What a step has whatever the number of particles, in particles: dispatches, and the sort that is padded.
        private const double ThesisStep = 1200.0, StandardStep = 350.0;

        // Part of a particle's work that grows with the number of neighbours, at κ = 2.
        private const double NeighbourShare = 0.6;

        // Without the corrections particles clump, and each has more neighbours.
        private const double PrintedWeight = 3.0, ThesisWeight = 1.3, StandardWeight = 0.9;

        // Five passes over the neighbours, and a sort, where Standard has two: as counted, not timed.
        private const double RobustStep = 900.0, RobustWeight = 2.2;

        /// <summary>Work a second of llvmpipe on two cores.</summary>
        public const double SoftwareRate = 0.5e6;

        /// <summary>Work a second that plans take for a graphics card; small runs do not come near it.</summary>
        public const double CardRate = 50e6;

        /// <summary>Expected work of a step.</summary>
        public static double Of(CaseMethod method, int particles, double supportRatio)
        {
            double ratio = supportRatio / 2.0;
            double neighbours = 1.0 - NeighbourShare + NeighbourShare * ratio * ratio * ratio;
            switch (method.Kind)
            {
                case FluidMethodKind.ThesisPrinted: return ThesisStep + PrintedWeight * neighbours * particles;
                case FluidMethodKind.Thesis: return ThesisStep + ThesisWeight * neighbours * particles;
                case FluidMethodKind.Robust: return RobustStep + RobustWeight * neighbours * particles;
                default: return StandardStep + StandardWeight * neighbours * particles;
            }
        }

        /// <summary>Expected work of a step of the Standard method at κ = 2.</summary>
        public static double OfStandard(int particles) => StandardStep + StandardWeight * particles;
    }
}
