using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Triangles of a known field, in cells of half a spacing.</summary>
    internal sealed class PolygoniserVariant : DenseVariant
    {
        /// <summary>Value of the fields on their surface.</summary>
        public const float Iso = 0.5f;

        private const float KnownFieldCell = 0.5f;

        private readonly SurfacePolygons kind;
        private float[] values = Array.Empty<float>();

        public PolygoniserVariant(FluidShaderSet shaders, SurfacePolygons kind)
            : base(shaders, KnownFieldCell)
        {
            this.kind = kind;
        }

        /// <inheritdoc/>
        public override bool OnGpu => false;

        /// <inheritdoc/>
        public override bool Takes(SurfaceState state) => state.Field != null;

        /// <inheritdoc/>
        protected override float Fill(SurfaceField field, SurfaceState state, FluidSolver solver, Vector3[] positions)
        {
            SurfaceGrid grid = field.Grid;
            values = new float[grid.VertexCount];
            for (int z = 0; z <= grid.Cells.z; z++)
                for (int y = 0; y <= grid.Cells.y; y++)
                    for (int x = 0; x <= grid.Cells.x; x++) values[grid.Index(x, y, z)] = state.Field(grid.Position(x, y, z));
            field.Values.SetData(values);
            return Iso;
        }

        /// <inheritdoc/>
        protected override SurfaceMesh Polygonise(SurfaceField field, float iso) => kind == SurfacePolygons.MarchingCubes
            ? base.Polygonise(field, iso)
            : DualMarchingCubes.Polygonise(field.Grid, values, iso, kind == SurfacePolygons.DualWithFlip);
    }
}
