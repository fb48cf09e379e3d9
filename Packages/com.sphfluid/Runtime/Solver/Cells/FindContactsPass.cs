using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Proves every step free of every triangle and lists those that are not, for <see cref="ResolveContactsPass"/>.</summary>
    internal sealed class FindContactsPass : ComputePass
    {
        private static readonly int LongestDisplacement = Id("_LongestDisplacement");

        private readonly ComputeKernel kernel;

        public FindContactsPass(FluidShaderSet shaders)
            : base(shaders, "FindContacts")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="step">The step.</param>
        /// <param name="from">Where the step began, in the order of the particles.</param>
        public void Record(CommandBuffer cmd, CellState state, in FluidStep step, FluidBuffer from)
        {
            using (Sample(cmd))
            {
                MeshContact.SetStep(cmd, kernel, state, step);
                kernel.SetBuffer(cmd, state.Buffers.PositionTerms.Id, from);
                kernel.SetFloat(cmd, LongestDisplacement, ContactDistances.LongestDisplacement(state.Settings));
                kernel.SetOut(cmd, state.Walls.WallGap);
                AwakeGroups.Dispatch(cmd, kernel, state);
            }
        }
    }
}
