namespace SphFluid
{
    /// <summary>Constants that only the ballistic method has.</summary>
    public struct BallisticSettings : IMethodSettings
    {
        /// <summary>Speed that others take for that of sound [m/s]; nothing here sounds.</summary>
        public float SoundSpeed;

        /// <inheritdoc/>
        float IMethodSettings.SoundSpeed => SoundSpeed;

        /// <inheritdoc/>
        public IMethodSettings WithSoundSpeed(float speed) => new BallisticSettings { SoundSpeed = speed };

        /// <inheritdoc/>
        public void Validate() => Require.Positive(SoundSpeed, nameof(SoundSpeed));
    }
}
