using System.Runtime.InteropServices;

namespace SphFluid
{
    /// <summary>Constants that only the Standard method has; those of a force are with it.</summary>
    [StructLayout(LayoutKind.Auto)]
    public partial struct StandardSettings : IMethodSettings
    {
        /// <summary>Speed of sound c of the equation of state, p = c² (ρ − ρ0) [m/s].</summary>
        public float SoundSpeed;

        /// <summary>
        /// True: particles of a cell are ordered by their ids, so that equal runs are equal to the last bit, for one dispatch more a step.
        /// False: by thread timing.
        /// </summary>
        public bool StableOrder;

        /// <summary>
        /// True: the density pass lists each particle's neighbours for the motion pass, for some 150 bytes a particle at κ = 2.25; a device
        /// whose largest buffer is too small for that does without. False: both passes search.
        /// </summary>
        public bool NeighbourList;

        /// <summary>
        /// Most steps for which an order of particles and the lists of their neighbours serve, 1 or more; fewer where the liquid is fast.
        /// 1: every step sorts and searches anew.
        /// </summary>
        public int StepsPerSort;

        /// <summary>
        /// What two bodies of liquid may close while lists serve, over R, 0 or more; less where forces of their own ask for it
        /// (<see cref="ListReuse"/>).
        /// </summary>
        public float ListClosing;

        /// <summary>
        /// True: velocities behind viscosity are solved for, which is stable for steps of any length and costs some dispatches more a step.
        /// False: viscosity is added, and limits the step. The rules choose what is faster.
        /// </summary>
        public bool ImplicitViscosity;

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
            Require.Positive(StepsPerSort, nameof(StepsPerSort));
            Require.NotNegative(ListClosing, nameof(ListClosing));
        }
    }
}
