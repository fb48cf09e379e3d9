namespace SphFluid
{
    /// <summary>
    /// Watches starts that take long, those with <see cref="FluidSimulationSettings.StartRelaxation"/>, and may end them: a progress bar in
    /// the Editor, a line on a console, a loading screen. Set as <see cref="FluidSimulation.StartWatcher"/>; called on the main thread.
    /// </summary>
    public interface IFluidStartWatcher
    {
        /// <summary>Called a few times a second while a liquid comes to rest.</summary>
        /// <param name="simulation">Whose liquid.</param>
        /// <param name="progress">How far it is.</param>
        /// <returns>False ends the start: the simulation does not run, and says so.</returns>
        bool Continue(FluidSimulation simulation, FluidStartProgress progress);

        /// <summary>Called once after the last <see cref="Continue"/>, however the start ended.</summary>
        /// <param name="simulation">Whose liquid.</param>
        void Ended(FluidSimulation simulation);
    }
}
