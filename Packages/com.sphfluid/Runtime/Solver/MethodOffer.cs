namespace SphFluid
{
    /// <summary>The liquid and the frame that a method is asked to make an offer for.</summary>
    internal struct MethodQuestion
    {
        /// <summary>What the rules start from, with the profile's accuracy.</summary>
        public FluidRuleInput Input;

        /// <summary>Length of a frame [s].</summary>
        public double FrameTime;

        /// <summary>Usual steps of this method that the budget of a frame holds; NaN where a step's cost is not known.</summary>
        public double Affordable;
    }

    /// <summary>One way in which a method can compute a liquid: what Automatic chooses among.</summary>
    internal struct MethodOffer
    {
        /// <summary>The method.</summary>
        public FluidMethodKind Method;

        /// <summary>Compression allowed at the bottom of the liquid at rest: the profile's, or more of it.</summary>
        public float MaxCompression;

        /// <summary>Speed of sound over the fastest speed: the profile's, or less of it.</summary>
        public float SoundSpeedRatio;

        /// <summary>
        /// Steps of every frame where the method has a fixed number of them; 0 where the number follows from their length.
        /// </summary>
        public int Substeps;

        /// <summary>Passes of its steps over those of a usual step of the method: what they cost more.</summary>
        public double CostRatio;

        /// <summary>Most steps that a frame takes.</summary>
        public double StepsAFrame;

        /// <summary>Effective speed of sound [m/s]: a liquid of depth D is compressed by g D/c² at its bottom.</summary>
        public double SoundSpeed;

        /// <summary>Least speed of sound at which the method keeps the liquid's shape [m/s]; 0: any.</summary>
        public double LeastSoundSpeed;

        /// <summary>Whether the liquid is computed as the profile asks for it.</summary>
        public bool AsTheProfileAsks;

        /// <summary>The input of the rules as this offer changes it.</summary>
        public readonly FluidRuleInput Apply(FluidRuleInput input)
        {
            input.Method = Method;
            input.MaxCompression = MaxCompression;
            input.SoundSpeedRatio = SoundSpeedRatio;
            if (Substeps > 0) input.Substeps = Substeps;
            return input;
        }
    }
}
