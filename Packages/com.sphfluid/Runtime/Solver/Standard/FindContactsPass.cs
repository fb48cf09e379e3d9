using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Proves every step free of every triangle and lists those that are not, for <see cref="ResolveContactsPass"/>.</summary>
    internal sealed class FindContactsPass : ComputePass
    {
        static readonly int LongestDisplacement = Id("_LongestDisplacement");

        readonly ComputeKernel kernel;

        public FindContactsPass(FluidShaderSet shaders)
            : base(shaders, "FindContacts")
        {
            kernel = Kernel();
        }

        public void Record(CommandBuffer cmd, StandardState state, in FluidStep step)
        {
            using (Sample(cmd))
            {
                MeshContact.SetStep(cmd, kernel, state, step);
                kernel.Set(cmd, state.Walls.WallGap);
                kernel.SetFloat(cmd, LongestDisplacement, ContactDistances.LongestDisplacement(state.Settings));
                kernel.SetOut(cmd, state.Walls.ContactList);
                kernel.SetOut(cmd, state.Walls.ContactArguments);
                kernel.DispatchThreads(cmd, state.ParticleCount);
            }
        }
    }
}
