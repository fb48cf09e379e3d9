using System;

namespace SphFluid
{
    /// <summary>Who watches a start that takes long.</summary>
    internal readonly struct StartWatch
    {
        private readonly Func<FluidStartProgress, bool> goesOn;
        private readonly Action ended;

        /// <param name="goesOn">Called now and then; false ends the start.</param>
        /// <param name="ended">Called once, however the start ended.</param>
        public StartWatch(Func<FluidStartProgress, bool> goesOn, Action ended)
        {
            this.goesOn = goesOn;
            this.ended = ended;
        }

        /// <summary>Whether to go on; true where nobody watches.</summary>
        public bool Continue(FluidStartProgress progress) => goesOn == null || goesOn(progress);

        /// <summary>Reports that the start has ended.</summary>
        public void End() => ended?.Invoke();
    }
}
