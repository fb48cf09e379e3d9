namespace SphFluid
{
    /// <summary>Where the time of a playback comes from.</summary>
    public enum FluidPlaybackClock
    {
        /// <summary>It goes on by itself with the scene's time.</summary>
        SceneTime,

        /// <summary>An animation, a Timeline or a script sets it.</summary>
        Manual,
    }
}
