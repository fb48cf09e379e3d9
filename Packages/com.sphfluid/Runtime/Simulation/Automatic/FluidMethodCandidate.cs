namespace SphFluid
{
    /// <summary>Where the cost of a step comes from.</summary>
    public enum FluidCostSource
    {
        /// <summary>Nothing is known of it: it is measured at the next start.</summary>
        Unknown = 0,

        /// <summary>The device cannot be timed: an estimate that no device was measured for.</summary>
        Estimated = 1,

        /// <summary>Timed at a start, on steps of this liquid beside it.</summary>
        MeasuredAtStart = 2,

        /// <summary>Timed by the graphics device in play, on a liquid of about this size.</summary>
        MeasuredInPlay = 3,
    }

    /// <summary>One way to compute a liquid that Automatic considered.</summary>
    public readonly struct FluidMethodCandidate
    {
        /// <param name="offer">The way.</param>
        /// <param name="usualStep">Time of a usual step of the method [ms]; NaN where it is not known.</param>
        /// <param name="source">Where the time comes from.</param>
        /// <param name="obstacle">Why it cannot be picked; null where it can.</param>
        internal FluidMethodCandidate(in MethodOffer offer, double usualStep, FluidCostSource source, string obstacle)
        {
            Offer = offer;
            MillisecondsAStep = offer.CostRatio * usualStep;
            CostSource = source;
            Obstacle = obstacle;
        }

        internal MethodOffer Offer { get; }

        /// <summary>The method.</summary>
        public FluidMethodKind Method => Offer.Method;

        /// <summary>Compression allowed at the bottom of the liquid at rest; 0.04 is 4 %.</summary>
        public float MaxCompression => Offer.MaxCompression;

        /// <summary>
        /// Steps of every frame where the method has a fixed number of them; 0 where the number follows from their length.
        /// </summary>
        public int Substeps => Offer.Substeps;

        /// <summary>Most steps that a frame takes.</summary>
        public double StepsAFrame => Offer.StepsAFrame;

        /// <summary>Effective speed of sound [m/s].</summary>
        public double SoundSpeed => Offer.SoundSpeed;

        /// <summary>Time of a step on this device [ms]; NaN where it is not known.</summary>
        public double MillisecondsAStep { get; }

        /// <summary>Time of a frame's steps on this device, at most [ms]; NaN where it is not known.</summary>
        public double MillisecondsAFrame => StepsAFrame * MillisecondsAStep;

        /// <summary>Where the time comes from.</summary>
        public FluidCostSource CostSource { get; }

        /// <summary>Why it cannot be picked, as the end of a sentence that begins with the method's name; null where it can.</summary>
        public string Obstacle { get; }

        /// <summary>Whether the method keeps the liquid's shape at this softness.</summary>
        public bool IsStiffEnough => Offer.SoundSpeed >= Offer.LeastSoundSpeed;
    }
}
