using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Places the rectangles on which the liquid's force is summed, for a step.</summary>
    internal sealed class PlaceWallPatchesPass : ComputePass
    {
        private static readonly int Asked = Id("_AskedPatches");
        private static readonly int PlacedOut = Id("_WallPatchesOut");
        private static readonly int PatchCount = Id("_PatchCount");
        private static readonly int FirstSum = Id("_FirstSum");
        private static readonly int BeginsPart = Id("_BeginsPart");

        private readonly ComputeKernel place, carry;

        public PlaceWallPatchesPass(FluidShaderSet shaders)
            : base(shaders, "PlaceWallPatches")
        {
            place = Kernel();
            carry = Kernel("CarryWallPatches");
        }

        /// <param name="cmd">Command buffer to record into, before the motion of a step.</param>
        /// <param name="state">The liquid.</param>
        /// <param name="forces">The rectangles.</param>
        /// <param name="count">Their number.</param>
        /// <param name="firstSum">Where the sums of the step begin.</param>
        /// <param name="begins">Whether these sums begin at 0.</param>
        /// <param name="isCarried">Whether a rectangle goes with a body.</param>
        public void Record(CommandBuffer cmd, FluidState state, WallForces forces, int count, int firstSum, bool begins, bool isCarried)
        {
            ComputeKernel kernel = isCarried ? carry : place;
            using (Sample(cmd))
            {
                if (isCarried)
                {
                    Vector3 step = state.BodyStep;
                    state.Bodies.Bind(cmd, kernel, step.x, step.y);
                }
                kernel.SetInt(cmd, PatchCount, count);
                kernel.SetInt(cmd, FirstSum, firstSum);
                kernel.SetBool(cmd, BeginsPart, begins);
                forces.Bind(cmd, kernel, Asked, PlacedOut);
                kernel.DispatchThreads(cmd, count);
            }
        }
    }
}
