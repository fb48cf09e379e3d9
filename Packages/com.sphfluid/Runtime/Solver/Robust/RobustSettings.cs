using System;

namespace SphFluid
{
    /// <summary>Constants that only the Robust method has.</summary>
    public struct RobustSettings : IMethodSettings
    {
        /// <summary>Most that <see cref="Iterations"/> may be.</summary>
        public const int MostIterations = 64;

        /// <summary>
        /// Speed of sound c of the compliance, α = 1/(c² dt²) [m/s]. In short steps the pressure is c² (ρ − ρ0), that of the Standard
        /// method; in long ones the iterations make the liquid softer, and the step decides: <see cref="FluidRules.EffectiveSoundSpeed"/>.
        /// </summary>
        public float SoundSpeed;

        /// <summary>Equal steps that a frame is cut into, 1 to <see cref="FluidRuleInput.MostSubsteps"/>.</summary>
        public int Substeps;

        /// <summary>
        /// Least iterations of a step, 1 to <see cref="MostIterations"/>. Steps in which particles go farther than 1.7 spacings have 4 or
        /// more, beyond 3 spacings 8, and deep liquid as many as carry its weight, up to 16.
        /// </summary>
        public int Iterations;

        /// <summary>
        /// Relaxation ω of the iterations, above 0 and below 1. The lattice's border is 0.77, 0.64 and 0.52 for κ = 2, 2.25 and 2.5, and
        /// compressed liquid's is lower.
        /// </summary>
        public float Relaxation;

        /// <summary>
        /// √(g D) of the liquid's depth D at rest [m/s]; 0 without gravity. The compression at the bottom is its square over that of the
        /// effective speed of sound.
        /// </summary>
        public float DepthSpeed;

        /// <summary>
        /// True: particles of a cell are ordered by their ids, so that equal runs are equal to the last bit, for one dispatch more a step.
        /// False: by thread timing.
        /// </summary>
        public bool StableOrder;

        /// <summary>
        /// True: the first pass of a step lists each particle's neighbours for the others, for some 150 bytes a particle at κ = 2.25; a
        /// device whose largest buffer is too small for that does without. False: all passes search.
        /// </summary>
        public bool NeighbourList;

        /// <inheritdoc/>
        float IMethodSettings.SoundSpeed => SoundSpeed;

        /// <inheritdoc/>
        public IMethodSettings WithSoundSpeed(float speed)
        {
            RobustSettings changed = this;
            changed.SoundSpeed = speed;
            return changed;
        }

        /// <inheritdoc/>
        public void Validate()
        {
            Require.Positive(SoundSpeed, nameof(SoundSpeed));
            Require.NotNegative(DepthSpeed, nameof(DepthSpeed));
            Require.Within(Substeps, 1.0, FluidRuleInput.MostSubsteps, nameof(Substeps));
            Require.Within(Iterations, 1.0, MostIterations, nameof(Iterations));
            if (!(Relaxation > 0f && Relaxation < 1f))
            {
                throw new ArgumentException($"Relaxation is {Relaxation}; it must be above 0 and below 1.");
            }
        }
    }
}
