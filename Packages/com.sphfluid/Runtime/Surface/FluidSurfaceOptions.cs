using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// How the surface of a liquid is made: the settings that components for drawing and for meshes share.
    /// </summary>
    [Serializable]
    public sealed class FluidSurfaceOptions
    {
        [SerializeField, Tooltip("How much work the surface may take: Cheap for weak devices, High for finer cells.")]
        private FluidSurfaceQuality quality = FluidSurfaceQuality.Default;

        [SerializeField, Min(0f),
            Tooltip("Edge of a cell in particle spacings. 0: by the quality. Smaller cells are finer and cost more.")]
        private float cellSize;

        [SerializeField,
            Tooltip(
                "Whether the surface is closed where the liquid touches the domain's walls. Off: only the open surface, e.g. behind " +
                "glass of your own.")]
        private bool closedAtWalls = true;

        [SerializeField, Min(0),
            Tooltip(
                "Most triangles of the surface. 0: as many as the device holds. A surface with more is not updated, and a warning says " +
                "so.")]
        private int triangleBudget;

        /// <summary>How much work the surface may take.</summary>
        public FluidSurfaceQuality Quality { get => Limits.Known(quality); set => quality = value; }

        /// <summary>Edge of a cell in particle spacings, 0 or more; 0 for what the quality says.</summary>
        public float CellSize { get => Limits.Clamp(cellSize, 0f); set => cellSize = value; }

        /// <summary>Whether the surface is closed where the liquid touches the domain's walls.</summary>
        public bool ClosedAtWalls { get => closedAtWalls; set => closedAtWalls = value; }

        /// <summary>Most triangles of the surface, 0 or more; 0 for as many as the device holds.</summary>
        public int TriangleBudget { get => Mathf.Max(0, triangleBudget); set => triangleBudget = value; }

        /// <summary>What becomes of the surface at the domain's walls.</summary>
        internal SurfaceWalls Walls => closedAtWalls ? SurfaceWalls.Closed : SurfaceWalls.Open;

        /// <summary>The field for a liquid.</summary>
        /// <exception cref="ArgumentOutOfRangeException">The cells are too large for the kernel, or their size is not a
        /// positive number.</exception>
        /// <param name="settings">The liquid.</param>
        /// <param name="factor">Edge of a cell over what the options say, 1 or more; less where cells would be too large.</param>
        internal SurfaceFieldSettings Field(in FluidSolverSettings settings, float factor = 1f)
        {
            return SurfaceFieldSettings.For(Quality, settings, Cell * Mathf.Min(factor, LargestFactor(settings)));
        }

        /// <summary>How many times larger than as set up cells may be, 1 or more.</summary>
        internal float LargestFactor(in FluidSolverSettings settings) =>
            Mathf.Max(1f, SurfaceFieldSettings.LargestCell(settings) / Cell);

        private float Cell => CellSize == 0f ? SurfaceFieldSettings.CellOf(Quality) : CellSize;
    }
}
