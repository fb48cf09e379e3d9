namespace SphFluid
{
    /// <summary>
    /// Constants that only one method has, a part of <see cref="FluidSolverSettings"/>. Implement it by a struct: copies are independent.
    /// </summary>
    public interface IMethodSettings
    {
        /// <summary>Effective speed of sound c [m/s].</summary>
        float SoundSpeed { get; }

        /// <summary>The same constants for another speed of sound.</summary>
        /// <param name="speed">Effective speed of sound [m/s].</param>
        /// <returns>The changed copy.</returns>
        IMethodSettings WithSoundSpeed(float speed);

        /// <summary>Checks that every constant can be computed with.</summary>
        /// <exception cref="System.ArgumentException">A constant is out of range; the message names it.</exception>
        void Validate();
    }

    /// <summary>A change to constants that only one method has.</summary>
    /// <param name="constants">The constants.</param>
    public delegate void MethodSettingsChange<T>(ref T constants) where T : struct, IMethodSettings;
}
