using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What a liquid is given in each frame: the scene's time, steps one by one, or what a recording has.</summary>
    internal sealed class FrameFeed
    {
        private IFluidFrames watcher;
        private int singleSteps;

        /// <summary>Whether a recording or a replay sees what the liquid is given.</summary>
        public bool IsWatched => watcher != null;

        /// <summary>Lets a recording or a replay see what the liquid is given.</summary>
        /// <param name="watcher">The recording or the replay.</param>
        /// <param name="name">Of the simulation.</param>
        /// <exception cref="InvalidOperationException">Another does already.</exception>
        public void Attach(IFluidFrames watcher, string name)
        {
            if (this.watcher != null)
            {
                throw new InvalidOperationException($"'{name}' is recorded or replayed already. Dispose of that one first.");
            }
            this.watcher = watcher;
        }

        /// <summary>Ends that.</summary>
        public void Detach(IFluidFrames watcher)
        {
            if (this.watcher == watcher) this.watcher = null;
        }

        /// <summary>Asks for one more step of a liquid that is paused, in the next frame.</summary>
        public void AddStep() => singleSteps++;

        /// <summary>Drops the steps that were asked for.</summary>
        public void Forget() => singleSteps = 0;

        /// <summary>Advances a liquid by a frame.</summary>
        /// <param name="run">The liquid.</param>
        /// <param name="spec">The simulation as it is now.</param>
        /// <param name="isPaused">Whether only single steps are taken.</param>
        /// <param name="timeScale">Time of the liquid over the scene's; below 0 or not finite it stands still.</param>
        /// <param name="report">Receives that the time scale cannot be used.</param>
        /// <param name="failure">What went wrong.</param>
        /// <returns>False when it cannot go on.</returns>
        public bool TryAdvance(FluidRun run, in FluidSpec spec, bool isPaused, float timeScale, Action<FluidMessage> report,
            out FluidMessage failure)
        {
            FluidFrame frame = isPaused ? new FluidFrame { SingleSteps = singleSteps }
                : new FluidFrame { Time = SceneTime(spec, timeScale, report) };
            Forget();
            if (watcher != null) frame = watcher.Take(frame);
            if (frame.SingleSteps == 0) return run.TryAdvance(spec, (float)frame.Time, out failure);
            failure = default;
            for (int left = frame.SingleSteps; left > 0; left--)
                if (!run.TryAdvance(spec, null, out failure)) return false;
            return true;
        }

        private static float SceneTime(in FluidSpec spec, float timeScale, Action<FluidMessage> report)
        {
            if (timeScale >= 0f && !float.IsInfinity(timeScale)) return Time.deltaTime * timeScale;
            report(FluidReports.TimeScaleInvalid(spec.Owner, timeScale));
            return 0f;
        }
    }
}
