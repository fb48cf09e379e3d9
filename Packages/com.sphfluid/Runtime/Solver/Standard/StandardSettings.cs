using System;

namespace SphFluid
{
    /// <summary>Constants that only the Standard method has.</summary>
    public struct StandardSettings : IMethodSettings
    {
        /// <summary>Speed of sound c of the equation of state, p = c² (ρ − ρ0) [m/s].</summary>
        public float SoundSpeed;

        /// <summary>
        /// True: particles of a cell are ordered by their ids, so that equal runs are equal to the last bit, for one dispatch more a step.
        /// False: by thread timing.
        /// </summary>
        public bool StableOrder;

        /// <summary>
        /// True: the density pass lists each particle's neighbours for the motion pass, for some 290 bytes a particle at κ = 2.25; a device
        /// whose largest buffer is too small for that does without. False: both passes search.
        /// </summary>
        public bool NeighbourList;

        /// <summary>
        /// Most steps for which an order of particles and the lists of their neighbours serve, 1 or more; fewer where the liquid is fast.
        /// 1: every step sorts and searches anew.
        /// </summary>
        public int StepsPerSort;

        /// <summary>
        /// True: velocities behind viscosity are solved for, which is stable for steps of any length and costs some dispatches more a step. False:
        /// viscosity is added, and limits the step. The rules choose what is faster.
        /// </summary>
        public bool ImplicitViscosity;

        /// <summary>Surface tension σ [N/m]; 0: none.</summary>
        public float SurfaceTension;

        /// <summary>Angle between walls and the liquid's surface, measured in the liquid [degrees], 0 to 180: below 90 the liquid wets them. Acts with <see cref="SurfaceTension"/>.</summary>
        public float ContactAngle;

        /// <inheritdoc/>
        float IMethodSettings.SoundSpeed => SoundSpeed;

        /// <inheritdoc/>
        public IMethodSettings WithSoundSpeed(float speed)
        {
            StandardSettings changed = this;
            changed.SoundSpeed = speed;
            return changed;
        }

        /// <inheritdoc/>
        public void Validate()
        {
            Require.Positive(SoundSpeed, nameof(SoundSpeed));
            Require.NotNegative(SurfaceTension, nameof(SurfaceTension));
            Require.Within(ContactAngle, 0.0, 180.0, nameof(ContactAngle));
            Require.Positive(StepsPerSort, nameof(StepsPerSort));
        }
    }
}
