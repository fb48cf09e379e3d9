namespace SphFluid.Validation
{
    /// <summary>What a run of a case is made with: the factors that the chart sweeps.</summary>
    public struct CaseParameters
    {
        /// <summary>The method.</summary>
        public CaseMethod Method;

        /// <summary>Particles along the case's length.</summary>
        public int Resolution;

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio;

        /// <summary>Time step over the method's stable one, 0.75 for instance.</summary>
        public double TimeStepFraction;

        /// <summary>Speed of sound over the case's own speed.</summary>
        public double SoundSpeedRatio;

        /// <summary>Seed of the start's jitter.</summary>
        public int Seed;

        /// <summary>Standard deviation of the start's jitter over dx; 0.01 in the chart.</summary>
        public double Jitter;

        /// <summary>The point that cases sweep about: the method's own κ, three quarters of the stable step, the first seed.</summary>
        /// <param name="method">The method.</param>
        /// <param name="resolution">Particles along the case's length.</param>
        /// <param name="soundSpeedRatio">Speed of sound over the case's own speed.</param>
        /// <param name="jitter">Standard deviation of the start's jitter over dx.</param>
        public static CaseParameters At(CaseMethod method, int resolution, double soundSpeedRatio, double jitter = 0.01) =>
            new CaseParameters
            {
                Method = method,
                Resolution = resolution,
                SupportRatio = method.SupportRatio,
                TimeStepFraction = 0.75,
                SoundSpeedRatio = soundSpeedRatio,
                Seed = 1,
                Jitter = jitter,
            };
    }
}
