using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A liquid in a box. The box is centred on this transform, which may be moved and turned but has scale 1. Liquid comes
    /// from <see cref="FluidVolume"/> components; colliders in the box are found by layer. Stepped in LateUpdate.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Simulation")]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(50)]
    [ManualPage("getting-started", "choose-the-size")]
    public sealed class FluidSimulation : MonoBehaviour
    {
        static readonly List<FluidSimulation> ActiveList = new List<FluidSimulation>();

        [SerializeField, Tooltip("What the liquid is: constants and shaders.")]
        FluidProfile profile;

        [Header("Domain")]
        [SerializeField, Tooltip("Edge lengths of the box that holds the liquid, in metres. A change starts the liquid again.")]
        Vector3 domainSize = new Vector3(1f, 1f, 1f);

        [SerializeField, Min(0f), Tooltip("Distance of neighbouring particles at rest in metres. Half of it means 8 times as many particles " +
            "and twice as many steps. A change starts the liquid again.")]
        float particleSpacing = 0.025f;

        [SerializeField, Tooltip("How the motion is computed: Standard; Robust, softer, by a fixed number of steps a frame; the thesis's method to compare with; or Automatic, " +
            "which picks one at the start that fits the Frame Budget on this device. A change starts the liquid again.")]
        FluidMethodKind method = FluidMethodKind.Standard;

        [SerializeField, Min(0f), Tooltip("Time that this liquid's steps may take of a frame on the graphics device in milliseconds, with the method Automatic. In play a change " +
            "chooses again, and another method starts the liquid again.")]
        float frameBudget = 4f;

        [SerializeField, Min(0f), Tooltip("Frames a second that the Frame Budget is for. 0: the application's target frame rate, or 60 where it sets none.")]
        float budgetFrameRate;

        [SerializeField, Tooltip("Layers whose colliders the liquid collides with.")]
        LayerMask colliderLayers = ~0;

        [Header("Time")]
        [SerializeField, Tooltip("Automatic: the time step follows from spacing, stiffness and viscosity. Fixed: as given. " +
            "Adaptive: equal parts of each frame, shorter when the liquid is faster than expected.")]
        FluidTimeStepMode timeStepMode = FluidTimeStepMode.Automatic;

        [SerializeField, Min(0f), Tooltip("Time step in seconds when Time Step Mode is Fixed.")]
        float fixedTimeStep = 0.0005f;

        [SerializeField, Tooltip("Liquid that rests takes no steps until something touches it: a collider that moves, a changed setting, a script.")]
        bool sleepsAtRest = true;

        [SerializeField, Tooltip("The liquid stands still and is drawn on. Colliders that move meanwhile go through their motion with the first step after it.")]
        bool paused;

        [SerializeField, Min(0f), Tooltip("Time of this liquid over the scene's time: 1 as fast as the scene, 0.5 half as fast, 0 stands still. Time.timeScale acts besides.")]
        float timeScale = 1f;

        [SerializeField, Range(1, 1000), Tooltip("Most steps a frame. Where more are needed the liquid moves slower than time, and the console says so.")]
        int maxSubstepsPerFrame = 64;

        [SerializeField, Min(0f), Tooltip("Fastest speed to be ready for in m/s, when moving colliders or forces make the liquid faster than " +
            "its fall. 0: the fall decides.")]
        float expectedSpeed;

        [Header("Gravity")]
        [SerializeField, Tooltip("Take gravity from Physics.gravity.")]
        bool useSceneGravity = true;

        [SerializeField, Tooltip("Gravity in m/s² in world space when Use Scene Gravity is off.")]
        Vector3 gravity = new Vector3(0f, -9.81f, 0f);

        [SerializeField, Tooltip("A force by position besides gravity, along the axes of the domain box.")]
        FluidBodyForce bodyForce;

        [Header("Faces")]
        [SerializeField, Tooltip("What the faces of the domain box do: walls at rest, moving walls that drag, openings into the opposite face, or openings through which liquid leaves.")]
        FluidBoundaries boundaries;

        [Header("Start")]
        [SerializeField, Tooltip("Start with the scene or when the component is enabled.")]
        bool playOnEnable = true;

        [SerializeField, Tooltip("Seed of the random offsets at the start. The same seed gives the same start. A change starts the liquid again.")]
        int seed = 1;

        [SerializeField, Range(0f, FluidSpawner.MaxJitter), Tooltip("Largest random offset of a particle at the start as a fraction of the spacing. A change starts the liquid again.")]
        float startJitter = 0.02f;

        [SerializeField, Tooltip("How the liquid is brought to rest before the first frame. Packed: without gravity, particles part that lie too near to " +
            "each other or to walls. Hydrostatic: under gravity. Takes hundreds to thousands of steps at the start, without Start Jitter; method Standard only. A change starts the liquid again.")]
        FluidStartRelaxation startRelaxation;

        [Header("Particles that come and go")]
        [SerializeField, Tooltip("What happens when emitters give more particles than there are slots for. Grow: twice as many slots, up to Max Particles of " +
            "the profile. Fixed: as many as Capacity from the start, and no more come in. Recycle Oldest: the oldest leave.")]
        FluidCapacityPolicy capacityPolicy;

        [SerializeField, Min(0), Tooltip("Particles that Fixed and Recycle Oldest hold. 0: Max Particles of the profile.")]
        int capacity;

        readonly List<EmitterSpec> emitters = new List<EmitterSpec>();
        readonly List<DrainSpec> drains = new List<DrainSpec>();
        readonly List<ZoneSpec> zones = new List<ZoneSpec>();
        readonly List<WallSpec> walls = new List<WallSpec>();
        readonly List<VolumeSpec> volumes = new List<VolumeSpec>();
        readonly VolumeWatch volumeWatch = new VolumeWatch();
        readonly AutomaticMethod automatic = new AutomaticMethod();
        readonly StepCostWatch costs = new StepCostWatch();
        FluidRun run;
        FluidQueries queries;
        IFluidFrames frames;
        bool requested;
        int singleSteps, failedSources, timings;
        (FluidStartKey, FluidLiveKey)? failed;
        readonly List<FluidMessage> messages = new List<FluidMessage>();

        /// <summary>Raised after a start or a new start.</summary>
        public event Action<FluidSimulation> Started;

        /// <summary>Raised after a stop; the GPU memory is freed by then.</summary>
        public event Action<FluidSimulation> Stopped;

        /// <summary>
        /// Raised in LateUpdate of every frame in which the liquid runs, after its steps were given to the GPU and before it is drawn: the place for kernels of
        /// yours that read <see cref="TryGetBuffers"/>. Also raised while it is paused or asleep; <see cref="StepCount"/> tells whether it took steps.
        /// </summary>
        public event Action<FluidSimulation> Updated;

        /// <summary>Raised for each new message, after it was written to the console.</summary>
        public event Action<FluidMessage> Reported;

        /// <summary>Watches starts that take long, and may end them; null: nobody does.</summary>
        public static IFluidStartWatcher StartWatcher { get; set; }

        /// <summary>Enabled simulations of all loaded scenes, running or not.</summary>
        public static IReadOnlyList<FluidSimulation> Active => ActiveList;

        /// <summary>What the liquid is.</summary>
        public FluidProfile Profile { get => profile; set => profile = value; }

        /// <summary>Edge lengths of the box in this transform's space [m].</summary>
        public Vector3 DomainSize { get => domainSize; set => domainSize = value; }

        /// <summary>Particle spacing dx [m].</summary>
        public float Spacing { get => particleSpacing; set => particleSpacing = value; }

        /// <summary>How the motion is computed.</summary>
        public FluidMethodKind Method { get => method; set => method = value; }

        /// <summary>
        /// The method in use: <see cref="Method"/>, or what Automatic has picked. Before the first start with Automatic it is the first method that runs on this
        /// device.
        /// </summary>
        public FluidMethodKind ActiveMethod => OwnSpec.Method;

        /// <summary>What Automatic has picked, why, and what else it considered; null with another method, and before the first start.</summary>
        public FluidMethodChoice MethodChoice => FluidMethods.IsChosen(method) ? automatic.Choice : null;

        /// <summary>Time that this liquid's steps may take of a frame on the graphics device [ms], greater than 0; with the method Automatic.</summary>
        public float FrameBudget { get => frameBudget; set => frameBudget = value; }

        /// <summary>Frames a second that <see cref="FrameBudget"/> is for; 0: those of Application.targetFrameRate or Time.captureDeltaTime, or 60 where neither is set.</summary>
        public float BudgetFrameRate { get => budgetFrameRate; set => budgetFrameRate = value; }

        /// <summary>Layers whose colliders count.</summary>
        public LayerMask ColliderLayers { get => colliderLayers; set => colliderLayers = value; }

        /// <summary>Where the time step comes from.</summary>
        public FluidTimeStepMode TimeStepMode { get => timeStepMode; set => timeStepMode = value; }

        /// <summary>Time step in fixed mode [s].</summary>
        public float FixedTimeStep { get => fixedTimeStep; set => fixedTimeStep = value; }

        /// <summary>
        /// Whether the liquid stands still: it keeps its state, is drawn on and takes no steps but those of <see cref="StepOnce"/>. No time is made up
        /// for afterwards. Changed settings act with the next step. The motion of colliders during the pause joins into one that the next frame with
        /// steps goes through; one too long to follow is a jump, reported as <see cref="FluidIssue.ColliderJumped"/>.
        /// </summary>
        public bool Paused { get => paused; set => paused = value; }

        /// <summary>
        /// Time of this liquid over Unity's scaled time, 0 or more; 1 by default. Time.timeScale acts besides. Faster than the liquid can be computed
        /// it moves as fast as <see cref="MaxSubstepsPerFrame"/> allows. Below 0 or not finite it is reported, and the liquid stands still.
        /// </summary>
        public float TimeScale { get => timeScale; set => timeScale = value; }

        /// <summary>Most steps a frame, at least 1.</summary>
        public int MaxSubstepsPerFrame { get => Mathf.Max(1, maxSubstepsPerFrame); set => maxSubstepsPerFrame = value; }

        /// <summary>Whether liquid that rests takes no steps until something touches it; see <see cref="IsAsleep"/>.</summary>
        public bool SleepsAtRest { get => sleepsAtRest; set => sleepsAtRest = value; }

        /// <summary>Fastest speed to be ready for beyond the fall's [m/s]; 0: the fall decides.</summary>
        public float ExpectedSpeed { get => expectedSpeed; set => expectedSpeed = value; }

        /// <summary>Whether Physics.gravity acts instead of <see cref="Gravity"/>.</summary>
        public bool UseSceneGravity { get => useSceneGravity; set => useSceneGravity = value; }

        /// <summary>Own gravity in world space [m/s²].</summary>
        public Vector3 Gravity { get => gravity; set => gravity = value; }

        /// <summary>Force by position besides gravity, along the axes of the domain box.</summary>
        public FluidBodyForce BodyForce { get => bodyForce; set => bodyForce = value; }

        /// <summary>What the faces of the domain box do. Other periodic axes start the liquid again; all else acts at once.</summary>
        public FluidBoundaries Boundaries { get => boundaries; set => boundaries = value; }

        /// <summary>
        /// Velocity [m/s] by position [m] that each particle starts with besides its volume's, both in simulation space; null: none.
        /// From code only. Another function starts the liquid again.
        /// </summary>
        public Func<Vector3, Vector3> VelocityField { get; set; }

        /// <summary>Whether the simulation starts when it is enabled.</summary>
        public bool PlayOnEnable { get => playOnEnable; set => playOnEnable = value; }

        /// <summary>Seed of the random offsets at the start.</summary>
        public int Seed { get => seed; set => seed = value; }

        /// <summary>Largest random offset at the start over the spacing, 0 to 0.2.</summary>
        public float StartJitter { get => startJitter; set => startJitter = value; }

        /// <summary>How the liquid is brought to rest before the first frame. Standard method only; its step count is among the messages.</summary>
        public FluidStartRelaxation StartRelaxation { get => startRelaxation; set => startRelaxation = value; }

        /// <summary>What happens when emitters give more particles than there are slots for.</summary>
        public FluidCapacityPolicy CapacityPolicy { get => capacityPolicy; set => capacityPolicy = value; }

        /// <summary>Particles that the policies Fixed and RecycleOldest hold; 0: as many as the profile allows.</summary>
        public int Capacity { get => capacity; set => capacity = value; }

        /// <summary>The solver; null when stopped. A new start makes a new one.</summary>
        public FluidSolver Solver => run?.Solver;

        /// <summary>Whether the liquid exists.</summary>
        public bool IsRunning => run != null;

        /// <summary>
        /// Whether the liquid rests and takes no steps. It wakes in the frame in which a collider in its domain comes, goes, moves or changes, the
        /// transform or a setting changes, or particles are given to the <see cref="Solver"/>. A script that moves particles on the GPU calls <see cref="Wake"/>.
        /// </summary>
        public bool IsAsleep => run != null && run.IsAsleep;

        /// <summary>Number of particles, as of a few frames ago where some are emitted or leave; 0 when stopped.</summary>
        public int ParticleCount => (int)(run?.Solver.LiveCount ?? 0);

        /// <summary>Particles that have left since the start, as of a few frames ago: through an open face (<see cref="FluidBoundaries.Open"/>), by a drain, or recycled.</summary>
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
        public IReadOnlyList<FluidMessage> Messages => messages;

        /// <summary>The worst of the messages since the last start; empty when there is none.</summary>
        public string StatusMessage => FluidReports.Worst(messages);

        /// <summary>Simulation space to world space: this transform's position and rotation.</summary>
        public Matrix4x4 LocalToWorld => DomainSpace.ToWorld(transform.position, transform.rotation);

        /// <summary>Gravity that acts, in world space [m/s²].</summary>
        public Vector3 EffectiveGravity => useSceneGravity ? Physics.gravity : gravity;

        /// <summary>All that the simulation is to be, as of now.</summary>
        internal FluidSpec Spec
        {
            get
            {
                FluidScene.Own(this, emitters);
                FluidScene.Own(this, drains);
                FluidScene.Shared(this, zones);
                FluidScene.Shared(this, walls);
                return OwnSpec;
            }
        }

        FluidSpec OwnSpec
        {
            get
            {
                FluidSpec spec = SpecAsSet;
                if (FluidMethods.IsChosen(method)) spec.Automatic = new AutomaticSpec(frameBudget, FrameRate, spec.Profile.Rules, spec.MaxSubstepsPerFrame);
                return automatic.Resolve(spec);
            }
        }

        // What is typed, or the frames that the program makes.
        double FrameRate => budgetFrameRate != 0f ? budgetFrameRate : Time.captureDeltaTime > 0f ? Math.Round(1.0 / Time.captureDeltaTime, 3)
            : Application.targetFrameRate > 0 ? Application.targetFrameRate : AutomaticSpec.UsualFrameRate;

        FluidSpec SpecAsSet => new FluidSpec
        {
            CapacityPolicy = capacityPolicy,
            Capacity = capacity,
            Emitters = emitters,
            Drains = drains,
            Zones = zones,
            Walls = walls,
            Owner = this,
            Position = transform.position,
            Rotation = transform.rotation,
            Scale = transform.lossyScale,
            Profile = profile != null ? profile.Spec : default,
            DomainSize = domainSize,
            Spacing = particleSpacing,
            Method = method,
            ColliderLayers = colliderLayers,
            TimeStepMode = timeStepMode,
            FixedTimeStep = fixedTimeStep,
            MaxSubstepsPerFrame = MaxSubstepsPerFrame,
            ExpectedSpeed = expectedSpeed,
            SleepsAtRest = sleepsAtRest,
            Gravity = EffectiveGravity,
            BodyForce = bodyForce,
            Boundaries = boundaries,
            VelocityField = VelocityField,
            Seed = seed,
            StartJitter = startJitter,
            StartRelaxation = startRelaxation,
        };

        /// <summary>What the liquid collides with now, as triangles in simulation space; empty when stopped.</summary>
        public IReadOnlyList<FluidObstacle> Obstacles => run?.Collision.Solids ?? Array.Empty<FluidObstacle>();

        /// <summary>Most particles that the liquid may have: Max Particles of the profile, or fewer where this device's buffers hold fewer.</summary>
        public long ParticleLimit => LiquidChecks.MostParticles(Spec, out _);

        /// <summary>Questions to the liquid that are answered without waiting for the GPU.</summary>
        public FluidQueries Queries => queries ??= new FluidQueries(this, Report);

        /// <summary>Lets a recording or a replay see what the liquid is given in each frame.</summary>
        /// <exception cref="InvalidOperationException">Another does already.</exception>
        internal void Attach(IFluidFrames watcher)
        {
            if (frames != null) throw new InvalidOperationException($"'{name}' is recorded or replayed already. Dispose of that one first.");
            frames = watcher;
        }

        /// <summary>Ends that.</summary>
        internal void Detach(IFluidFrames watcher)
        {
            if (frames == watcher) frames = null;
        }

        internal CollisionScene Collision => run?.Collision;

        /// <summary>GPU time of the steps, between <see cref="BeginTiming"/> and <see cref="EndTiming"/>; else null.</summary>
        internal StepTimer Timer { get; private set; }

        /// <summary>
        /// Time that the graphics device takes for the steps of a frame [ms]: the mean over the last 60 frames with steps, between <see cref="BeginTiming"/> and
        /// <see cref="EndTiming"/>. 0 before there is one, and where the device reports no times.
        /// </summary>
        public double StepMilliseconds => Timer?.MillisecondsAFrame ?? 0.0;

        /// <summary>Begins to time the steps on the graphics device, for two timestamps a frame. Each call needs an <see cref="EndTiming"/>.</summary>
        public void BeginTiming()
        {
            if (timings++ == 0) Timer = new StepTimer();
        }

        /// <summary>Ends what <see cref="BeginTiming"/> began.</summary>
        /// <exception cref="InvalidOperationException">There were fewer calls of it.</exception>
        public void EndTiming()
        {
            if (timings == 0) throw new InvalidOperationException($"'{name}' is not timed: each EndTiming ends one BeginTiming.");
            if (--timings > 0) return;
            if (run != null) run.Timer = null;
            Timer?.Dispose();
            Timer = null;
        }

        /// <summary>Starts the liquid from its volumes, again if it runs already.</summary>
        /// <returns>Whether it runs; if not, the messages say why.</returns>
        public bool StartSimulation()
        {
            requested = true;
            Release();
            messages.Clear();
            automatic.Forget();
            if (FluidReports.NotPlaying(this) is FluidMessage obstacle) Report(obstacle);
            else run = FluidStarter.TryStart(Spec, FluidScene.Volumes(this), Watch, Report);
            if (run != null) TakeChoice();
            volumeWatch.Begin(OwnSpec, FluidScene.Volumes(this));
            failed = null;
            if (run == null) Fail();
            if (run != null) Started?.Invoke(this);
            return run != null;
        }

        // What its steps cost in play is better known than what they cost at the start.
        void TakeChoice()
        {
            automatic.Take(run.Start.Choice, Spec);
            if (run.Start.Choice == null || !StepTimer.IsSupported) return;
            BeginTiming();
            costs.Begin();
        }

        void EndCosts()
        {
            if (!costs.IsUnderWay) return;
            costs.End();
            EndTiming();
        }

        void LookAtCosts()
        {
            if (!costs.IsUnderWay) return;
            if (costs.Look(Timer, run, automatic.Choice, this) is FluidMessage message) Report(message);
            if (!costs.IsUnderWay) EndTiming();
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
        /// Writes the running liquid: its particles, its time, what emitters, drains and the bodies in it have under way. Waits for the GPU. Where the scene's
        /// objects are is the game's to save. The liquid goes on as one does that is restored from the save, equal to the bit on the same device and driver.
        /// </summary>
        /// <param name="stream">Receives the save; about 28 bytes a particle.</param>
        /// <exception cref="ArgumentNullException">There is no stream.</exception>
        /// <exception cref="InvalidOperationException">The liquid does not run.</exception>
        public void Save(Stream stream)
        {
            if (stream == null) throw new ArgumentNullException(nameof(stream));
            Running(true, "there is nothing to save", "").Save(Spec, stream);
        }

        /// <summary>
        /// Puts a saved liquid in the place of the present one, running or not. Bring the scene's objects to where they were first. Whatever is wrong with the
        /// save is reported, and the liquid goes on as it was.
        /// </summary>
        /// <param name="stream">At the beginning of what <see cref="Save"/> wrote; read as far as that goes.</param>
        /// <returns>Whether it was restored; if not, the messages say why.</returns>
        /// <exception cref="ArgumentNullException">There is no stream.</exception>
        public bool Restore(Stream stream)
        {
            if (stream == null) throw new ArgumentNullException(nameof(stream));
            List<FluidMessage> before = messages.GetRange(0, messages.Count);
            messages.Clear();
            FluidRun restored = null;
            if (FluidReports.NotPlaying(this) is FluidMessage obstacle) Report(obstacle);
            else restored = FluidRestore.TryMake(Spec, stream, Report);
            if (restored == null)
            {
                messages.InsertRange(0, before.FindAll(m => !messages.Contains(m)));
                return false;
            }
            Release();
            run = restored;
            TakeChoice();
            volumeWatch.Begin(OwnSpec, FluidScene.Volumes(this));
            requested = true;
            failed = null;
            Started?.Invoke(this);
            return true;
        }

        /// <summary>
        /// A number that two liquids share whose particles, and whose bodies that the liquid moves, are equal to the bit; else hardly ever. Waits for the GPU; for
        /// tools and tests.
        /// </summary>
        /// <returns>FNV-1a, 64 bits, of the particles by number and the bodies.</returns>
        /// <exception cref="InvalidOperationException">The liquid does not run.</exception>
        public ulong ComputeStateHash() => StateHash.Of(Running(true, "it has no state", "").Solver);

        /// <summary>Ends the liquid's sleep: it takes steps until it has rested again.</summary>
        public void Wake() => run?.Wake();

        /// <summary>
        /// With the method Automatic: chooses again, by what steps cost in play as far as that was measured. Where another method is picked, the liquid starts
        /// again; else it goes on. A stopped liquid starts.
        /// </summary>
        /// <returns>Whether it runs.</returns>
        /// <exception cref="InvalidOperationException">The method is not Automatic.</exception>
        public bool ChooseMethodAgain()
        {
            if (!FluidMethods.IsChosen(method)) throw new InvalidOperationException($"The method of '{name}' is {method}: there is nothing to choose. Set Method to Automatic.");
            if (run == null) return StartSimulation();
            automatic.ChooseAgain(Spec, run, true, Report);
            return run.Key.Equals(FluidStartKey.Of(Spec)) || StartSimulation();
        }

        /// <summary>Adds the liquid of a box to the running liquid, where there is a place for it: not in colliders, and not where liquid is.</summary>
        /// <param name="centre">World position [m].</param>
        /// <param name="size">Edge lengths [m].</param>
        /// <param name="rotation">World rotation.</param>
        /// <param name="velocity">World velocity [m/s].</param>
        /// <returns>Number of particles that are tried with the next steps; <see cref="FluidCounters.Blocked"/> counts those that find no place.</returns>
        /// <exception cref="InvalidOperationException">The liquid does not run, or its method has a fixed number of particles.</exception>
        public int AddLiquid(Vector3 centre, Vector3 size, Quaternion rotation, Vector3 velocity = default)
        {
            FluidRun running = ExchangingRun();
            FluidSpec spec = Spec;
            Matrix4x4 toLocal = spec.WorldToLocal;
            return running.AddLiquid(spec, new LiquidBox("Added liquid", toLocal * Matrix4x4.TRS(centre, rotation, size), toLocal.MultiplyVector(velocity)));
        }

        /// <summary>Adds the liquid of a volume to the running liquid, where there is a place for it: not in colliders, and not where liquid is.</summary>
        /// <param name="volume">A volume, enabled or not. One that is enabled while the liquid runs adds its liquid by itself, unless this did before.</param>
        /// <returns>Number of particles that are tried with the next steps; <see cref="FluidCounters.Blocked"/> counts those that find no place.</returns>
        /// <exception cref="ArgumentNullException">There is no volume.</exception>
        /// <exception cref="InvalidOperationException">The liquid does not run, its method has a fixed number of particles, or the volume cannot be filled.</exception>
        public int AddLiquid(FluidVolume volume)
        {
            if (volume == null) throw new ArgumentNullException(nameof(volume));
            FluidRun running = ExchangingRun();
            var found = new List<FluidMessage>();
            FluidSpec spec = Spec;
            LiquidShape shape = VolumeChecks.Check(volume.Spec, spec, running.Collision, found);
            if (shape == null) throw new InvalidOperationException(FluidReports.Worst(found));
            volumeWatch.Note(spec, volume.Spec);
            return running.AddLiquid(spec, shape);
        }

        /// <summary>What a volume is besides what it has filled; null where that is the same, or the liquid does not run.</summary>
        internal FluidMessage? DifferenceOf(FluidVolume volume) => run == null ? null : volumeWatch.Difference(OwnSpec, volume.Spec, volume.isActiveAndEnabled);

        /// <summary>Removes the liquid in a box with the next steps.</summary>
        /// <param name="centre">World position [m].</param>
        /// <param name="size">Edge lengths [m].</param>
        /// <param name="rotation">World rotation.</param>
        /// <exception cref="InvalidOperationException">The liquid does not run, or its method has a fixed number of particles.</exception>
        public void RemoveLiquid(Vector3 centre, Vector3 size, Quaternion rotation) =>
            ExchangingRun().Flows.Remove(DrainZone.Box(OwnSpec.WorldToLocal * Matrix4x4.TRS(centre, rotation, 0.5f * size)));

        /// <summary>Removes the liquid in a sphere with the next steps.</summary>
        /// <param name="centre">World position [m].</param>
        /// <param name="radius">Radius [m].</param>
        /// <exception cref="InvalidOperationException">The liquid does not run, or its method has a fixed number of particles.</exception>
        public void RemoveLiquid(Vector3 centre, float radius) =>
            ExchangingRun().Flows.Remove(DrainZone.Capsule(OwnSpec.WorldToLocal * Matrix4x4.TRS(centre, Quaternion.identity, radius * Vector3.one), 0f));

        /// <summary>
        /// Gives the liquid in a sphere a velocity, besides the one that it has, over the next frame with steps; less within a support radius of the sphere's surface.
        /// Force zones, bursts and impulses of a frame are 16 together at most: impulses beyond that are dropped, after the zones and bursts, and a message says so.
        /// </summary>
        /// <param name="centre">World position [m].</param>
        /// <param name="radius">Radius [m].</param>
        /// <param name="deltaVelocity">The velocity [m/s], world space; those of several calls add up. Where impulses, explosions and bursts that may reach the same
        /// liquid add up to more than a fifth of the speed of sound in a frame, they are weakened to that, and a message says so once.</param>
        /// <exception cref="ArgumentException">A number is not finite, the radius is not positive, the velocity is more than a fifth of the speed of sound, or 16 impulses wait already: this one is not taken.</exception>
        /// <exception cref="InvalidOperationException">The liquid does not run, or its method has no force zones.</exception>
        public void AddImpulse(Vector3 centre, float radius, Vector3 deltaVelocity) => PushedRun().Zones.Push(new ZonePush(centre, radius, deltaVelocity), name);

        /// <summary>Drives the liquid in a sphere apart, over the next frame with steps; less within a support radius of the sphere's surface and of its centre.</summary>
        /// <param name="centre">World position [m].</param>
        /// <param name="radius">Radius [m].</param>
        /// <param name="speed">Velocity away from the centre, besides the one that the liquid has [m/s]; negative: towards it. It adds up with others as <see cref="AddImpulse"/> says.</param>
        /// <exception cref="ArgumentException">A number is not finite, the radius is not positive, the speed is more than a fifth of the speed of sound, or 16 impulses wait already: this one is not taken.</exception>
        /// <exception cref="InvalidOperationException">The liquid does not run, or its method has no force zones.</exception>
        public void AddExplosion(Vector3 centre, float radius, float speed) => PushedRun().Zones.Push(new ZonePush(centre, radius, speed), name);

        FluidRun PushedRun() => Running(FluidMethods.Has(ActiveMethod, FluidMethodFeatures.ForceZones), "it cannot be pushed", "no force zones or impulses");

        FluidRun ExchangingRun() => Running(run != null && run.Solver.Exchanges, "no liquid can be added or removed", "a fixed number of particles");

        FluidRun Running(bool serves, string consequence, string has)
        {
            if (run == null) throw new InvalidOperationException($"'{name}' does not run, so {consequence}.");
            if (!serves) throw new InvalidOperationException($"The method {ActiveMethod} of '{name}' has {has}. Set Method to Standard.");
            return run;
        }

        /// <summary>
        /// Pauses the liquid and takes one step of <see cref="TimeStep"/> in the next LateUpdate, whatever Time.timeScale and <see cref="TimeScale"/> are; two
        /// calls take two. Liquid that is asleep wakes. Stopped, or when <see cref="Paused"/> is set to false before, no step is taken.
        /// </summary>
        public void StepOnce()
        {
            paused = true;
            if (run != null) singleSteps++;
        }

        /// <summary>Reads all collision meshes again, after an edit that left a mesh's counts and bounds as they were.</summary>
        public void RefreshColliders() => run?.InvalidateColliders();

        /// <summary>Checks the settings, the liquid and the colliders, of a prefab asset only the settings; changes nothing and logs nothing.</summary>
        /// <returns>What is wrong or worth knowing, errors first.</returns>
        public IReadOnlyList<FluidMessage> Validate() => FluidChecks.Preview(Spec, FluidScene.Volumes(this), out FluidSolverSettings? _);

        /// <summary>The liquid on the GPU, for kernels and shaders of yours: as of its last steps, until its next LateUpdate. Ask each frame.</summary>
        /// <param name="buffers">The buffers, to be read only; none where the liquid does not run.</param>
        /// <returns>False while the liquid does not run; <see cref="StatusMessage"/> says why.</returns>
        public bool TryGetBuffers(out FluidBuffers buffers)
        {
            buffers = run == null ? default : new FluidBuffers(run.Solver, LocalToWorld);
            return run != null;
        }

        /// <summary>Waits for the GPU and reads the particles, in simulation space, sorted by cell, without those that left the domain; for tools and tests.</summary>
        /// <param name="particles">Receives the particles.</param>
        /// <returns>False when stopped.</returns>
        public bool TryReadParticles(List<FluidParticle> particles) => FluidReports.TryReadParticles(Solver, particles);

        /// <summary>Spacing at which the liquid volumes hold as near to a number of particles as the lattice allows [m].</summary>
        /// <param name="count">Requested number of particles, 1 or more.</param>
        /// <returns>The spacing; <see cref="Spacing"/> is not changed.</returns>
        /// <exception cref="InvalidOperationException">There is no liquid to measure, or this is a prefab asset, which has none around it.</exception>
        public float SpacingForParticleCount(int count) => ParticleCountFit.Spacing(Spec, FluidScene.Volumes(this), count);

        internal void Report(FluidMessage message)
        {
            if (messages.Contains(message)) return;
            messages.Add(message);
            message.Log();
            Reported?.Invoke(message);
        }

        void OnEnable()
        {
            ActiveList.Add(this);
            requested = playOnEnable;
            failed = null;
        }

        void OnDisable()
        {
            ActiveList.Remove(this);
            Release();
        }

        void OnDestroy()
        {
            queries?.Dispose();
            Timer?.Dispose();
            Timer = null;
        }

        void FixedUpdate()
        {
            if (run != null && run.MovesBodies) run.FixedUpdate(transform.position, transform.rotation, Time.fixedDeltaTime);
        }

        void LateUpdate()
        {
            if (!requested) return;
            if (run != null && profile != null) automatic.Follow(Spec, run, Report);
            FluidSpec spec = Spec;
            if (run == null || !run.Key.Equals(FluidStartKey.Of(spec)))
            {
                if (failed == null || !failed.Value.Equals(KeysOf(spec)) || failedSources != CountSources()) StartSimulation();
                return;
            }
            run.Timer = Timer;
            FluidScene.Own(this, volumes);
            volumeWatch.Follow(spec, run, volumes, Report);
            long steps = StepCount, capped = CapHits;
            if (TryAdvance(spec, out FluidMessage failure))
            {
                FluidProfiler.AddLiquid(run.Solver.LiveCount, StepCount - steps, CapHits - capped, GpuBytes);
                LookAtCosts();
                queries?.Ask(run.Solver, spec.Profile.Shaders, run.SimulatedTime, spec.Position, spec.Rotation);
                Updated?.Invoke(this);
                return;
            }
            foreach (FluidMessage message in FluidReports.ErrorsOf(Validate(), failure)) Report(message);
            Release();
            Fail();
        }

        // The next try comes with the next change.
        void Fail()
        {
            failed = KeysOf(Spec);
            failedSources = CountSources();
        }

        int CountSources()
        {
            FluidScene.Own(this, volumes);
            return volumes.Count + emitters.Count;
        }

        bool TryAdvance(in FluidSpec spec, out FluidMessage failure)
        {
            var frame = new FluidFrame { SingleSteps = paused ? singleSteps : 0 };
            if (frame.SingleSteps == 0 && !paused) frame.Time = Time.deltaTime * UsableTimeScale();
            singleSteps = 0;
            if (frames != null) frame = frames.Take(frame);
            if (frame.SingleSteps == 0) return run.TryAdvance(spec, (float)frame.Time, out failure);
            failure = default;
            for (int left = frame.SingleSteps; left > 0; left--)
                if (!run.TryAdvance(spec, null, out failure)) return false;
            return true;
        }

        float UsableTimeScale()
        {
            if (timeScale >= 0f && !float.IsInfinity(timeScale)) return timeScale;
            Report(new FluidMessage(FluidSeverity.Error, FluidIssue.TimeScaleInvalid, this,
                FormattableString.Invariant($"Time Scale is {timeScale}, so the liquid stands still."), "Set Time Scale to 0 or more; 1 is as fast as the scene."));
            return 0f;
        }

        static (FluidStartKey, FluidLiveKey) KeysOf(in FluidSpec spec) => (FluidStartKey.Of(spec), FluidLiveKey.AsGiven(spec));

        /// <summary>Watches a start, and may end it.</summary>
        internal StartWatch Watch
        {
            get
            {
                IFluidStartWatcher watcher = StartWatcher;
                return watcher == null ? default : new StartWatch(progress => watcher.Continue(this, progress), () => watcher.Ended(this));
            }
        }

        void Release()
        {
            if (run == null) return;
            queries?.Detach();
            EndCosts();
            run.Dispose();
            run = null;
            singleSteps = 0;
            Stopped?.Invoke(this);
        }

        // Without a domain reload statics outlive play mode.
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        internal static void ResetStatics() => ActiveList.Clear();
    }
}
