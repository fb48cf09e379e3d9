using System;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.Serialization;

namespace SphFluid
{
    /// <summary>
    /// Draws the surface of a simulation's liquid as the thesis does: a grid of density factors, then marching cubes in
    /// a geometry shader, lit per pixel. Where the device has no geometry shaders, says so once and draws the sparse
    /// surface instead, as an opaque body.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Geometry Surface Renderer")]
    [DefaultExecutionOrder(100)]
    [ManualPage("drawing", "the-thesiss-surface")]
    public sealed class FluidGeometrySurfaceRenderer : FluidRenderer
    {
        [SerializeField,
            Tooltip(
                "What is drawn: the surface, or the edges of the grid's cubes with a vertex inside it. A material of your own draws what " +
                "its keyword FLUID_CUBES says.")]
        private FluidSurfaceStyle style = FluidSurfaceStyle.MarchingCubes;

        [SerializeField, Tooltip("Cells a side of the grid over the domain. Automatic: 128 on a graphics card, 64 where the CPU draws.")]
        private SurfaceGridSize gridSize = SurfaceGridSize.Automatic;

        [SerializeField, Range(0.05f, 0.95f),
            Tooltip("The surface lies where the density is this part of the rest density. Lower: fatter liquid, more drops.")]
        private float isoValue = 0.5f;

        [SerializeField,
            Tooltip(
                "Whether the density at the domain's walls is completed as if the liquid went on behind them. Off: as the thesis prints " +
                "it.")]
        private bool wallCompletion = true;

        [SerializeField,
            Tooltip(
                "Material with the shader 'SPH Fluid/Surface (Geometry Shader)'. Empty: one made from the colour and smoothness below.")]
        private Material material;

        [SerializeField, FormerlySerializedAs("colour"), Tooltip("Colour of the liquid, if no material is given.")]
        private Color color = new Color(0.06f, 0.4f, 0.66f);

        [SerializeField, Range(0f, 1f),
            Tooltip("Smoothness of the surface, if no material is given: how small and bright its highlights are.")]
        private float smoothness = 0.75f;

        private readonly FluidSurfaceOptions fallbackOptions = new FluidSurfaceOptions();
        private CommandBuffer cmd;
        private SurfaceField field;
        private GeometrySurface surface;
        private LiquidDrawing fallback;
        private FluidShaderSet shaderSet;

        /// <summary>Says what the device does not have; tests put their own answer here.</summary>
        internal Func<string> MissingSupport { get; set; } = GeometrySurface.MissingSupport;

        /// <summary>
        /// What is drawn, if no material is given: the surface, or the edges of the grid's cubes with a vertex inside
        /// it.
        /// </summary>
        public FluidSurfaceStyle Style { get => Limits.Known(style); set => style = value; }

        /// <summary>Cells a side of the grid over the domain.</summary>
        public SurfaceGridSize GridSize { get => Limits.Known(gridSize); set => gridSize = value; }

        /// <summary>Density of the surface as a part of the rest density, 0.05 to 0.95.</summary>
        public float IsoValue { get => Limits.Clamp(isoValue, 0.05f, 0.95f); set => isoValue = value; }

        /// <summary>
        /// Whether the density at the domain's walls is completed; see <see cref="SurfaceField.WallCompletion"/>.
        /// </summary>
        public bool WallCompletion { get => wallCompletion; set => wallCompletion = value; }

        /// <summary>
        /// Material of the surface, or null for one made from <see cref="Color"/> and <see cref="Smoothness"/>.
        /// </summary>
        public Material Material { get => material; set => material = value; }

        /// <summary>Colour of the liquid, if no material is given. Not a number counts as 0.</summary>
        public Color Color { get => Limits.Finite(color); set => color = value; }

        /// <summary>Smoothness of the surface, if no material is given, 0 to 1.</summary>
        public float Smoothness { get => Limits.Clamp(smoothness, 0f, 1f); set => smoothness = value; }

        /// <summary>
        /// Bytes of GPU memory of the grid, or of the sparse surface in its place; 0 while nothing is drawn.
        /// </summary>
        public long GpuBytes => fallback?.Surface.GpuBytes ?? field?.GpuBytes ?? 0;

        /// <summary>Whether the sparse surface is drawn instead, because the device has no geometry shaders.</summary>
        public bool UsesFallback => fallback != null;

        /// <inheritdoc/>
        protected override void CreateResources(FluidShaderSet shaders)
        {
            shaderSet = shaders;
            string missing = MissingSupport();
            if (missing != null)
            {
                Debug.LogWarning($"{FluidMessage.Prefix} '{name}': {missing} The sparse surface is drawn instead.",
                    this);
                fallback = new LiquidDrawing(shaders);
                return;
            }
            surface = new GeometrySurface(shaders);
            cmd = new CommandBuffer { name = "Fluid Surface" };
        }

        /// <inheritdoc/>
        protected override void ReleaseResources()
        {
            cmd?.Dispose();
            field?.Dispose();
            surface?.Dispose();
            fallback?.Dispose();
            cmd = null;
            field = null;
            surface = null;
            fallback = null;
        }

        /// <inheritdoc/>
        protected override void Draw(FluidSimulation drawn)
        {
            if (fallback != null)
                fallback.DrawOpaque(drawn.Solver, fallbackOptions, Color, Smoothness, null, Placement(drawn, 0f),
                    this);
            else
                DrawSurface(drawn);
        }

        private void DrawSurface(FluidSimulation drawn)
        {
            FitField(drawn.Solver);
            cmd.Clear();
            field.Record(cmd, drawn.Solver);
            Graphics.ExecuteCommandBuffer(cmd);

            DrawPlacement placement = Placement(drawn, 0f);
            Color? ownColor = material == null ? Color : (Color?)null;
            surface.Properties(field, IsoValue, ownColor, Smoothness, placement);
            surface.SetStyle(Style);
            surface.Draw(field, material, placement);
        }

        private void FitField(FluidSolver solver)
        {
            SurfaceGrid grid = GridSize.OverDomain(solver.Settings.DomainSize);
            if (field == null || !field.Grid.Equals(grid))
            {
                field?.Dispose();
                field = null;
                field = new SurfaceField(shaderSet, grid);
            }
            field.WallCompletion = wallCompletion;
        }
    }
}
