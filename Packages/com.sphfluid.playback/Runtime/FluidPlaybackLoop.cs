namespace SphFluid
{
    /// <summary>What a playback does past the ends of its sequence.</summary>
    public enum FluidPlaybackLoop
    {
        /// <summary>It stays at the last frame, and backwards at the first.</summary>
        None,

        /// <summary>It goes on at the other end.</summary>
        Repeat,

        /// <summary>It turns back.</summary>
        PingPong,
    }
}
