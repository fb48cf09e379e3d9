using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The field of Zhu and Bridson, its iso value calibrated as ours are.</summary>
    internal sealed class ZhuBridsonVariant : DenseVariant
    {
        private readonly float iso;

        public ZhuBridsonVariant(FluidShaderSet shaders, float cell)
            : base(shaders, cell)
        {
            iso = ZhuBridsonCalibration.Iso(cell);
        }

        /// <inheritdoc/>
        public override bool OnGpu => false;

        /// <inheritdoc/>
        protected override float Fill(SurfaceField field, SurfaceState state, FluidSolver solver, Vector3[] positions)
        {
            field.Values.SetData(ZhuBridsonField.Sample(positions, solver.Settings, field.Grid));
            return iso;
        }
    }
}
