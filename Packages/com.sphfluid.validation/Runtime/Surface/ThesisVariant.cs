using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The thesis's field: density over rest density.</summary>
    internal sealed class ThesisVariant : DenseVariant
    {
        private readonly float iso;

        public ThesisVariant(FluidShaderSet shaders, float cell, float iso = 0.5f)
            : base(shaders, cell)
        {
            this.iso = iso;
        }

        /// <inheritdoc/>
        protected override float Fill(SurfaceField field, SurfaceState state, FluidSolver solver, Vector3[] positions)
        {
            GpuWork.Submit("Surface Variant", cmd => field.Record(cmd, solver));
            return iso;
        }
    }
}
