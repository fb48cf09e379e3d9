using UnityEngine;

namespace SphFluid
{
    /// <summary>Constants that only the thesis method has.</summary>
    public struct ThesisSettings : IMethodSettings
    {
        /// <summary>Stiffness k of equation (10) [m²/s²].</summary>
        public float Stiffness;

        /// <summary>
        /// Emergency limit on the fluid's own acceleration [m/s²], for steps of <see cref="FluidSolverSettings.TimeStep"/>; gravity, body
        /// force and contact are not limited. A distance a step, so steps of another length scale it by 1/dt², unless
        /// <see cref="AccelerationLimitFixed"/>.
        /// </summary>
        public float AccelerationLimit;

        /// <summary>True: <see cref="AccelerationLimit"/> is the same for steps of every length, as 6.3.3 prints it.</summary>
        public bool AccelerationLimitFixed;

        /// <summary>True: <see cref="AccelerationLimit"/> acts, as 6.3.3 has it.</summary>
        public bool AccelerationLimitEnabled;

        /// <summary>Stiffness of walls per unit mass [1/s²].</summary>
        public float WallStiffness;

        /// <summary>Damping of walls per unit mass [1/s].</summary>
        public float WallDamping;

        /// <summary>Distance at which a wall begins to push [m].</summary>
        public float WallDistance;

        /// <summary>True: a particle counts itself in its density, equation (11). False: not, as 6.3.1 prints it.</summary>
        public bool SelfDensity;

        /// <summary>True: the ½ of equation (13), which halves the pressure gradient. False: the full gradient.</summary>
        public bool PressureHalf;

        /// <summary>True: acceleration = force × mass [kg], as 6.3.3 prints it. False: f/ρ, equation (9).</summary>
        public bool ForceTimesMass;

        /// <summary>True: the first step gives half a kick, so that velocities live between the steps, equation (21).</summary>
        public bool HalfKick;

        /// <summary>
        /// True: the sort keeps runs in shared memory from level to level and transposes nothing, in a third of the dispatches.
        /// False: as Appendix A has it. The result is the same bit by bit.
        /// </summary>
        public bool FusedSort;

        /// <summary>√(k/2) with the ½ of equation (13), √k without [m/s].</summary>
        public float SoundSpeed => Mathf.Sqrt(PressureHalf ? 0.5f * Stiffness : Stiffness);

        /// <inheritdoc/>
        public IMethodSettings WithSoundSpeed(float speed)
        {
            ThesisSettings changed = this;
            changed.Stiffness = (PressureHalf ? 2f : 1f) * speed * speed;
            return changed;
        }

        /// <inheritdoc/>
        public void Validate()
        {
            Require.Positive(Stiffness, nameof(Stiffness));
            Require.Positive(AccelerationLimit, nameof(AccelerationLimit));
            Require.NotNegative(WallStiffness, nameof(WallStiffness));
            Require.NotNegative(WallDamping, nameof(WallDamping));
            Require.NotNegative(WallDistance, nameof(WallDistance));
        }

        // The emergency is a displacement of one spacing in a step from rest.
        internal float AccelerationLimitAt(float settingsStep, float step)
        {
            double ratio = AccelerationLimitFixed ? 1.0 : settingsStep / (double)step;
            return (float)(AccelerationLimit * ratio * ratio);
        }
    }
}
