namespace SphFluid
{
    /// <summary>
    /// A component that plays a liquid on the <see cref="FluidSimulation"/> of its GameObject. The simulation finds it by this interface
    /// and asks it in every LateUpdate, so its own LateUpdate should come first: give it a DefaultExecutionOrder below 50. In edit mode it
    /// is asked whenever the simulation is checked.
    /// </summary>
    public interface IFluidPlaybackSource
    {
        /// <summary>
        /// What is played; null while the simulation is to compute its own liquid. Another one starts the simulation anew.
        /// </summary>
        IFluidPlayback Playback { get; }
    }
}
