using UnityEngine;

namespace SphFluid
{
    /// <summary>What a liquid is and how faithfully it is computed: the values of a profile.</summary>
    internal struct ProfileSpec
    {
        /// <summary>Most particles that any profile may allow.</summary>
        public const int ParticleLimit = 16 * 1024 * 1024;

        /// <summary>The profile: the context of messages, and which one it is; null: none.</summary>
        public Object Asset;

        /// <summary>Grows with each change of the profile.</summary>
        public int Revision;

        public float RestDensity;
        public float KinematicViscosity;
        public float SupportRatio;
        public float SoundSpeedRatio;
        public float MaxCompression;
        public float TimeStepFraction;
        public float ViscosityRatio;
        public float WallDistanceRatio;
        public float WallStiffnessRatio;
        public float WallDampingRatio;
        public ThesisSwitches ThesisSwitches;
        public int MaxParticles;
        public FluidShaderSet Shaders;

        /// <summary>The profile's name.</summary>
        public readonly string Name => Asset.name;
    }
}
