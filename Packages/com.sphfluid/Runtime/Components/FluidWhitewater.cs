using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Spray, foam and bubbles of the simulation on the same GameObject (Ihmsen, Akinci, Akinci and Teschner 2012, "Unified spray, foam and
    /// bubbles for particle-based fluids"): born where the liquid is agitated, carried by it, and drawn over its surface. The liquid does
    /// not feel them. Disabled, nothing is computed and no memory is held.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Whitewater")]
    [ManualPage("drawing", "whitewater")]
    [RequireComponent(typeof(FluidSimulation))]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(105)]
    public sealed class FluidWhitewater : MonoBehaviour
    {
        [SerializeField, Range(1, MostParticles),
            Tooltip("Most particles of spray, foam and bubbles. If the liquid makes more, there is less of it " +
            "everywhere, and a message says so. 96 bytes of GPU memory each. A change begins without any.")]
        private int maxParticles = 65536;

        [SerializeField,
            Tooltip("Use the rows below instead of the whitewater of the simulation's liquid. Without a liquid they always apply.")]
        private bool ownLook;

        [SerializeField, Min(0f), Tooltip("How much whitewater agitated liquid makes, relative to the default.")]
        private float amount = 1f;

        [SerializeField, Unit("s"), Min(0.01f), Tooltip("How long foam lies on still water, at most [s]. On fast water it goes sooner.")]
        private float foamLife = 3f;

        [SerializeField, Min(0f),
            Tooltip("Size of drops, flakes of foam and bubbles, relative to the default, which follows the particle spacing.")]
        private float size = 1f;

        [SerializeField, Tooltip("Its colour in white light.")]
        private Color color = new Color(0.93f, 0.97f, 1f);

        private FluidSimulation simulation;
        private FluidShaderSet preparedShaders;
        private FluidSolver refused;
        private WhitewaterFlow flow;
        private WhitewaterDrawing drawing;

        /// <summary>Most particles that <see cref="MaxParticles"/> may be.</summary>
        public const int MostParticles = 1 << 20;

        /// <summary>Most particles of spray, foam and bubbles, 1 to <see cref="MostParticles"/>. A change begins without any.</summary>
        public int MaxParticles { get => Mathf.Clamp(maxParticles, 1, MostParticles); set => maxParticles = value; }

        /// <summary>
        /// Whether <see cref="Amount"/>, <see cref="FoamLife"/>, <see cref="Size"/> and <see cref="Color"/> of this component act, although
        /// its simulation has a liquid. Without a liquid they do anyway. A liquid without whitewater makes none otherwise.
        /// </summary>
        public bool OwnLook { get => ownLook; set => ownLook = value; }

        /// <summary>How much whitewater agitated liquid makes, relative to the default; 0 or more.</summary>
        public float Amount { get => Limits.Clamp(amount, 0f); set => amount = value; }

        /// <summary>How long foam lies on still water, at most [s]; 0.01 or more.</summary>
        public float FoamLife { get => Limits.Clamp(foamLife, 0.01f); set => foamLife = value; }

        /// <summary>Size of drops, flakes of foam and bubbles, over what it is by default; 0 or more.</summary>
        public float Size { get => Limits.Clamp(size, 0f); set => size = value; }

        /// <summary>Its colour in white light. Not a number counts as 0.</summary>
        public Color Color { get => Limits.Finite(color); set => color = value; }

        /// <summary>How much whitewater there is, as of a few frames ago; all zero while there is none.</summary>
        public WhitewaterCounts Counts => flow?.Counts ?? default;

        /// <summary>Bytes of GPU memory; 0 while nothing is computed.</summary>
        public long GpuBytes => flow?.GpuBytes ?? 0;

        internal WhitewaterFlow Flow => flow;

        private void OnEnable() => refused = null;

        private void OnDisable() => Forget();

        private void LateUpdate()
        {
            if (simulation == null) TryGetComponent(out simulation);
            FluidSolver solver = simulation != null && simulation.isActiveAndEnabled ? simulation.Solver : null;
            FluidLiquid liquid = solver == null || ownLook ? null : simulation.ActiveLiquid;
            if (solver == null || !simulation.Detail.Whitewater || (liquid != null && !liquid.Whitewater))
            {
                Forget();
                return;
            }
            if (solver == refused) return;
            try
            {
                Prepare(simulation.Profile.Shaders);
                var settings = liquid != null ? new WhitewaterSettings(MaxParticles, liquid.WhitewaterAmount, liquid.FoamLife)
                    : new WhitewaterSettings(MaxParticles, Amount, FoamLife);
                flow.Advance(solver, simulation.SimulatedTime, settings);
                drawing.Draw(flow.Buffers, solver.Settings.Spacing, liquid != null ? liquid.WhitewaterSize : Size,
                    liquid != null ? liquid.FoamColor : Color, Placement(solver.Settings),
                    simulation.SimulatedTime);
            }
            catch (FluidDeviceException exception)
            {
                Forget();
                refused = solver;
                simulation
                    .Report(new FluidMessage(FluidSeverity.Warning, FluidIssue.DeviceUnsupported, this, exception.Message,
                        "The liquid runs without whitewater."));
                return;
            }
            if (flow.Counts.Refused > 0) simulation.Report(Full);
        }

        private FluidMessage Full => new FluidMessage(FluidSeverity.Warning, FluidIssue.WhitewaterFull, this,
            $"The liquid makes more whitewater than the {MaxParticles} particles that Max Particles allows, so all of it is thinned out.",
            "Raise Max Particles, or lower Amount or Foam Life.");

        // It receives shadows as the liquid around it does.
        private DrawPlacement Placement(in FluidSolverSettings settings)
        {
            bool receives = TryGetComponent(out FluidRenderer liquid) && liquid.isActiveAndEnabled && liquid.ReceiveShadows;
            float waterShadow = liquid is FluidSurfaceRenderer surface ? surface.WaterShadow : 0f;
            return new DrawPlacement(simulation.LocalToWorld, settings.DomainSize, settings.Spacing, gameObject.layer, false, receives,
                settings.Spacing, waterShadow);
        }

        private void Prepare(FluidShaderSet shaders)
        {
            if (shaders == preparedShaders && flow != null) return;
            Forget();
            flow = new WhitewaterFlow(shaders);
            drawing = new WhitewaterDrawing(shaders);
            preparedShaders = shaders;
        }

        private void Forget()
        {
            drawing?.Dispose();
            drawing = null;
            flow?.Dispose();
            flow = null;
        }
    }
}
