using UnityEngine;
using UnityEngine.Serialization;

namespace SphFluid
{
    /// <summary>
    /// Draws the surface of a simulation's liquid: marching cubes in compute shaders, only where the surface is, as
    /// clear water or as an opaque body. Works on every graphics API that runs the simulation; no geometry shader.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Surface Renderer")]
    [DefaultExecutionOrder(100)]
    [ManualPage("drawing", "clear-water")]
    public sealed class FluidSurfaceRenderer : FluidRenderer
    {
        [SerializeField, Tooltip("Use the rows below instead of the look of the simulation's liquid. Without a liquid they always apply.")]
        private bool ownLook;

        [SerializeField, Tooltip("How the surface is made.")]
        private FluidSurfaceOptions surface = new FluidSurfaceOptions();

        [SerializeField, Tooltip("How it is drawn: as clear water or as an opaque body.")]
        private FluidSurfaceLook look = FluidSurfaceLook.Water;

        [SerializeField, Tooltip("How clear water looks.")]
        private FluidWaterLook water = new FluidWaterLook();

        [SerializeField,
            Tooltip(
                "Material with the shader 'SPH Fluid/Water' or 'SPH Fluid/Surface', to match the look. Empty: one made from the settings " +
                "here.")]
        private Material material;

        [SerializeField, FormerlySerializedAs("colour"), Tooltip("Colour of the opaque body, if no material is given.")]
        private Color color = new Color(0.06f, 0.4f, 0.66f);

        [SerializeField, Range(0f, 1f),
            Tooltip("Smoothness of the opaque body, if no material is given: how small and bright its highlights are.")]
        private float smoothness = 0.75f;

        private LiquidDrawing drawing;

        /// <summary>
        /// Whether the surface is drawn by <see cref="Surface"/>, <see cref="Look"/>, <see cref="Water"/>, <see cref="Color"/> and
        /// <see cref="Smoothness"/> of this component, although its simulation has a liquid. Without a liquid it is anyway.
        /// </summary>
        public bool OwnLook { get => ownLook; set => ownLook = value; }

        /// <summary>How the surface is made.</summary>
        public FluidSurfaceOptions Surface => surface;

        /// <summary>How it is drawn: as clear water or as an opaque body.</summary>
        public FluidSurfaceLook Look { get => Limits.Known(look); set => look = value; }

        /// <summary>How clear water looks.</summary>
        public FluidWaterLook Water => water;

        /// <summary>Material of the surface, or null for one made from the other settings.</summary>
        public Material Material { get => material; set => material = value; }

        /// <summary>Colour of the opaque body, if no material is given. Not a number counts as 0.</summary>
        public Color Color { get => Limits.Finite(color); set => color = value; }

        /// <summary>Smoothness of the opaque body, if no material is given, 0 to 1.</summary>
        public float Smoothness { get => Limits.Clamp(smoothness, 0f, 1f); set => smoothness = value; }

        /// <summary>Bytes of GPU memory of the surface; 0 while nothing is drawn.</summary>
        public long GpuBytes => drawing?.Surface.GpuBytes ?? 0;

        /// <summary>What became of the last surface, a few frames ago; all zero while nothing is drawn.</summary>
        public SurfaceStatus Status => drawing != null ? drawing.Surface.Status : default;

        /// <summary>Surfaces that were made since drawing began.</summary>
        internal int Recordings => drawing?.Surface.Recordings ?? 0;

        /// <summary>The look that it is drawn in: its liquid's or its own.</summary>
        internal FluidSurfaceLook ActiveLook => LookOf(Simulation != null ? LiquidOf(Simulation) : null);

        /// <summary>Strength of the shadow that it casts as water, 0 to 1; 0 with another look, or where it casts none.</summary>
        internal float WaterShadow => CastShadows ? ShadowOf(Simulation != null ? LiquidOf(Simulation) : null) : 0f;

        /// <inheritdoc/>
        protected override void CreateResources(FluidShaderSet shaders) => drawing = new LiquidDrawing(shaders);

        /// <inheritdoc/>
        protected override void ReleaseResources()
        {
            drawing?.Dispose();
            drawing = null;
        }

        /// <inheritdoc/>
        protected override void Draw(FluidSimulation drawn)
        {
            FluidLiquid liquid = LiquidOf(drawn);
            DrawPlacement placement = Placement(drawn, 0f, CastShadows ? ShadowOf(liquid) : 0f);
            FluidSurfaceOptions made = liquid != null ? liquid.Surface : surface;
            ReportCells(drawn, made);
            drawing.SetDetail(drawn.Detail.CellFactor, drawn.Detail.Caustics);
            if (LookOf(liquid) == FluidSurfaceLook.Water)
                drawing.DrawWater(drawn.Solver, made, WaterOf(liquid), material, placement, this);
            else
                drawing.DrawOpaque(drawn.Solver, made, liquid != null ? liquid.Color : Color, liquid != null ? liquid.Smoothness
                    : Smoothness, material, placement, this);
            FluidProfiler.AddSurface(Status.Triangles, drawing.Surface.SprayCount, GpuBytes);
        }

        // Null: this component's own rows.
        private FluidLiquid LiquidOf(FluidSimulation drawn) => ownLook ? null : drawn.ActiveLiquid;

        private FluidSurfaceLook LookOf(FluidLiquid liquid) => liquid != null ? liquid.Look : Look;

        private FluidWaterLook WaterOf(FluidLiquid liquid) => liquid != null ? liquid.Water : water;

        private float ShadowOf(FluidLiquid liquid) => LookOf(liquid) == FluidSurfaceLook.Water ? WaterOf(liquid).Shadow : 0f;
    }
}
