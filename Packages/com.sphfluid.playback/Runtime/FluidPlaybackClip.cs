using System;
using UnityEngine;
using UnityEngine.Playables;

namespace SphFluid
{
    /// <summary>
    /// A clip on a Playable Track of a Timeline, or in any other graph of playables with an output: sets the time of a
    /// <see cref="FluidPlayback"/> while it plays.
    /// </summary>
    [ManualPage("playback", "in-a-timeline", "com.sphfluid.playback")]
    public sealed class FluidPlaybackClip : PlayableAsset
    {
        // As long as a Timeline makes the clips of those who do not say.
        private const double UnknownDuration = 5.0;

        [SerializeField, Tooltip("The Fluid Playback whose time the clip sets.")]
        private ExposedReference<FluidPlayback> playback;

        [SerializeField, Min(0f), Tooltip("Time of the sequence at the clip's start, in seconds since the first frame.")]
        private float start;

        [SerializeField,
            Tooltip(
                "Time of the sequence over the clip's time: 1 as it was made, 0.5 half as fast, 0 a still, −1 backwards, from Start down.")]
        private float speed = 1f;

        private FluidPlayback resolved;

        /// <summary>The playback whose time the clip sets, as the graph's table resolves it when the graph is made.</summary>
        public ExposedReference<FluidPlayback> Playback { get => playback; set => playback = value; }

        /// <summary>Time of the sequence at the clip's start, since the first frame [s], 0 or more.</summary>
        /// <exception cref="ArgumentOutOfRangeException">It is negative or not finite.</exception>
        public float Start
        {
            get => Limits.Clamp(start, 0f);
            set => start = value >= 0f && AffineMath.IsFinite(value) ? value
                : throw new ArgumentOutOfRangeException(nameof(value), value, "The start must be a finite number of seconds, 0 or more.");
        }

        /// <summary>Time of the sequence over the clip's; negative: backwards. An asset's that is not a number counts as 0.</summary>
        /// <exception cref="ArgumentOutOfRangeException">It is not finite.</exception>
        public float Speed
        {
            get => Limits.Finite(speed);
            set => speed = AffineMath.IsFinite(value) ? value
                : throw new ArgumentOutOfRangeException(nameof(value), value, "The speed must be a finite number.");
        }

        /// <summary>
        /// Time until the end of the sequence is shown, or backwards its beginning [s]; 5 while the sequence is not known or nothing moves.
        /// </summary>
        public override double duration
        {
            get
            {
                double length = resolved != null ? resolved.KnownDuration : 0.0;
                double seconds = (Speed < 0f ? Start : length - Start) / Math.Abs((double)Speed);
                return length > 0.0 && seconds > 0.0 && seconds < double.PositiveInfinity ? seconds : UnknownDuration;
            }
        }

        /// <inheritdoc/>
        public override Playable CreatePlayable(PlayableGraph graph, GameObject owner)
        {
            resolved = playback.Resolve(graph.GetResolver());
            ScriptPlayable<FluidPlaybackBehaviour> playable = ScriptPlayable<FluidPlaybackBehaviour>.Create(graph);
            if (Application.isPlaying)
            {
                playable.GetBehaviour().Begin(this, resolved);
                if (resolved == null) Missing(owner).Log();
            }
            else if (resolved != null)
            {
                _ = ((IFluidPlaybackSource)resolved).Playback; // looks at the folder, for the duration
            }
            return playable;
        }

        /// <summary>Time since the first frame of the sequence [s] at a time of the clip.</summary>
        internal double TimeAt(double clipTime) => Start + Speed * clipTime;

        private FluidMessage Missing(GameObject owner) => new FluidMessage(FluidSeverity.Warning, FluidIssue.PlaybackClipUnbound, this,
            $"The clip{(owner != null ? $" in the Timeline of '{owner.name}'" : "")} has no Fluid Playback, so it plays nothing.",
            "Select it in the Timeline and set Playback to an object with a Fluid Playback.");
    }
}
