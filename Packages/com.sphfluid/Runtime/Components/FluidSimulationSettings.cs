using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// What is set of a <see cref="FluidSimulation"/>: the fields of its inspector and the spec that they make. It starts and steps
    /// nothing.
    /// </summary>
    public abstract class FluidSimulationSettings : MonoBehaviour
    {
        [SerializeField,
            Tooltip("The liquid: its motion, look, spray and foam. One with another profile starts the simulation again.")]
        private FluidLiquid liquid;

        [SerializeField,
            Tooltip(
                "Box: the liquid is in a box of Domain Size, whose faces are walls or what Boundaries say. Open: it goes where it goes, " +
                "and only colliders hold it; what is beyond Farthest Distance leaves. Methods Standard and Robust. A change starts the " +
                "liquid again.")]
        private FluidDomain domain;

        [SerializeField, Unit("m"), Tooltip("Edge lengths of the box that holds the liquid, in metres. A change starts the liquid again.")]
        private Vector3 domainSize = new Vector3(1f, 1f, 1f);

        [SerializeField, Min(0f), Unit("m"),
            Tooltip("Distance of neighbouring particles at rest in metres. Half of it means 8 times as many particles " +
            "and twice as many steps. A change starts the liquid again.")]
        private float particleSpacing = 0.025f;

        [SerializeField,
            Tooltip(
                "How the motion is computed: Standard; Robust, softer, by a fixed number of steps a frame; the thesis's method to " +
                "compare with; or Automatic, " +
            "which picks one at the start that fits the Frame Budget on this device. A change starts the liquid again.")]
        private FluidMethodKind method = FluidMethodKind.Standard;

        [SerializeField, Tooltip("Layers whose colliders the liquid collides with.")]
        private LayerMask colliderLayers = ~0;

        [SerializeField,
            Tooltip("The liquid stops, but is still drawn. Colliders that move meanwhile catch up with the first step afterwards.")]
        private bool paused;

        [SerializeField, Min(0f),
            Tooltip(
                "Time of this liquid over the scene's time: 1 as fast as the scene, 0.5 half as fast, 0 stands still. Time.timeScale " +
                "applies as well.")]
        private float timeScale = 1f;

        [SerializeField, Unit("m"),
            Tooltip(
                "How far the liquid of an open domain may go from this object along each of its axes, either way, in metres. What goes " +
                "farther is removed, and the console says so once. A change starts the liquid again.")]
        private Vector3 farthestDistance = new Vector3(50f, 10f, 50f);

        [SerializeField, Tooltip("Start with the scene or when the component is enabled.")]
        private bool playOnEnable = true;

        [SerializeField, Tooltip("Constants of motion and shaders that replace the liquid's. Empty: the liquid's.")]
        private FluidProfile profile;

        [SerializeField, Min(0f), Unit("ms"),
            Tooltip(
                "Milliseconds of each frame that this liquid's steps may take on the graphics device, with the method Automatic. A " +
                "change in play chooses again, and another method starts the liquid again.")]
        private float frameBudget = 4f;

        [SerializeField, Min(0f), Unit("Hz"),
            Tooltip("Frames a second that the Frame Budget is for. 0: the application's target frame rate, or 60 where it sets none.")]
        private float budgetFrameRate;

        [Header("Faces and forces")]
        [SerializeField,
            Tooltip(
                "What the faces of the domain box do: walls at rest, moving walls that drag, openings into the opposite face, or " +
                "openings through which liquid leaves.")]
        private FluidBoundaries boundaries;

        [SerializeField, Tooltip("Take gravity from Physics.gravity.")]
        private bool useSceneGravity = true;

        [SerializeField, Unit("m/s²"), Tooltip("Gravity in m/s² in world space when Use Scene Gravity is off.")]
        private Vector3 gravity = new Vector3(0f, -9.81f, 0f);

        [SerializeField, Tooltip("A force by position besides gravity, along the axes of the domain box.")]
        private FluidBodyForce bodyForce;

        [Header("Start")]
        [SerializeField,
            Tooltip(
                "How the liquid is brought to rest before the first frame. None: the liquid's own choice. Packed: without gravity, " +
                "particles that are too close to each other or to walls move apart. Hydrostatic: under gravity. Both take hundreds to " +
                "thousands of steps at the start, without Start Jitter; method Standard only. Saved: at once, from Saved Start. A change " +
                "starts the liquid again.")]
        private FluidStartRelaxation startRelaxation;

        [SerializeField,
            Tooltip(
                "The relaxed start as Save Relaxed Start wrote it. The liquid starts from it at once, as long as it is the same liquid " +
                "in the same vessel; otherwise it comes to rest anew.")]
        private TextAsset savedStart;

        [SerializeField, Range(0f, FluidSpawner.MaxJitter),
            Tooltip("Largest random offset of a particle at the start as a fraction of the spacing. A change starts the liquid again.")]
        private float startJitter = 0.02f;

        [SerializeField,
            Tooltip("Seed of the random offsets at the start. The same seed gives the same start. A change starts the liquid again.")]
        private int seed = 1;

        [Header("Time steps")]
        [SerializeField,
            Tooltip("Liquid that rests takes no steps until something touches it: a collider that moves, a changed setting, a script.")]
        private bool sleepsAtRest = true;

        [SerializeField,
            Tooltip("With Sleeps At Rest and Standard: so do parts of a large pool that rest while others move. What moves less than " +
            "a twelfth of the speed that gravity gives over a spacing counts as rest: ripples of a part of a spacing end there.")]
        private bool partsSleep;

        [SerializeField, Min(0f), Unit("m/s"),
            Tooltip("Fastest speed to expect in m/s, 1000 at most: for liquid that gets faster than its fall and the colliders, or " +
            "whose speed of sound does not follow them. 0: fall and colliders decide.")]
        private float expectedSpeed;

        [SerializeField, Range(1, 1000),
            Tooltip("Most steps a frame. If a frame needs more, the liquid falls behind real time, and the console says so.")]
        private int maxSubstepsPerFrame = 64;

        [SerializeField, Tooltip("Automatic: the time step follows from spacing, stiffness and viscosity. Fixed: as given. " +
            "Adaptive: equal parts of each frame, shorter when the liquid is faster than expected.")]
        private FluidTimeStepMode timeStepMode = FluidTimeStepMode.Automatic;

        [SerializeField, Min(0f), Unit("s"), Tooltip("Time step in seconds when Time Step Mode is Fixed.")]
        private float fixedTimeStep = 0.0005f;

        [Header("Particles that come and go")]
        [SerializeField,
            Tooltip(
                "What happens when emitters give more particles than there are slots for. Grow: twice as many slots, up to Max Particles " +
                "of " +
            "the profile. Fixed: as many as Capacity from the start, and no more come in. Recycle Oldest: the oldest leave.")]
        private FluidCapacityPolicy capacityPolicy;

        [SerializeField, Min(0), Tooltip("Particles that Fixed and Recycle Oldest hold. 0: Max Particles of the profile.")]
        private int capacity;

        private protected FluidSimulationSettings()
        {
        }

        /// <summary>
        /// What it is filled with; null: what its emitters give, or what the other settings say. Another liquid looks so at once, and moves
        /// so from a new start on.
        /// </summary>
        public FluidLiquid Liquid { get => liquid; set => liquid = value; }

        /// <summary>
        /// The liquid that it is of: <see cref="Liquid"/>, else what its first emitter with one gave at the start or since; null: none.
        /// </summary>
        public abstract FluidLiquid ActiveLiquid { get; }

        /// <summary>
        /// Constants of the motion, and shaders: those that were set here, else those of <see cref="ActiveLiquid"/>. Set to null, the
        /// liquid's act again.
        /// </summary>
        public FluidProfile Profile
        {
            get
            {
                if (profile != null) return profile;
                FluidLiquid active = ActiveLiquid;
                return active != null ? active.Profile : null;
            }
            set => profile = value;
        }

        /// <summary>The profile that was set here, whatever the liquid; null: none.</summary>
        internal FluidProfile OwnProfile => profile;

        /// <summary>Whether the liquid is in a box, or goes where colliders let it.</summary>
        public FluidDomain Domain { get => Limits.Known(domain); set => domain = value; }

        /// <summary>
        /// Edge lengths of the box in this transform's space [m]; of an open domain twice <see cref="FarthestDistance"/>.
        /// </summary>
        public Vector3 DomainSize
        {
            get => IsOpen ? 2f * farthestDistance : domainSize;
            set
            {
                if (IsOpen) farthestDistance = 0.5f * value;
                else domainSize = value;
            }
        }

        /// <summary>
        /// How far the liquid of an open domain may go from this transform along each of its axes, either way [m]. Particles beyond are
        /// removed and counted: <see cref="FluidSimulation.RemovedParticles"/>.
        /// </summary>
        public Vector3 FarthestDistance { get => farthestDistance; set => farthestDistance = value; }

        /// <summary>Particle spacing dx [m].</summary>
        public float Spacing { get => particleSpacing; set => particleSpacing = value; }

        /// <summary>How the motion is computed.</summary>
        public FluidMethodKind Method { get => method; set => method = value; }

        /// <summary>
        /// Time that this liquid's steps may take of a frame on the graphics device [ms], greater than 0; with the method Automatic.
        /// </summary>
        public float FrameBudget { get => frameBudget; set => frameBudget = value; }

        /// <summary>
        /// Frames a second that <see cref="FrameBudget"/> is for; 0: those of Application.targetFrameRate or Time.captureDeltaTime, or 60
        /// where neither is set.
        /// </summary>
        public float BudgetFrameRate { get => budgetFrameRate; set => budgetFrameRate = value; }

        /// <summary>Layers whose colliders count.</summary>
        public LayerMask ColliderLayers { get => colliderLayers; set => colliderLayers = value; }

        /// <summary>Where the time step comes from.</summary>
        public FluidTimeStepMode TimeStepMode { get => Limits.Known(timeStepMode); set => timeStepMode = value; }

        /// <summary>Time step in fixed mode [s].</summary>
        public float FixedTimeStep { get => fixedTimeStep; set => fixedTimeStep = value; }

        /// <summary>
        /// Whether the liquid is paused: it keeps its state, is still drawn and takes no steps but those of
        /// <see cref="FluidSimulation.StepOnce"/>. No time is made up for afterwards. Changed settings act with the next step. The motion
        /// of colliders during the pause joins into one that the next frame with steps goes through; one too long to follow is a jump,
        /// reported as <see cref="FluidIssue.ColliderJumped"/>.
        /// </summary>
        public bool Paused { get => paused; set => paused = value; }

        /// <summary>
        /// Time of this liquid over Unity's scaled time, 0 or more; 1 by default. Time.timeScale acts besides. Faster than the liquid can
        /// be computed it moves as fast as <see cref="MaxSubstepsPerFrame"/> allows. Below 0 or not finite it is reported, and the liquid
        /// stands still.
        /// </summary>
        public float TimeScale { get => timeScale; set => timeScale = value; }

        /// <summary>Most steps a frame, 1 to 1000.</summary>
        public int MaxSubstepsPerFrame { get => Mathf.Clamp(maxSubstepsPerFrame, 1, 1000); set => maxSubstepsPerFrame = value; }

        /// <summary>
        /// Whether liquid that rests takes no steps until something touches it; see <see cref="FluidSimulation.IsAsleep"/>.
        /// </summary>
        public bool SleepsAtRest { get => sleepsAtRest; set => sleepsAtRest = value; }

        /// <summary>
        /// Whether parts of a liquid that rest take no part in the steps while others move, with <see cref="SleepsAtRest"/> and the method
        /// Standard; see <see cref="FluidSimulation.AsleepShare"/>.
        /// </summary>
        public bool PartsSleep { get => partsSleep; set => partsSleep = value; }

        /// <summary>Fastest speed to be ready for beyond the fall's [m/s], 0 to 1000; 0: the fall decides.</summary>
        public float ExpectedSpeed { get => Limits.Clamp(expectedSpeed, 0f, FluidSpec.MostSpeed); set => expectedSpeed = value; }

        /// <summary>Whether Physics.gravity acts instead of <see cref="Gravity"/>.</summary>
        public bool UseSceneGravity { get => useSceneGravity; set => useSceneGravity = value; }

        /// <summary>Own gravity in world space [m/s²].</summary>
        public Vector3 Gravity { get => gravity; set => gravity = value; }

        /// <summary>Gravity that acts, in world space [m/s²].</summary>
        public Vector3 EffectiveGravity => useSceneGravity ? Physics.gravity : gravity;

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
        public float StartJitter { get => Limits.Clamp(startJitter, 0f, FluidSpawner.MaxJitter); set => startJitter = value; }

        /// <summary>
        /// How the liquid is brought to rest before the first frame; where it is None, as <see cref="ActiveLiquid"/> says. Standard method
        /// only; its step count is among the messages.
        /// </summary>
        public FluidStartRelaxation StartRelaxation { get => Limits.Known(startRelaxation); set => startRelaxation = value; }

        /// <summary>A relaxed start that the inspector saved, which the liquid starts from as long as it fits; null for none.</summary>
        public TextAsset SavedStart { get => savedStart; set => savedStart = value; }

        /// <summary>What happens when emitters give more particles than there are slots for.</summary>
        public FluidCapacityPolicy CapacityPolicy { get => Limits.Known(capacityPolicy); set => capacityPolicy = value; }

        /// <summary>Particles that the policies Fixed and RecycleOldest hold; 0: as many as the profile allows.</summary>
        public int Capacity { get => capacity; set => capacity = value; }

        private bool IsOpen => Domain == FluidDomain.Open;

        /// <summary>
        /// The settings as they are now, with the transform's place; without the other components that belong to the simulation.
        /// </summary>
        private protected FluidSpec SettingsSpec
        {
            get
            {
                FluidLiquid active = ActiveLiquid;
                FluidProfile acting = profile != null || active == null ? profile : active.Profile;
                bool relaxes = StartRelaxation != FluidStartRelaxation.None || active == null;
                var spec = new FluidSpec
                {
                    CapacityPolicy = CapacityPolicy,
                    Capacity = capacity,
                    Owner = this,
                    Position = transform.position,
                    Rotation = transform.rotation,
                    Scale = transform.lossyScale,
                    Liquid = active,
                    Profile = acting != null ? acting.Spec : default,
                    IsOpen = IsOpen,
                    DomainSize = DomainSize,
                    Spacing = particleSpacing,
                    Method = method,
                    ColliderLayers = colliderLayers,
                    TimeStepMode = TimeStepMode,
                    FixedTimeStep = fixedTimeStep,
                    MaxSubstepsPerFrame = MaxSubstepsPerFrame,
                    ExpectedSpeed = ExpectedSpeed,
                    SleepsAtRest = sleepsAtRest,
                    PartsSleep = partsSleep,
                    Gravity = EffectiveGravity,
                    BodyForce = bodyForce,
                    Boundaries = IsOpen ? boundaries.WithAllOpen() : boundaries,
                    VelocityField = VelocityField,
                    Seed = seed,
                    StartJitter = StartJitter,
                    StartRelaxation = relaxes ? StartRelaxation : active.StartRelaxation,
                    SavedStart = savedStart,
                };
                if (FluidMethods.IsChosen(method))
                {
                    spec.Automatic = new AutomaticSpec(frameBudget, FrameRate, spec.Profile.Rules, spec.MaxSubstepsPerFrame);
                }
                return spec;
            }
        }

        // What is typed, or the frames that the program makes.
        private double FrameRate => budgetFrameRate != 0f ? budgetFrameRate : Time.captureDeltaTime > 0f
            ? Math.Round(1.0 / Time.captureDeltaTime, 3)
            : Application.targetFrameRate > 0 ? Application.targetFrameRate : AutomaticSpec.UsualFrameRate;
    }
}
