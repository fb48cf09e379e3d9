using System;

namespace SphFluid
{
    /// <summary>
    /// The GPU time of a simulation's steps: taken for as long as anybody asks for it, and once after a start for what the choice of a
    /// method goes by.
    /// </summary>
    internal sealed class StepTiming : IDisposable
    {
        private readonly StepCostWatch costs = new StepCostWatch();
        private int askers;

        /// <summary>Takes the time; null: nobody asks for it.</summary>
        public StepTimer Timer { get; private set; }

        /// <summary>Begins to time; each call needs a <see cref="TryEnd"/>.</summary>
        public void Begin()
        {
            if (askers++ == 0) Timer = new StepTimer();
        }

        /// <summary>Ends what <see cref="Begin"/> began.</summary>
        /// <param name="run">The running liquid; null: none.</param>
        /// <returns>False where nothing was begun.</returns>
        public bool TryEnd(FluidRun run)
        {
            if (askers == 0) return false;
            if (--askers > 0) return true;
            if (run != null) run.Timer = null;
            Dispose();
            return true;
        }

        /// <summary>
        /// A liquid started whose method was chosen: what its steps cost in play is better known than what they cost at the start.
        /// </summary>
        public void BeginCosts()
        {
            if (!StepTimer.IsSupported) return;
            Begin();
            costs.Begin();
        }

        /// <summary>Looks whether the cost is known by now.</summary>
        /// <param name="run">The running liquid.</param>
        /// <param name="choice">By which it runs; null: its method is given.</param>
        /// <param name="owner">The object that messages name.</param>
        /// <param name="report">Receives what is to be said of it.</param>
        public void LookAtCosts(FluidRun run, FluidMethodChoice choice, UnityEngine.Object owner, Action<FluidMessage> report)
        {
            if (!costs.IsUnderWay) return;
            if (costs.Look(Timer, run, choice, owner) is FluidMessage message) report(message);
            if (!costs.IsUnderWay) TryEnd(run);
        }

        /// <summary>The liquid does not run any more.</summary>
        public void EndCosts(FluidRun run)
        {
            if (!costs.IsUnderWay) return;
            costs.End();
            TryEnd(run);
        }

        /// <summary>Frees the timer, whoever asks.</summary>
        public void Dispose()
        {
            Timer?.Dispose();
            Timer = null;
        }
    }
}
