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

        /// <summary>Density, viscosity, accuracy and walls as the rules take them; sizes, heights and method are the scene's.</summary>
        public FluidRuleInput Rules;

        /// <summary>Whether the speed of sound follows the running liquid.</summary>
        public FluidSoundSpeedMode SoundSpeedMode;

        public int MaxParticles;
        public FluidShaderSet Shaders;

        /// <summary>The profile's name.</summary>
        public readonly string Name => Asset.name;
    }
}
