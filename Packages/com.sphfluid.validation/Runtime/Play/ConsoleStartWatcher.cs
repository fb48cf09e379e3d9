namespace SphFluid.Validation
{
    /// <summary>Shows on the console how a liquid comes to rest, once that takes longer than two seconds.</summary>
    internal sealed class ConsoleStartWatcher : IFluidStartWatcher
    {
        private const double SilentSeconds = 2.0;

        private readonly SessionProgress progress;

        public ConsoleStartWatcher(SessionProgress progress) => this.progress = progress;

        public bool Continue(FluidSimulation simulation, FluidStartProgress start)
        {
            if (start.Seconds > SilentSeconds)
            {
                progress.Show(start.Share, System.TimeSpan.FromSeconds(start.SecondsLeft),
                    $"'{simulation.name}' comes to rest, {start.Steps} steps");
            }
            return true;
        }

        public void Ended(FluidSimulation simulation)
        {
        }
    }
}
