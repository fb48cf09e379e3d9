using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A liquid in a box, or in an open domain, about this transform, which may be moved and turned but has scale 1. Liquid comes
    /// from <see cref="FluidVolume"/> components; colliders in the box are found by layer. Stepped in LateUpdate.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Simulation")]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(50)]
    [ManualPage("getting-started", "choose-the-size")]
    public sealed class FluidSimulation : FluidSimulationSettings
    {
        private static readonly List<FluidSimulation> ActiveList = new List<FluidSimulation>();

        private readonly SceneParts parts = new SceneParts();
        private readonly VolumeWatch volumeWatch = new VolumeWatch();
        private readonly AutomaticMethod automatic = new AutomaticMethod();
        private readonly StepTiming timing = new StepTiming();
        private readonly FrameFeed frames = new FrameFeed();
        private readonly FailedStart failed = new FailedStart();
        private readonly FluidMessageLog messages = new FluidMessageLog();
        private FluidRun run;
        private FluidQueries queries;
        private FluidLiquid given; // by an emitter
        private bool requested;

        /// <summary>Raised after a start or a new start.</summary>
        public event Action<FluidSimulation> Started;

        /// <summary>Raised after a stop; the GPU memory is freed by then.</summary>
        public event Action<FluidSimulation> Stopped;

        /// <summary>
        /// Raised in LateUpdate of every frame in which the liquid runs, after its steps were given to the GPU and before it is drawn: the
        /// place for kernels of yours that read <see cref="TryGetBuffers"/>. Also raised while it is paused or asleep;
        /// <see cref="StepCount"/> tells whether it took steps.
        /// </summary>
        public event Action<FluidSimulation> Updated;

        /// <summary>Raised for each new message, after it was written to the console.</summary>
        public event Action<FluidMessage> Reported;

        /// <summary>
        /// Watches starts that take long, and may end them; null: the Editor's progress bar, in builds nobody. Each play begins with null.
        /// </summary>
        public static IFluidStartWatcher StartWatcher { get; set; }

        /// <summary>Watches where nothing else does.</summary>
        [OutlivesPlay("set once, when the Editor loads")] internal static IFluidStartWatcher EditorWatcher { get; set; }

        /// <summary>Enabled simulations of all loaded scenes, running or not.</summary>
        public static IReadOnlyList<FluidSimulation> Active => ActiveList;

        /// <summary>
        /// The method in use: <see cref="FluidSimulationSettings.Method"/>, or what Automatic has picked. Before the first start with
        /// Automatic it is the first method that runs on this device.
        /// </summary>
        public FluidMethodKind ActiveMethod => OwnSpec.Method;

        /// <summary>
        /// What Automatic has picked, why, and what else it considered; null with another method, and before the first start.
        /// </summary>
        public FluidMethodChoice MethodChoice => FluidMethods.IsChosen(Method) ? automatic.Choice : null;

        /// <inheritdoc/>
        public override FluidLiquid ActiveLiquid => Liquid != null ? Liquid : given;

        /// <summary>The solver; null when stopped. A new start makes a new one.</summary>
        public FluidSolver Solver => run?.Solver;

        /// <summary>Whether the liquid exists.</summary>
        public bool IsRunning => run != null;

        /// <summary>
        /// Whether the liquid is played back by an <see cref="IFluidPlaybackSource"/> and not simulated. Volumes, emitters, drains, force
        /// zones and floating bodies do nothing meanwhile.
        /// </summary>
        public bool IsPlayedBack => run != null && parts.Playback != null;

        /// <summary>
        /// Whether the liquid rests and takes no steps. It wakes in the frame in which a collider in its domain comes, goes, moves or
        /// changes, the transform or a setting changes, or particles are given to the <see cref="Solver"/>. A script that moves particles
        /// on the GPU calls <see cref="Wake"/>.
        /// </summary>
        public bool IsAsleep => run != null && run.IsAsleep;

        /// <summary>Part of the particles that rests and takes no part in the steps, as of some frames ago, 0 to 1.</summary>
        public float AsleepShare => run?.AsleepShare ?? 0f;

        /// <summary>Number of particles, as of a few frames ago where some are emitted or leave; 0 when stopped.</summary>
        public int ParticleCount => (int)(run?.Solver.LiveCount ?? 0);

        /// <summary>
        /// Particles that have left since the start, as of a few frames ago: through an open face (<see cref="FluidBoundaries.Open"/>), by
        /// a drain, or recycled.
        /// </summary>
        public long RemovedParticles => run?.Solver.Counters.Removed ?? 0;

        /// <summary>Time since the start [s], as far as the liquid has come; goes on while it is asleep.</summary>
        public double SimulatedTime => run?.SimulatedTime ?? 0.0;

        /// <summary>Steps since the start; none while the liquid is asleep.</summary>
        public long StepCount => run?.Solver.StepCount ?? 0;

        /// <summary>Time step in use [s], in adaptive mode that of the last frame; 0 when stopped.</summary>
        public float TimeStep => run?.TimeStep ?? 0f;

        /// <summary>Frames since the start that needed more steps than allowed.</summary>
        public long CapHits => run?.CapHits ?? 0;

        /// <summary>Simulated time over real time, smoothed over ten frames; 1 keeps up.</summary>
        public double RealTimeFactor => run?.RealTimeFactor ?? 1.0;

        /// <summary>GPU memory in use by solver, colliders and queries [bytes].</summary>
        public long GpuBytes => (run?.GpuBytes ?? 0) + (queries?.GpuBytes ?? 0);

        /// <summary>Messages since the last start.</summary>
        public IReadOnlyList<FluidMessage> Messages => messages.All;

        /// <summary>The worst of the messages since the last start; empty when there is none.</summary>
        public string StatusMessage => FluidReports.Worst(messages.All);

        /// <summary>Simulation space to world space: this transform's position and rotation.</summary>
        public Matrix4x4 LocalToWorld => DomainSpace.ToWorld(transform.position, transform.rotation);

        /// <summary>What the liquid collides with now, as triangles in simulation space; empty when stopped.</summary>
        public IReadOnlyList<FluidObstacle> Obstacles => run?.Collision.Solids ?? Array.Empty<FluidObstacle>();

        /// <summary>
        /// Most particles that the liquid may have: Max Particles of the profile, or fewer where this device's buffers hold fewer.
        /// </summary>
        public long ParticleLimit => LiquidChecks.MostParticles(Spec, out _);

        /// <summary>Questions to the liquid that are answered without waiting for the GPU.</summary>
        public FluidQueries Queries => queries ??= new FluidQueries(this, Report);

        /// <summary>
        /// Time that the graphics device takes for the steps of a frame [ms]: the mean over the last 60 frames with steps, between
        /// <see cref="BeginTiming"/> and <see cref="EndTiming"/>. 0 before there is one, and where the device reports no times.
        /// </summary>
        public double StepMilliseconds => Timer?.MillisecondsAFrame ?? 0.0;

        /// <summary>
        /// Whether a new start waits, and the liquid meanwhile: while the user drags or types a setting that needs one.
        /// </summary>
        internal bool StartsLater { get; set; }

        /// <summary>GPU time of the steps, between <see cref="BeginTiming"/> and <see cref="EndTiming"/>; else null.</summary>
        internal StepTimer Timer => timing.Timer;

        /// <summary>How much detail the liquid has in this frame.</summary>
        internal FluidDetail Detail => parts.Detail;

        /// <summary>Whether it is recorded or replayed.</summary>
        internal bool IsWatched => frames.IsWatched;

        internal CollisionScene Collision => run?.Collision;

        /// <summary>Watches a start, and may end it.</summary>
        internal StartWatch Watch => (StartWatcher ?? EditorWatcher) is IFluidStartWatcher watcher
            ? new StartWatch(progress => watcher.Continue(this, progress), () => watcher.Ended(this)) : default;

        /// <summary>All that the simulation is to be, as of now.</summary>
        internal FluidSpec Spec
        {
            get
            {
                FluidScene.Gather(this, parts);
                if (frames.IsWatched) parts.Detail = parts.Detail.WithAllMotion;
                // An emitter that is disabled takes nothing away from a running liquid.
                if (run == null || given == null) given = FluidScene.LiquidOf(parts.Emitters) ?? given;
                return OwnSpec;
            }
        }

        private FluidSpec OwnSpec => parts.Playback == null ? automatic.Resolve(parts.AddedTo(SettingsSpec))
            : PlayedLiquid.Of(parts.AddedTo(SettingsSpec), parts.Playback);

        /// <summary>
        /// Begins to time the steps on the graphics device, for two timestamps a frame. Each call needs an <see cref="EndTiming"/>.
        /// </summary>
        public void BeginTiming() => timing.Begin();

        /// <summary>Ends what <see cref="BeginTiming"/> began.</summary>
        /// <exception cref="InvalidOperationException">There were fewer calls of it.</exception>
        public void EndTiming()
        {
            if (!timing.TryEnd(run)) throw new InvalidOperationException($"'{name}' is not timed: each EndTiming ends one BeginTiming.");
        }

        /// <summary>Starts the liquid from its volumes, again if it runs already.</summary>
        /// <returns>Whether it runs; if not, the messages say why.</returns>
        public bool StartSimulation()
        {
            requested = true;
            Release();
            messages.Clear();
            automatic.Forget();
            return Begin(FluidReports.MayStart(this, Report) ? FluidStarter.TryStart(Spec, FluidScene.Volumes(this), Watch, Report) : null);
        }

        /// <summary>Stops the liquid and frees its GPU memory.</summary>
        public void StopSimulation()
        {
            requested = false;
            Release();
        }

        /// <summary>Puts the liquid back to its start; a stopped one starts.</summary>
        /// <returns>Whether it runs.</returns>
        public bool ResetSimulation() => StartSimulation();

        /// <summary>
        /// Writes the running liquid: its particles, its time, what emitters, drains and the bodies in it have under way. Waits for the
        /// GPU. Where the scene's objects are is the game's to save. The liquid goes on as one does that is restored from the save, equal
        /// to the bit on the same device and driver.
        /// </summary>
        /// <param name="stream">Receives the save; about 28 bytes a particle.</param>
        /// <exception cref="ArgumentNullException">There is no stream.</exception>
        /// <exception cref="InvalidOperationException">The liquid does not run, or is played back.</exception>
        public void Save(Stream stream)
        {
            if (stream == null) throw new ArgumentNullException(nameof(stream));
            Stepped("there is nothing to save").Save(Spec, stream);
        }

        /// <summary>
        /// Puts a saved liquid in the place of the present one, running or not. Bring the scene's objects to where they were first.
        /// Whatever is wrong with the save is reported, and the liquid goes on as it was.
        /// </summary>
        /// <param name="stream">At the beginning of what <see cref="Save"/> wrote; read as far as that goes.</param>
        /// <returns>Whether it was restored; if not, the messages say why.</returns>
        /// <exception cref="ArgumentNullException">There is no stream.</exception>
        public bool Restore(Stream stream)
        {
            if (stream == null) throw new ArgumentNullException(nameof(stream));
            List<FluidMessage> before = messages.Clear();
            FluidRun restored = FluidReports.MayStart(this, Report) && FluidReports.MayRestore(Spec, Report)
                ? FluidRestore.TryMake(Spec, stream, Report) : null;
            if (restored == null)
            {
                messages.PutBack(before);
                return false;
            }
            Release();
            requested = true;
            return Begin(restored);
        }

        /// <summary>
        /// A number that two liquids share whose particles, and whose bodies that the liquid moves, are equal to the bit; else hardly ever.
        /// Waits for the GPU; for tools and tests.
        /// </summary>
        /// <returns>FNV-1a, 64 bits, of the particles by number and the bodies.</returns>
        /// <exception cref="InvalidOperationException">The liquid does not run.</exception>
        public ulong ComputeStateHash() => StateHash.Compute(Running("it has no state").Solver);

        /// <summary>Ends the liquid's sleep: it takes steps until it has rested again.</summary>
        public void Wake() => run?.Wake();

        /// <summary>
        /// With the method Automatic: chooses again, by what steps cost in play as far as that was measured. Where another method is
        /// picked, the liquid starts again; else it goes on. A stopped liquid starts.
        /// </summary>
        /// <returns>Whether it runs.</returns>
        /// <exception cref="InvalidOperationException">The method is not Automatic.</exception>
        public bool ChooseMethodAgain()
        {
            if (!FluidMethods.IsChosen(Method))
            {
                throw new InvalidOperationException(
                    $"The method of '{name}' is {Method}: there is nothing to choose. Set Method to Automatic.");
            }
            if (run == null || IsPlayedBack) return StartSimulation();
            automatic.ChooseAgain(Spec, run, true, Report);
            return run.Key.Equals(FluidStartKey.Create(Spec)) || StartSimulation();
        }

        /// <summary>
        /// Adds the liquid of a box to the running liquid, where there is a place for it: not in colliders, and not where liquid is.
        /// </summary>
        /// <param name="centre">World position [m].</param>
        /// <param name="size">Edge lengths [m].</param>
        /// <param name="rotation">World rotation.</param>
        /// <param name="velocity">World velocity [m/s].</param>
        /// <returns>Number of particles that are tried with the next steps; <see cref="FluidCounters.Blocked"/> counts those that find no
        /// place.</returns>
        /// <exception cref="ArgumentException">A number is not finite, or an edge length is not positive.</exception>
        /// <exception cref="InvalidOperationException">The liquid does not run or is played back, or its method has a fixed number of
        /// particles.</exception>
        public int AddLiquid(Vector3 centre, Vector3 size, Quaternion rotation, Vector3 velocity = default)
        {
            Require.Size(size, nameof(size));
            Require.Place(centre, rotation);
            Require.Finite(velocity, nameof(velocity));
            return ExchangingRun().AddLiquid(Spec, Matrix4x4.TRS(centre, rotation, size), velocity);
        }

        /// <summary>
        /// Adds the liquid of a volume to the running liquid, where there is a place for it: not in colliders, and not where liquid is.
        /// </summary>
        /// <param name="volume">A volume, enabled or not. One that is enabled while the liquid runs adds its liquid by itself, unless this
        /// did before.</param>
        /// <returns>Number of particles that are tried with the next steps; <see cref="FluidCounters.Blocked"/> counts those that find no
        /// place.</returns>
        /// <exception cref="ArgumentNullException">There is no volume.</exception>
        /// <exception cref="InvalidOperationException">The liquid does not run or is played back, its method has a fixed number of
        /// particles, or the volume cannot be filled.</exception>
        public int AddLiquid(FluidVolume volume)
        {
            if (volume == null) throw new ArgumentNullException(nameof(volume));
            return volumeWatch.Add(Spec, ExchangingRun(), volume.Spec);
        }

        /// <summary>What a volume is besides what it has filled; null where that is the same, or the liquid does not run.</summary>
        internal FluidMessage? DifferenceOf(FluidVolume volume) => run == null ||
            IsPlayedBack ? null : volumeWatch.Difference(OwnSpec, volume.Spec, volume.isActiveAndEnabled);

        /// <summary>Removes the liquid in a box with the next steps.</summary>
        /// <param name="centre">World position [m].</param>
        /// <param name="size">Edge lengths [m].</param>
        /// <param name="rotation">World rotation.</param>
        /// <exception cref="ArgumentException">A number is not finite, or an edge length is not positive.</exception>
        /// <exception cref="InvalidOperationException">The liquid does not run or is played back, or its method has a fixed number of
        /// particles.</exception>
        public void RemoveLiquid(Vector3 centre, Vector3 size, Quaternion rotation)
        {
            Require.Size(size, nameof(size));
            Require.Place(centre, rotation);
            ExchangingRun().Flows.Remove(DrainZone.Box(OwnSpec.WorldToLocal * Matrix4x4.TRS(centre, rotation, 0.5f * size)));
        }

        /// <summary>Removes the liquid in a sphere with the next steps.</summary>
        /// <param name="centre">World position [m].</param>
        /// <param name="radius">Radius [m].</param>
        /// <exception cref="ArgumentException">A number is not finite, or the radius is not positive.</exception>
        /// <exception cref="InvalidOperationException">The liquid does not run or is played back, or its method has a fixed number of
        /// particles.</exception>
        public void RemoveLiquid(Vector3 centre, float radius)
        {
            Require.Finite(centre, nameof(centre));
            Require.Positive(radius, nameof(radius));
            ExchangingRun().Flows
                .Remove(DrainZone.Capsule(OwnSpec.WorldToLocal * Matrix4x4.TRS(centre, Quaternion.identity, radius * Vector3.one), 0f));
        }

        /// <summary>
        /// Gives the liquid in a sphere a velocity, besides the one that it has, over the next frame with steps; less within a support
        /// radius of the sphere's surface. Force zones, bursts and impulses of a frame are 16 together at most: impulses beyond that are
        /// dropped, after the zones and bursts, and a message says so.
        /// </summary>
        /// <param name="centre">World position [m].</param>
        /// <param name="radius">Radius [m].</param>
        /// <param name="deltaVelocity">The velocity [m/s], world space; those of several calls add up. Where impulses, explosions and
        /// bursts that may reach the same liquid add up to more than a fifth of the speed of sound in a frame, they are weakened to that,
        /// and a message says so once.</param>
        /// <exception cref="ArgumentException">A number is not finite, the radius is not positive, the velocity is more than a fifth of the
        /// speed of sound, or 16 impulses wait already: this one is not taken.</exception>
        /// <exception cref="InvalidOperationException">The liquid does not run or is played back, or its method has no force
        /// zones.</exception>
        public void AddImpulse(Vector3 centre, float radius, Vector3 deltaVelocity) =>
            Push(centre, radius, deltaVelocity, 0f, nameof(deltaVelocity));

        /// <summary>
        /// Drives the liquid in a sphere apart, over the next frame with steps; less within a support radius of the sphere's surface and of
        /// its centre.
        /// </summary>
        /// <param name="centre">World position [m].</param>
        /// <param name="radius">Radius [m].</param>
        /// <param name="speed">Velocity away from the centre, besides the one that the liquid has [m/s]; negative: towards it. It adds up
        /// with others as <see cref="AddImpulse"/> says.</param>
        /// <exception cref="ArgumentException">A number is not finite, the radius is not positive, the speed is more than a fifth of the
        /// speed of sound, or 16 impulses wait already: this one is not taken.</exception>
        /// <exception cref="InvalidOperationException">The liquid does not run or is played back, or its method has no force
        /// zones.</exception>
        public void AddExplosion(Vector3 centre, float radius, float speed) => Push(centre, radius, Vector3.zero, speed, nameof(speed));

        /// <summary>
        /// Pauses the liquid and takes one step of <see cref="TimeStep"/> in the next LateUpdate, whatever Time.timeScale and
        /// <see cref="FluidSimulationSettings.TimeScale"/> are; two calls take two. Liquid that is asleep wakes. Stopped, or when
        /// <see cref="FluidSimulationSettings.Paused"/> is set to false before, no step is taken.
        /// </summary>
        public void StepOnce()
        {
            Paused = true;
            if (run != null) frames.AddStep();
        }

        /// <summary>Reads all collision meshes again, after an edit that left a mesh's counts and bounds as they were.</summary>
        public void RefreshColliders() => run?.InvalidateColliders();

        /// <summary>
        /// Checks the settings, the liquid and the colliders, of a prefab asset only the settings; changes nothing and logs nothing.
        /// </summary>
        /// <returns>What is wrong or worth knowing, errors first.</returns>
        public IReadOnlyList<FluidMessage> Validate() => FluidChecks.Preview(Spec, FluidScene.Volumes(this), out FluidSolverSettings? _);

        /// <summary>
        /// The liquid on the GPU, for kernels and shaders of yours: as of its last steps, until its next LateUpdate. Ask each frame.
        /// </summary>
        /// <param name="buffers">The buffers, to be read only; none where the liquid does not run.</param>
        /// <returns>False while the liquid does not run; <see cref="StatusMessage"/> says why.</returns>
        public bool TryGetBuffers(out FluidBuffers buffers)
        {
            if (IsPlayedBack) run.Prepare();
            buffers = run == null ? default : new FluidBuffers(run.Solver, LocalToWorld);
            return run != null;
        }

        /// <summary>
        /// Waits for the GPU and reads the particles, in simulation space, sorted by cell, without those that left the domain; for tools
        /// and tests.
        /// </summary>
        /// <param name="particles">Receives the particles.</param>
        /// <returns>False when stopped.</returns>
        public bool TryReadParticles(List<FluidParticle> particles)
        {
            if (IsPlayedBack) run.Prepare();
            return FluidReports.TryReadParticles(Solver, particles);
        }

        /// <summary>Spacing at which the liquid volumes hold as near to a number of particles as the lattice allows [m].</summary>
        /// <param name="count">Requested number of particles, 1 or more.</param>
        /// <returns>The spacing; <see cref="FluidSimulationSettings.Spacing"/> is not changed.</returns>
        /// <exception cref="InvalidOperationException">There is no liquid to measure, or this is a prefab asset, which has none around
        /// it.</exception>
        public float SpacingForParticleCount(int count) => ParticleCountFit.Spacing(Spec, FluidScene.Volumes(this), count);

        /// <summary>Lets a recording or a replay see what the liquid is given in each frame.</summary>
        /// <exception cref="InvalidOperationException">Another does already.</exception>
        internal void Attach(IFluidFrames watcher) => frames.Attach(watcher, name);

        /// <summary>Ends that.</summary>
        internal void Detach(IFluidFrames watcher) => frames.Detach(watcher);

        internal void Report(FluidMessage message)
        {
            if (messages.TryAdd(message)) Reported?.Invoke(message);
        }

        private void OnEnable()
        {
            ActiveList.Add(this);
            requested = PlayOnEnable;
            failed.Forget();
        }

        private void OnDisable()
        {
            ActiveList.Remove(this);
            Release();
            given = null;
        }

        private void OnDestroy()
        {
            queries?.Dispose();
            timing.Dispose();
        }

        private void FixedUpdate()
        {
            if (run != null && run.MovesBodies) run.FixedUpdate(transform.position, transform.rotation, Time.fixedDeltaTime);
        }

        private void LateUpdate()
        {
            if (!requested) return;
            if (run != null && Profile != null) automatic.Update(Spec, run, Report);
            FluidSpec spec = Spec;
            if (run == null || !run.Key.Equals(FluidStartKey.Create(spec)))
            {
                if (run != null && StartsLater) return;
                if (!failed.IsUnchanged(spec, Sources())) StartSimulation();
                if (!IsPlayedBack) return; // what is played is there at once
            }
            run.Timer = Timer;
            FluidScene.Own(this, parts.Volumes);
            if (!IsPlayedBack) volumeWatch.Update(spec, run, parts.Volumes, Report);
            Advance(spec);
        }

        private void Advance(in FluidSpec spec)
        {
            long steps = StepCount, capped = CapHits;
            if (frames.TryAdvance(run, spec, Paused || spec.Detail.Paused, TimeScale, Report, out FluidMessage failure))
            {
                FluidProfiler.AddLiquid(run.Solver.LiveCount, StepCount - steps, CapHits - capped, GpuBytes);
                timing.LookAtCosts(run, automatic.Choice, this, Report);
                queries?.Ask(run.Solver, spec.Profile.Shaders, run.SimulatedTime, spec.Position, spec.Rotation);
                Updated?.Invoke(this);
                return;
            }
            foreach (FluidMessage message in FluidReports.ErrorsOf(Validate(), failure)) Report(message);
            Release();
            failed.Remember(Spec, Sources());
        }

        private int Sources()
        {
            FluidScene.Own(this, parts.Volumes);
            return parts.Sources;
        }

        // Null: it did not start.
        private bool Begin(FluidRun started)
        {
            run = started;
            if (run != null) automatic.Accept(run.Start.Choice, Spec);
            if (run?.Start.Choice != null) timing.BeginCosts();
            volumeWatch.Begin(OwnSpec, FluidScene.Volumes(this));
            if (run == null) failed.Remember(Spec, Sources());
            else failed.Forget();
            if (run != null) Started?.Invoke(this);
            return run != null;
        }

        private void Push(Vector3 centre, float radius, Vector3 velocity, float outward, string argument)
        {
            Require.Finite(centre, nameof(centre));
            Require.Positive(radius, nameof(radius));
            Require.Finite(velocity + outward * Vector3.one, argument);
            FluidRun pushed = Stepped("it cannot be pushed", FluidMethodFeatures.ForceZones, "no force zones or impulses");
            pushed.Zones.Push(new ZonePush(centre, radius, velocity, outward), name, argument);
        }

        private FluidRun ExchangingRun() =>
            Stepped("no liquid can be added or removed", FluidMethodFeatures.ChangingCount, "a fixed number of particles");

        private FluidRun Stepped(string consequence, FluidMethodFeatures features = FluidMethodFeatures.None, string has = "")
        {
            Running(consequence);
            if (IsPlayedBack)
            {
                throw new InvalidOperationException(
                    $"'{name}' is played back, so {consequence}. Disable the component that plays it first.");
            }
            if (features != FluidMethodFeatures.None && !FluidMethods.Has(ActiveMethod, features))
            {
                throw new InvalidOperationException(
                    $"The method {ActiveMethod} of '{name}' has {has}. Set Method to Standard or Robust.");
            }
            return run;
        }

        private FluidRun Running(string consequence) =>
            run ?? throw new InvalidOperationException($"'{name}' does not run, so {consequence}.");

        private void Release()
        {
            if (run == null) return;
            queries?.Detach();
            timing.EndCosts(run);
            run.Dispose();
            run = null;
            frames.Forget();
            Stopped?.Invoke(this);
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        internal static void ResetStatics()
        {
            ActiveList.Clear();
            StartWatcher = null;
        }
    }
}
