using System;
using System.IO;
using UnityEngine;
using UnityTime = UnityEngine.Time;

namespace SphFluid
{
    /// <summary>
    /// Plays a liquid from particle files on the simulation on the same GameObject, in the place of its steps and volumes: with the same
    /// surface, water, whitewater, queries and instruments. Frames are read ahead on a thread of their own. Disabled, or where the files
    /// cannot be played, the simulation simulates.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Playback")]
    [RequireComponent(typeof(FluidSimulation))]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(40)]
    [ManualPage("playback", package: "com.sphfluid.playback")]
    public sealed class FluidPlayback : MonoBehaviour, IFluidPlaybackSource
    {
        // Forwards by more than this [s], or by more than so many frames of the scene, is no play but a jump.
        private const double LongestStep = 0.1, MostFrames = 3.0;

        [SerializeField, Delayed,
            Tooltip(
                "Folder of the particle files, absolute or from StreamingAssets: one with sequence.json, or with .ply files that are " +
                "played in the order of their names.")]
        private string folder = "";

        [SerializeField,
            Tooltip(
                "Time since the first frame in seconds. Past the end, Loop decides. An animation may key it with Clock set to " +
                "Manual; a Fluid Playback Clip of a Timeline sets it too.")]
        private float time;

        [SerializeField, Tooltip("Scene Time: Time goes on by itself. Manual: an animation, a Timeline or a script sets it.")]
        private FluidPlaybackClock clock = FluidPlaybackClock.SceneTime;

        [SerializeField,
            Tooltip(
                "Time of the sequence over the scene's time, with Scene Time: 1 as it was made, 0.5 half as fast, −1 backwards. The " +
                "simulation's Time Scale applies as well.")]
        private float speed = 1f;

        [SerializeField, Tooltip("What happens past the ends of the sequence.")]
        private FluidPlaybackLoop loop = FluidPlaybackLoop.None;

        [SerializeField,
            Tooltip(
                "Show particles between frames too, matched by id and carried by their velocities. Off: the nearer frame is " +
                "shown.")]
        private bool interpolate = true;

        [SerializeField, Min(1), Tooltip("Memory for frames that are read ahead, in MiB; two frames at least must fit.")]
        private int memoryBudget = 256;

        [SerializeField,
            Tooltip(
                "Wait for frames that are not read yet. Off: the last one stays until they are. Frames are always waited for where " +
                "Time.captureDeltaTime is set.")]
        private bool waitForFrames;

        [SerializeField,
            Tooltip(
                "Where no camera sees the domain nothing is read or shown, and time goes on. Off where scripts or instruments need the " +
                "liquid all the time.")]
        private bool cullUnseen;

        [Header("Folders without sequence.json")]
        [SerializeField, Min(0f), Tooltip("Frames a second.")]
        private float frameRate = 30f;

        [SerializeField, Tooltip("Which way the axes of the files point.")]
        private FluidSequenceAxes axes = FluidSequenceAxes.AsUnity;

        [SerializeField, Min(0f), Tooltip("Metres of a unit of length in the files.")]
        private float scale = 1f;

        private FluidSimulation simulation;
        private SequencePlayer player;
        private PlaybackOptions opened;
        private (PlaybackOptions options, DateTime written, SequencePlan plan) preview;
        private double playhead, before, takenRate;
        private int direction = 1, takers;
        private bool isOpened, isPaused, seeks, stays, wasUnseen;

        /// <summary>Raised when a sequence that is not looped has come to its end, or backwards to its beginning.</summary>
        public event Action<FluidPlayback> Ended;

        /// <summary>Folder of the particle files, absolute or from StreamingAssets. Another one is opened in the next LateUpdate.</summary>
        public string Folder { get => folder; set => folder = value ?? ""; }

        /// <summary>
        /// Time since the first frame [s]; past the end <see cref="Loop"/> decides. Shown in the next LateUpdate, or held back until its
        /// frames are read; what is not finite counts for nothing there.
        /// </summary>
        public float Time { get => Limits.Finite(time); set => time = value; }

        /// <summary>
        /// Whether <see cref="Time"/> goes on by itself. Manual while a <see cref="FluidPlaybackClip"/> plays, and afterwards what it was
        /// set to.
        /// </summary>
        public FluidPlaybackClock Clock { get => IsClockTaken ? FluidPlaybackClock.Manual : Limits.Known(clock); set => clock = value; }

        /// <summary>Time of the sequence over the scene's; negative: backwards. Not a number counts as 0: it stands still.</summary>
        public float Speed { get => Limits.Finite(speed); set => speed = value; }

        /// <summary>What happens past the ends.</summary>
        public FluidPlaybackLoop Loop { get => Limits.Known(loop); set => loop = value; }

        /// <summary>Whether particles are shown between frames too.</summary>
        public bool Interpolate { get => interpolate; set => interpolate = value; }

        /// <summary>Memory for frames [MiB], 1 or more. Another one begins anew.</summary>
        public int MemoryBudget { get => Mathf.Max(1, memoryBudget); set => memoryBudget = value; }

        /// <summary>Whether frames that are not read yet are waited for. They always are where Time.captureDeltaTime is set.</summary>
        public bool WaitForFrames { get => waitForFrames; set => waitForFrames = value; }

        /// <summary>Whether nothing is read or shown where no camera sees the domain.</summary>
        public bool CullUnseen { get => cullUnseen; set => cullUnseen = value; }

        /// <summary>Frames a second of a folder without sequence.json.</summary>
        public float FrameRate { get => frameRate; set => frameRate = value; }

        /// <summary>Which way the axes of files without sequence.json point.</summary>
        public FluidSequenceAxes Axes { get => Limits.Known(axes); set => axes = value; }

        /// <summary>Metres of a unit of length in files without sequence.json.</summary>
        public float Scale { get => scale; set => scale = value; }

        /// <summary>Whether a sequence is open, so that the simulation shows it.</summary>
        public bool IsOpen => player != null;

        /// <summary>Whether time goes on by itself: not paused, not manual, and not at the end.</summary>
        public bool IsPlaying => player != null && Clock == FluidPlaybackClock.SceneTime && !isPaused && Speed != 0f && !IsAtEnd;

        /// <summary>Whether a frame that is to be shown is not read yet, so that the last one stays.</summary>
        public bool IsBuffering => player != null && player.IsBuffering;

        /// <summary>Time from the first frame to the last [s]; 0 while nothing is open.</summary>
        public float Duration => player != null ? (float)player.Sequence.Duration : 0f;

        /// <summary>Number of frames; 0 while nothing is open.</summary>
        public int FrameCount => player?.Sequence.Frames.Count ?? 0;

        /// <summary>The frame that is shown, from 0 on, the earlier one between two; −1: none so far.</summary>
        public int CurrentFrame => player?.ShownFrame ?? -1;

        /// <summary>Particles of the shown frame that are left out: outside of the domain, or no numbers.</summary>
        public int LeftOutParticles => player?.LeftOut ?? 0;

        /// <summary>Memory that frames take [bytes].</summary>
        public long MemoryBytes => player?.Bytes ?? 0;

        /// <summary>Particle spacing that the sequence was made with [m]; 0 where it does not say.</summary>
        public float SequenceSpacing => player?.Sequence.Spacing ?? 0f;

        /// <summary>Edge lengths of the domain that the sequence was made in [m]; 0 where it does not say.</summary>
        public Vector3 SequenceDomainSize => player?.Sequence.DomainSize ?? Vector3.zero;

        /// <summary>What the sequence was made by; empty where it does not say.</summary>
        public string Source => player?.Sequence.Source ?? "";

        /// <summary>Why nothing is played; null: it is, or nothing was opened yet.</summary>
        public FluidMessage? Problem { get; private set; }

        IFluidPlayback IFluidPlaybackSource.Playback => !enabled ? null : Application.isPlaying ? player : Preview();

        internal SequencePlayer Player => player;

        /// <summary>Whether a clip of a Timeline sets the time.</summary>
        internal bool IsClockTaken => takers > 0;

        /// <summary>
        /// Time from the first frame to the last [s], in the Editor that of the folder when it was last looked at; 0 while it is not known.
        /// </summary>
        internal double KnownDuration => (player?.Sequence ?? preview.plan?.Sequence)?.Duration ?? 0.0;

        private PlaybackOptions Options => new PlaybackOptions
        {
            Folder = folder,
            FrameRate = frameRate,
            Axes = Axes,
            Scale = scale,
            MemoryBudget = MemoryBudget,
            Interpolates = interpolate,
        };

        /// <summary>Goes on after <see cref="Pause"/>; at the end of a sequence that is not looped, from its beginning.</summary>
        public void Play()
        {
            isPaused = false;
            if (IsAtEnd) Seek(Speed < 0f ? Duration : 0f);
        }

        /// <summary>Stands still at the present frame until <see cref="Play"/>.</summary>
        public void Pause() => isPaused = true;

        /// <summary>Jumps to a time: whitewater and readings begin anew there.</summary>
        /// <param name="to">Time since the first frame [s].</param>
        /// <exception cref="ArgumentOutOfRangeException">It is not finite.</exception>
        public void Seek(float to)
        {
            if (!AffineMath.IsFinite(to))
            {
                throw new ArgumentOutOfRangeException(nameof(to), to, "The time must be a finite number of seconds.");
            }
            time = to;
            playhead = to;
            seeks = stays = true;
        }

        /// <summary>
        /// Opens the folder now, again if it is open: for files that were changed or mended, and to know at once whether they can be
        /// played.
        /// </summary>
        /// <returns>Whether they can; if not, <see cref="Problem"/> says why.</returns>
        /// <exception cref="InvalidOperationException">The component or its object is disabled, or nothing is played because the game is
        /// not.</exception>
        public bool Reload()
        {
            if (!isActiveAndEnabled || !Application.isPlaying)
            {
                throw new InvalidOperationException(
                    $"'{name}' is disabled or not played, so no folder is opened. Enable it in play mode first.");
            }
            return TryOpen();
        }

        /// <summary>From now on <see cref="Follow"/> sets the time, until each who took the clock has returned it.</summary>
        internal void TakeClock() => takers++;

        /// <summary>Lets time go on as <see cref="Clock"/> is set.</summary>
        internal void ReturnClock() => takers--;

        /// <summary>Sets the time to that of who took the clock.</summary>
        /// <param name="to">Time since the first frame [s].</param>
        /// <param name="rate">Time of the sequence over the scene's: faster steps than that are jumps.</param>
        internal void Follow(double to, double rate)
        {
            time = (float)to;
            playhead = to;
            takenRate = rate;
        }

        private void OnDisable() => Close();

        private void LateUpdate()
        {
            if ((!isOpened || !opened.Equals(Options)) && !TryOpen()) Problem?.Log();
            if (player == null) return;
            Advance();
            bool isUnseen = cullUnseen && !IsSeen;
            seeks |= wasUnseen;
            wasUnseen = isUnseen;
            if (!isUnseen) Show();
        }

        private bool TryOpen()
        {
            Close();
            TryGetComponent(out simulation);
            (opened, isOpened) = (Options, true);
            seeks = stays = true;
            SequencePlan plan = SequencePlan.TryMake(opened, this, out FluidMessage? problem);
            if (plan != null) player = new SequencePlayer(plan, this, simulation.Report);
            Problem = problem;
            return plan != null;
        }

        private void Close()
        {
            player?.Dispose();
            player = null;
            isOpened = false;
        }

        // What was opened or sought is shown before time goes on. A double goes on where a float would lose the last digits of each frame's
        // time.
        private void Advance()
        {
            if (!AffineMath.IsFinite(time)) time = (float)playhead;
            if ((float)playhead != time) playhead = time;
            bool stayed = stays;
            stays = false;
            if (stayed || !IsPlaying || simulation.Paused || !(simulation.TimeScale >= 0f && simulation.TimeScale <= float.MaxValue))
            {
                return;
            }
            playhead += (double)UnityTime.deltaTime * simulation.TimeScale * Speed;
            playhead = PlaybackTime.Wrap(playhead, player.Sequence.Duration, Loop);
            time = (float)playhead;
            if (IsAtEnd) Ended?.Invoke(this);
        }

        private void Show()
        {
            double rate = IsClockTaken ? takenRate : Speed;
            double duration = player.Sequence.Duration, wrapped = PlaybackTime.Wrap(playhead, duration, Loop),
                now = PlaybackTime.Fold(playhead, duration, Loop);
            if (Clock == FluidPlaybackClock.SceneTime) direction = Speed < 0f == wrapped > duration ? 1 : -1;
            else if (now != before) direction = now > before ? 1 : -1;
            bool isJump = seeks || now < before || now - before > Math.Max(LongestStep, MostFrames * UnityTime.deltaTime * Math.Abs(rate));
            player.MoveTo(now, direction, Loop, isJump, waitForFrames || UnityTime.captureDeltaTime > 0f);
            before = now;
            seeks = false;
        }

        private bool IsAtEnd => player != null && Loop == FluidPlaybackLoop.None &&
            (Speed < 0f ? playhead <= 0.0 : playhead >= player.Sequence.Duration);

        private bool IsSeen =>
            LiquidViews.IsSeen(new DrawPlacement(simulation.LocalToWorld, simulation.DomainSize, simulation.Spacing,
                gameObject.layer, true));

        // For checks in the Editor; the folder is looked at again when something in it changed.
        private SequencePlan Preview()
        {
            DateTime written = WrittenAt();
            if (preview.options.Equals(Options) && preview.written == written) return preview.plan;
            SequencePlan plan = SequencePlan.TryMake(Options, this, out FluidMessage? problem);
            Problem = problem;
            preview = (Options, written, plan);
            return plan;
        }

        private DateTime WrittenAt()
        {
            try
            {
                string full = SequenceFolder.FullPath(folder), manifest = Path.Combine(full, SequenceManifest.FileName);
                return File.Exists(manifest) ? File.GetLastWriteTimeUtc(manifest) : Directory.GetLastWriteTimeUtc(full);
            }
            catch (Exception exception) when (exception is ArgumentException || exception is IOException ||
                exception is UnauthorizedAccessException || exception is NotSupportedException)
            {
                return default;
            }
        }
    }
}
