using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// What a liquid is, in SI units, and how faithfully it is computed. Stiffness, time step, viscosity and wall
    /// constants are not stored: they follow from these ratios, the particle spacing, the depth and the fastest
    /// expected speed, so that a profile serves every size of scene (see <see cref="FluidSolverSettings"/>).
    /// </summary>
    [CreateAssetMenu(menuName = "SPH Fluid/Fluid Profile", fileName = "FluidProfile", order = 200)]
    [ManualPage("tuning", "profile")]
    public sealed class FluidProfile : ScriptableObject
    {
        internal const int CurrentVersion = 1;

        /// <summary>Largest value of <see cref="MaxParticles"/>.</summary>
        public const int ParticleLimit = ProfileSpec.ParticleLimit;

        [SerializeField, HideInInspector] private int version = CurrentVersion;

        [Header("Liquid")]
        [SerializeField, Unit("kg/m³"), Range(1f, 20000f), Tooltip("Rest density of the liquid in kg/m³. Water: 1000.")]
        private float restDensity = 1000f;

        [SerializeField, Unit("m²/s"), Min(0f), Tooltip("Kinematic viscosity of the liquid in m²/s. Water: 0.000001. " +
            "The greater of this and the Viscosity Ratio's value acts.")]
        private float kinematicViscosity = 1e-6f;

        [SerializeField, Unit("N/m"), Min(0f),
            Tooltip("Surface tension of the liquid against air in N/m. Water: 0.073. 0: none. It acts where the particle spacing " +
            "is at most the capillary length, 2.7 mm for water, or with Tension At Any Spacing. Standard method only.")]
        private float surfaceTension;

        [SerializeField,
            Tooltip(
                "Surface Tension acts however coarse the particles are: for liquid that floats without gravity, where it shapes drops of " +
                "any size. " +
            "It costs two more passes over all neighbours a step. Standard method only.")]
        private bool tensionAtAnySpacing;

        [SerializeField, Unit("°"), Range(0f, 180f),
            Tooltip("Angle in degrees at which the liquid's surface meets walls, measured in the liquid: below 90 it wets them, " +
            "above it draws back from them. Acts with Surface Tension. Standard method only.")]
        private float contactAngle = 90f;

        [Header("Accuracy")]
        [SerializeField, Range(1.5f, 4f),
            Tooltip("Support radius R divided by the particle spacing. 2 gives about 33 neighbours, 2.25 48, 2.5 65: " +
            "free motion is more accurate with more, still pools and corners with fewer.")]
        private float supportRatio = 2.25f;

        [SerializeField, Range(3f, 20f), Tooltip("Speed of sound divided by the fastest expected speed. 5 allows 4 % compression; " +
            "halving the compression needs 1.4 times as many steps.")]
        private float soundSpeedRatio = 5f;

        [SerializeField,
            Tooltip(
                "Fixed By Rule: the speed of sound is that of the start. Follows Liquid: it falls once the liquid has come down and is " +
                "calm, " +
            "and rises in time when it is lifted or stirred, so that calm liquid takes fewer steps. Standard method; not with a fixed " +
            "time step.")]
        private FluidSoundSpeedMode soundSpeedMode = FluidSoundSpeedMode.FollowsLiquid;

        [SerializeField, Range(0.001f, 0.2f), Tooltip("Compression allowed at the bottom of the liquid at rest, g·depth/c². 0.04 is 4 %.")]
        private float maxCompression = 0.04f;

        [SerializeField, Range(0.05f, 1f),
            Tooltip("Time step as a fraction of the method's stability limit, which the speed of sound sets.")]
        private float timeStepFraction = 0.75f;

        [SerializeField, Range(1, FluidRuleInput.MostSubsteps),
            Tooltip("Equal steps that the Robust method cuts each frame into. Twice as many make the liquid four times as stiff, " +
            "for twice the time. 4 suits liquid that is about 20 particles deep at 60 frames a second.")]
        private int substeps = 4;

        [SerializeField,
            Tooltip("Corrects the gradient of the pressure where particles are arranged unevenly, and evens out the noise of the " +
            "density: waves last longer and keep their speed, for steps that take half as long again, or twice as long in small tanks. " +
            "Not where Surface Tension acts, nor in liquid so viscous that its viscosity is solved for. Standard method only.")]
        private bool gradientCorrection;

        [SerializeField, Range(0f, 0.05f), Tooltip("Least kinematic viscosity that keeps the liquid calm, as a multiple of " +
            "speed of sound times support radius. The Standard method takes a tenth of it.")]
        private float viscosityRatio = 0.01f;

        [Header("Walls of the thesis method")]
        [SerializeField, Range(0.1f, 1f),
            Tooltip("Distance at which walls and colliders begin to push, as a multiple of the particle spacing.")]
        private float wallDistanceRatio = 0.5f;

        [SerializeField, Range(0.05f, 4f),
            Tooltip(
                "Stiffness of walls and colliders. 1 stops the fastest expected speed within the wall distance; more may need a shorter " +
                "time step.")]
        private float wallStiffnessRatio = 1f;

        [SerializeField, Range(0f, 1f), Tooltip("Damping of the motion into a wall as a fraction of critical damping. 1: no rebound.")]
        private float wallDampingRatio = 1f;

        [Header("Thesis")]
        [SerializeField, Tooltip("Which misprints of the thesis are corrected. Switch one alone to see what its printed form does; the " +
            "method Thesis Printed ignores them: everything is as printed.")]
        private ThesisSwitches thesisSwitches = ThesisSwitches.Corrected;

        [Header("Limits")]
        [SerializeField, Range(1, ParticleLimit),
            Tooltip("Most particles that one simulation may start with. More is an error, never a silent cut.")]
        private int maxParticles = 1024 * 1024;

        [Header("References")]
        [SerializeField, Tooltip("Shader set asset: every compute shader and shader that the simulation and its renderers use.")]
        private FluidShaderSet shaders;

        /// <summary>Rest density ρ0 [kg/m³], 1 to 20,000.</summary>
        public float RestDensity { get => restDensity; set { restDensity = value; Touch(); } }

        /// <summary>Kinematic viscosity of the real liquid ν [m²/s], 0 to 10.</summary>
        public float KinematicViscosity { get => kinematicViscosity; set { kinematicViscosity = value; Touch(); } }

        /// <summary>Surface tension σ [N/m]; method Standard, 0 to 100.</summary>
        public float SurfaceTension { get => surfaceTension; set { surfaceTension = value; Touch(); } }

        /// <summary>
        /// Whether <see cref="SurfaceTension"/> acts however coarse the particles are, not only where they resolve it; method Standard.
        /// </summary>
        public bool TensionAtAnySpacing { get => tensionAtAnySpacing; set { tensionAtAnySpacing = value; Touch(); } }

        /// <summary>Contact angle at walls [degrees]; method Standard, 0 to 180.</summary>
        public float ContactAngle { get => contactAngle; set { contactAngle = value; Touch(); } }

        /// <summary>κ = R/dx: support radius over particle spacing, 1.5 to 4.</summary>
        public float SupportRatio { get => supportRatio; set { supportRatio = value; Touch(); } }

        /// <summary>c_eff / v_max: effective speed of sound over the fastest expected speed, 3 to 20.</summary>
        public float SoundSpeedRatio { get => soundSpeedRatio; set { soundSpeedRatio = value; Touch(); } }

        /// <summary>Whether the speed of sound stays as the start has it or follows the liquid; method Standard.</summary>
        public FluidSoundSpeedMode SoundSpeedMode { get => soundSpeedMode; set { soundSpeedMode = value; Touch(); } }

        /// <summary>Compression allowed at the bottom of the liquid at rest, g D/c², 0.001 to 0.2.</summary>
        public float MaxCompression { get => maxCompression; set { maxCompression = value; Touch(); } }

        /// <summary>Time step over the method's acoustic limit, <see cref="TimeStepAdvice"/>, 0.05 to 1.</summary>
        public float TimeStepFraction { get => timeStepFraction; set { timeStepFraction = value; Touch(); } }

        /// <summary>Equal steps that a frame is cut into; Robust method, 1 to 32.</summary>
        public int Substeps { get => substeps; set { substeps = value; Touch(); } }

        /// <summary>
        /// Whether the pressure's gradient is corrected for uneven arrangements of particles, so that waves last; method Standard.
        /// </summary>
        public bool GradientCorrection { get => gradientCorrection; set { gradientCorrection = value; Touch(); } }

        /// <summary>Least kinematic viscosity over c · R with the thesis method; Standard takes a tenth of it, 0 to 0.05.</summary>
        public float ViscosityRatio { get => viscosityRatio; set { viscosityRatio = value; Touch(); } }

        /// <summary>Wall distance over particle spacing; thesis method, 0.1 to 1.</summary>
        public float WallDistanceRatio { get => wallDistanceRatio; set { wallDistanceRatio = value; Touch(); } }

        /// <summary>Wall stiffness over (v_max/distance)²; thesis method, 0.05 to 4.</summary>
        public float WallStiffnessRatio { get => wallStiffnessRatio; set { wallStiffnessRatio = value; Touch(); } }

        /// <summary>Wall damping over critical damping; thesis method, 0 to 1.</summary>
        public float WallDampingRatio { get => wallDampingRatio; set { wallDampingRatio = value; Touch(); } }

        /// <summary>What of the thesis's text is corrected; <see cref="FluidMethodKind.Thesis"/> only.</summary>
        public ThesisSwitches ThesisSwitches { get => thesisSwitches; set { thesisSwitches = value; Touch(); } }

        /// <summary>Most particles a simulation with this profile may start with, 1 to <see cref="ParticleLimit"/>.</summary>
        public int MaxParticles { get => maxParticles; set { maxParticles = value; Touch(); } }

        /// <summary>Shaders used by the simulation and its renderers.</summary>
        public FluidShaderSet Shaders { get => shaders; set { shaders = value; Touch(); } }

        /// <summary>Version of the stored fields; 1 is the first release.</summary>
        public int Version => version;

        /// <summary>Grows with each change, so that a running simulation sees that it must derive its constants again.</summary>
        internal int Revision { get; private set; }

        /// <summary>The values as of now.</summary>
        internal ProfileSpec Spec
        {
            get
            {
                Clamp(); // what an asset holds
                return new ProfileSpec
                {
                    Asset = this,
                    Revision = Revision,
                    Rules = Rules,
                    SoundSpeedMode = soundSpeedMode,
                    MaxParticles = maxParticles,
                    Shaders = shaders,
                };
            }
        }

        private FluidRuleInput Rules
        {
            get
            {
                FluidRuleInput rules = FluidRuleInput.Water;
                rules.RestDensity = restDensity;
                rules.KinematicViscosity = kinematicViscosity;
                rules.SurfaceTension = surfaceTension;
                rules.TensionAtAnySpacing = tensionAtAnySpacing;
                rules.ContactAngle = contactAngle;
                rules.SupportRatio = supportRatio;
                rules.SoundSpeedRatio = soundSpeedRatio;
                rules.MaxCompression = maxCompression;
                rules.TimeStepFraction = timeStepFraction;
                rules.Substeps = substeps;
                rules.GradientCorrection = gradientCorrection;
                rules.ViscosityRatio = viscosityRatio;
                rules.WallDistanceRatio = wallDistanceRatio;
                rules.WallStiffnessRatio = wallStiffnessRatio;
                rules.WallDampingRatio = wallDampingRatio;
                rules.Switches = thesisSwitches;
                return rules;
            }
        }

        private void Touch()
        {
            Clamp();
            Revision++;
        }

        private void OnValidate() => Touch();

        private void Clamp()
        {
            restDensity = ClampFinite(restDensity, 1f, 20000f, 1000f);
            kinematicViscosity = ClampFinite(kinematicViscosity, 0f, 10f, 1e-6f);
            surfaceTension = ClampFinite(surfaceTension, 0f, 100f, 0f);
            contactAngle = ClampFinite(contactAngle, 0f, 180f, 90f);
            supportRatio = ClampFinite(supportRatio, 1.5f, 4f, 2.25f);
            soundSpeedRatio = ClampFinite(soundSpeedRatio, 3f, 20f, 5f);
            maxCompression = ClampFinite(maxCompression, 0.001f, 0.2f, 0.04f);
            timeStepFraction = ClampFinite(timeStepFraction, 0.05f, 1f, 0.75f);
            substeps = Mathf.Clamp(substeps, 1, FluidRuleInput.MostSubsteps);
            viscosityRatio = ClampFinite(viscosityRatio, 0f, 0.05f, 0.01f);
            wallDistanceRatio = ClampFinite(wallDistanceRatio, 0.1f, 1f, 0.5f);
            wallStiffnessRatio = ClampFinite(wallStiffnessRatio, 0.05f, 4f, 1f);
            wallDampingRatio = ClampFinite(wallDampingRatio, 0f, 1f, 1f);
            maxParticles = Mathf.Clamp(maxParticles, 1, ParticleLimit);
            soundSpeedMode = Limits.Known(soundSpeedMode);
            thesisSwitches = thesisSwitches.Limited();
            version = CurrentVersion;
        }

        private static float ClampFinite(float value, float min, float max, float fallback) =>
            float.IsNaN(value) ? fallback : Mathf.Clamp(value, min, max);
    }
}
