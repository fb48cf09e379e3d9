using UnityEngine.Playables;

namespace SphFluid
{
    /// <summary>A <see cref="FluidPlaybackClip"/> in a graph: has the clock of its playback from the clip's beginning to its end.</summary>
    internal sealed class FluidPlaybackBehaviour : PlayableBehaviour
    {
        private FluidPlaybackClip clip;
        private FluidPlayback playback;
        private bool hasClock;

        /// <summary>Says what it plays.</summary>
        /// <param name="clip">When.</param>
        /// <param name="playback">Whose time it sets; null: nobody's.</param>
        public void Begin(FluidPlaybackClip clip, FluidPlayback playback)
        {
            this.clip = clip;
            this.playback = playback;
        }

        /// <inheritdoc/>
        public override void OnBehaviourPlay(Playable playable, FrameData info) => TakeClock();

        /// <summary>Sets the time. Not in ProcessFrame, which may pass by a clip that is blended in from nothing.</summary>
        public override void PrepareFrame(Playable playable, FrameData info) => Follow(playable, info);

        /// <summary>
        /// At the clip's end shows the end, unless another clip has begun, and returns the clock. Where only the graph pauses, the liquid
        /// stands still.
        /// </summary>
        public override void OnBehaviourPause(Playable playable, FrameData info)
        {
            if (!hasClock || info.effectivePlayState == PlayState.Playing) return;
            ReturnClock();
            if (playback != null && !playback.IsClockTaken) Follow(playable, info);
        }

        /// <inheritdoc/>
        public override void OnPlayableDestroy(Playable playable) => ReturnClock();

        private void TakeClock()
        {
            if (hasClock || playback == null) return;
            hasClock = true;
            playback.TakeClock();
        }

        private void ReturnClock()
        {
            if (!hasClock) return;
            hasClock = false;
            if (playback != null) playback.ReturnClock();
        }

        private void Follow(Playable playable, FrameData info)
        {
            if (playback == null) return;
            double time = clip.TimeAt(playable.GetTime());
            if (AffineMath.IsFinite((float)time)) playback.Follow(time, clip.Speed * info.effectiveSpeed);
        }
    }
}
