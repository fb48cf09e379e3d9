using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>A field at all vertices of a grid over the domain, and marching cubes.</summary>
    abstract class DenseVariant : SurfaceVariant
    {
        readonly FluidShaderSet shaders;
        readonly SurfacePolygoniser polygoniser;
        SurfaceField field;

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

    /// <summary>The thesis's sum of poly6 at half the rest density.</summary>
    sealed class ThesisVariant : DenseVariant
    {
        const float Iso = 0.5f;

        public ThesisVariant(FluidShaderSet shaders, float cell)
            : base(shaders, cell)
        {
        }

        protected override float Fill(SurfaceField field, SurfaceState state, FluidSolver solver, Vector3[] positions)
        {
            using (var cmd = new CommandBuffer { name = "Surface Variant" })
            {
                field.Record(cmd, solver);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            return Iso;
        }
    }

    /// <summary>A field of the literature, calibrated as ours are.</summary>
    sealed class LiteratureVariant : DenseVariant
    {
        readonly ParticleField literature;
        readonly float iso;

        public LiteratureVariant(FluidShaderSet shaders, ParticleField literature, float cell)
            : base(shaders, cell)
        {
            this.literature = literature;
            iso = FieldCalibration.Iso(literature, cell);
        }

        /// <inheritdoc/>
        public override bool OnGpu => false;

        protected override float Fill(SurfaceField field, SurfaceState state, FluidSolver solver, Vector3[] positions)
        {
            field.Values.SetData(literature.Sample(new NeighbourSums(positions, solver.Settings), field.Grid));
            return iso;
        }
    }
}
