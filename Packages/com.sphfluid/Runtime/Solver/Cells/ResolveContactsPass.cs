using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Changes the steps that are not free of triangles; as many groups as <see cref="FindContactsPass"/> found work for.
    /// </summary>
    internal sealed class ResolveContactsPass : ComputePass
    {
        private static readonly int TimeStep = Id("_TimeStep");

        private readonly ComputeKernel kernel;

        public ResolveContactsPass(FluidShaderSet shaders)
            : base(shaders, "ResolveContacts")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer.</param>
        /// <param name="state">Buffers.</param>
        /// <param name="step">The step.</param>
        public void Record(CommandBuffer cmd, CellState state, in FluidStep step)
        {
            using (Sample(cmd))
            {
                MeshContact.SetStep(cmd, kernel, state, step);
                CellBindings.SetImpulses(cmd, kernel, state);
                WallForces.Set(cmd, kernel, state);
                kernel.SetFloat(cmd, TimeStep, step.Length);
                kernel.Set(cmd, state.Walls.Contacts);
                kernel.SetOut(cmd, state.Buffers.NewVelocities);
                kernel.DispatchIndirect(cmd, state.Walls.Contacts);
            }
        }
    }
}
