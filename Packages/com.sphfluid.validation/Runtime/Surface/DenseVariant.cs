using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A field at all vertices of a grid over the domain, and marching cubes.</summary>
    internal abstract class DenseVariant : SurfaceVariant
    {
        private readonly FluidShaderSet shaders;
        private readonly SurfacePolygoniser polygoniser;
        private SurfaceField field;

        protected DenseVariant(FluidShaderSet shaders, float cell)
            : base(cell)
        {
            this.shaders = shaders;
            polygoniser = new SurfacePolygoniser(shaders);
        }

        /// <inheritdoc/>
        public override SurfaceMesh Mesh(SurfaceState state, FluidSolver solver, Vector3[] positions)
        {
            FluidSolverSettings settings = solver.Settings;
            SurfaceGrid grid = SurfaceGrid.OverDomain(settings.DomainSize, Cell * settings.Spacing);
            if (field == null || !field.Grid.Equals(grid))
            {
                field?.Dispose();
                field = new SurfaceField(shaders, grid);
            }
            float iso = Fill(field, state, solver, positions);
            return Polygonise(field, iso);
        }

        /// <inheritdoc/>
        public override void Dispose()
        {
            field?.Dispose();
            polygoniser.Dispose();
        }

        /// <summary>Writes the field.</summary>
        /// <returns>Its iso value.</returns>
        protected abstract float Fill(SurfaceField field, SurfaceState state, FluidSolver solver, Vector3[] positions);

        /// <summary>The surface of the field.</summary>
        protected virtual SurfaceMesh Polygonise(SurfaceField field, float iso) => polygoniser.Polygonise(field, iso);
    }
}
