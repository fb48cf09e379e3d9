using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The scalar field whose iso surface is the liquid's surface. Smooth: each particle's volume 1/D (D its poly6
    /// density on the lattice's scale) over a poly6 kernel at a position that is moved towards the mean of its
    /// neighbours (Yu and Turk 2010), a binomial filter, and the union with the unfiltered field less an offset, which
    /// keeps drops and films. Thesis: m/ρ0 over the solver's kernel, 6.4.3.
    /// </summary>
    public readonly struct SurfaceFieldSettings
    {
        // Radius of the smooth field's kernel in spacings: 33 particles of a lattice.
        private const float SmoothRatio = 2f;

        // Largest edge of a cell in radii: a lone particle's kernel must reach a sample.
        private const float LargestCellRatio = 1f;

        // Axes of a stretched kernel differ by 4 at most and leave its volume: 4 / 4^(1/3) is the longest in R.
        private const float LongestAxis = 2.52f;

        private readonly FieldKind kind;

        private SurfaceFieldSettings(float spacing, float cellSize, float supportRadius, in Preset preset, float isoValue,
            FieldKind kind, bool wallCompletion)
        {
            Spacing = spacing;
            CellSize = cellSize;
            SupportRadius = supportRadius;
            Smoothing = preset.Smoothing;
            FilterPasses = preset.FilterPasses;
            UnionOffset = preset.UnionOffset;
            IsoValue = isoValue;
            this.kind = kind;
            WallCompletion = wallCompletion;
            HasSpray = false;
        }

        private SurfaceFieldSettings(in SurfaceFieldSettings other, bool hasSpray)
        {
            this = other;
            HasSpray = hasSpray;
        }

        /// <summary>Particle spacing dx [m].</summary>
        public float Spacing { get; }

        /// <summary>
        /// Edge of a cell of the surface grid that the field is made for [m]; the grid's own may be a little smaller,
        /// to divide the domain.
        /// </summary>
        public float CellSize { get; }

        /// <summary>Radius of the field's kernel [m], the solver's R at most.</summary>
        public float SupportRadius { get; }

        /// <summary>
        /// λ: how far a particle's kernel moves towards the mean of its neighbours, 0 to 1 of the distance.
        /// </summary>
        public float Smoothing { get; }

        /// <summary>Passes of the filter 1 2 1 along each axis of the grid, 0 to 2.</summary>
        public int FilterPasses { get; }

        /// <summary>δ: how much the unfiltered field is lowered before the union.</summary>
        public float UnionOffset { get; }

        /// <summary>Value of the field on the surface.</summary>
        public float IsoValue { get; }

        /// <summary>Whether this is the thesis's field.</summary>
        public bool IsThesis => kind == FieldKind.Thesis;

        /// <summary>Whether kernels are stretched along the surface.</summary>
        public bool IsAnisotropic => kind == FieldKind.Anisotropic;

        /// <summary>Whether walls of the domain count as liquid, so that the surface is level at them.</summary>
        public bool WallCompletion { get; }

        /// <summary>
        /// Whether particles without company leave the surface, bit by bit, to be drawn as spray; of the smooth field only.
        /// </summary>
        internal bool HasSpray { get; }

        /// <summary>The same field with particles leaving it as spray, or with all of them in the surface.</summary>
        internal SurfaceFieldSettings WithSpray(bool on) => new SurfaceFieldSettings(this, on && kind == FieldKind.Smooth);

        /// <summary>Farthest that a particle's kernel reaches from the particle [m].</summary>
        internal float KernelReach => LongestShift + KernelExtent * SupportRadius;

        /// <summary>Farthest that a kernel reaches from its centre, in <see cref="SupportRadius"/>.</summary>
        internal float KernelExtent => IsAnisotropic ? LongestAxis : 1f;

        /// <summary>
        /// Farthest that the centre of a kernel lies from its particle [m]: the mean of the neighbours counts up to one
        /// spacing away.
        /// </summary>
        internal float LongestShift => Smoothing * Spacing;

        /// <summary>Whether this was made by one of the methods below.</summary>
        public bool IsSet => SupportRadius > 0f;

        /// <summary>Edge of a cell by a quality, in spacings.</summary>
        internal static float CellOf(FluidSurfaceQuality quality) => Preset.Get(quality).CellRatio;

        /// <summary>Largest edge of a cell, in spacings.</summary>
        internal static float LargestCell(in FluidSolverSettings settings) =>
            LargestCellRatio * Mathf.Min(SmoothRatio, settings.SupportRadius / settings.Spacing);

        /// <summary>The smooth field.</summary>
        /// <param name="quality">Cells of 1, 0.75 or 0.5 spacings, and a filter to match.</param>
        /// <param name="settings">The liquid: spacing and support radius.</param>
        public static SurfaceFieldSettings For(FluidSurfaceQuality quality, in FluidSolverSettings settings) =>
            For(quality, settings, Preset.Get(quality).CellRatio);

        /// <summary>The smooth field on cells of another size.</summary>
        /// <param name="quality">Smoothing and filter.</param>
        /// <param name="settings">The liquid: spacing and support radius.</param>
        /// <param name="cellSizeInSpacings">Edge of a cell in particle spacings.</param>
        /// <exception cref="ArgumentOutOfRangeException">The cells are too large for the kernel, or their size is not a
        /// positive number.</exception>
        public static SurfaceFieldSettings For(FluidSurfaceQuality quality, in FluidSolverSettings settings,
            float cellSizeInSpacings) =>
                Smooth(settings, Preset.Get(quality), cellSizeInSpacings, FieldKind.Smooth);

        /// <summary>
        /// A field whose kernels are stretched along the surface (Yu and Turk 2010), λ = 0.9, no filter: flatter pools
        /// for more work. Made to be compared with; lone drops are small balls.
        /// </summary>
        /// <param name="settings">The liquid: spacing and support radius.</param>
        /// <param name="cellSizeInSpacings">Edge of a cell in particle spacings.</param>
        /// <exception cref="ArgumentOutOfRangeException">The cells are too large for the kernel, or their size is not a
        /// positive number.</exception>
        public static SurfaceFieldSettings Anisotropic(in FluidSolverSettings settings,
            float cellSizeInSpacings = 0.5f) =>
                Smooth(settings, Preset.OfAnisotropic, cellSizeInSpacings, FieldKind.Anisotropic);

        /// <summary>
        /// The thesis's field: the solver's kernel over each particle's mass, as <c>SurfaceField</c> has it.
        /// </summary>
        /// <param name="settings">The liquid.</param>
        /// <param name="grid">The grid it is sampled on.</param>
        /// <param name="isoValue">Density over rest density on the surface, greater than 0.</param>
        /// <param name="wallCompletion">Whether walls count as liquid.</param>
        /// <exception cref="ArgumentOutOfRangeException">The iso value is not a positive number.</exception>
        public static SurfaceFieldSettings Thesis(in FluidSolverSettings settings, SurfaceGrid grid,
            float isoValue = 0.5f, bool wallCompletion = true)
        {
            if (!(isoValue > 0f) || float.IsInfinity(isoValue))
            {
                throw new ArgumentOutOfRangeException(nameof(isoValue),
                    $"The iso value is a density factor greater than 0, not {isoValue}.");
            }
            Vector3 cell = grid.CellSize;
            float edge = Mathf.Max(cell.x, Mathf.Max(cell.y, cell.z));
            return new SurfaceFieldSettings(settings.Spacing, edge, settings.SupportRadius, default, isoValue,
                FieldKind.Thesis, wallCompletion);
        }

        private static SurfaceFieldSettings Smooth(in FluidSolverSettings settings, in Preset preset, float cellSizeInSpacings,
            FieldKind kind)
        {
            float dx = settings.Spacing;
            float radius = Mathf.Min(SmoothRatio * dx, settings.SupportRadius);
            if (!(cellSizeInSpacings >= SurfaceIsoCalibration.LeastCell) || cellSizeInSpacings * dx > LargestCellRatio * radius)
            {
                throw new ArgumentOutOfRangeException(nameof(cellSizeInSpacings),
                    $"Cells of the surface have an edge of {SurfaceIsoCalibration.LeastCell} to {LargestCellRatio * radius / dx:G3} " +
                    "particle " +
                    $"spacings, the radius of the field's kernel, not {cellSizeInSpacings}.");
            }
            float iso = SurfaceIsoCalibration.IsoValue(radius / dx, cellSizeInSpacings, preset.Smoothing,
                preset.FilterPasses, preset.UnionOffset, kind == FieldKind.Anisotropic);
            return new SurfaceFieldSettings(dx, cellSizeInSpacings * dx, radius, preset, iso, kind, true);
        }

        private enum FieldKind
        {
            Smooth,
            Thesis,
            Anisotropic,
        }

        // Chosen by surface-quality.md of com.sphfluid.validation: the filter flattens, smoothing lets coarse cells
        // keep thin parts.
        private readonly struct Preset
        {
            private Preset(float cellRatio, float smoothing, int filterPasses, float unionOffset)
            {
                CellRatio = cellRatio;
                Smoothing = smoothing;
                FilterPasses = filterPasses;
                UnionOffset = unionOffset;
            }

            public float CellRatio { get; }

            public float Smoothing { get; }

            public int FilterPasses { get; }

            public float UnionOffset { get; }

            public static Preset OfAnisotropic => new Preset(0.5f, 0.9f, 0, 0f);

            public static Preset Get(FluidSurfaceQuality quality)
            {
                switch (quality)
                {
                    case FluidSurfaceQuality.Cheap:
                        return new Preset(1f, 0.9f, 1, 0.10f);
                    case FluidSurfaceQuality.Default:
                        return new Preset(0.75f, 0.5f, 1, 0.12f);
                    case FluidSurfaceQuality.High:
                        return new Preset(0.5f, 0.5f, 2, 0.15f);
                    default:
                        throw new ArgumentOutOfRangeException(nameof(quality), quality,
                            "There is no such quality of a surface.");
                }
            }
        }
    }
}
