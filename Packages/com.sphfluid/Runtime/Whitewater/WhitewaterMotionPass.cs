using System;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Moves whitewater on by a frame, and says of each piece whether it is spray, foam or a bubble (Ihmsen et al. 2012, section 3.2).
    /// </summary>
    internal sealed class WhitewaterMotionPass : ComputePass
    {
        /// <summary>What the air takes of a drop's velocity a metre [1/m].</summary>
        public const float SprayDrag = 0.1f;

        /// <summary>
        /// Speed at which bubbles rise in still water [m/s]: that of bubbles of 1 to 10 mm (Clift, Grace and Weber 1978).
        /// </summary>
        public const float BubbleRise = 0.24f;

        /// <summary>Time in which a bubble takes on the liquid's velocity [s].</summary>
        public const float BubbleTime = 0.03f;

        /// <summary>Time in which foam comes to lie on the surface [s].</summary>
        public const float SurfaceTime = 0.05f;

        /// <summary>Speed at which foam ages twice as fast as on still water [m/s].</summary>
        public const float FoamSpeed = 2f;

        private static readonly int Gravity = Id("_Gravity");
        private static readonly int Duration = Id("_Duration");
        private static readonly int Spacing = Id("_Spacing");
        private static readonly int SupportRadius = Id("_SupportRadius");
        private static readonly int FieldWeight = Id("_FieldWeight");
        private static readonly int NeighbourScale = Id("_NeighbourScale");
        private static readonly int SprayDragId = Id("_SprayDrag");
        private static readonly int BubbleRiseId = Id("_BubbleRise");
        private static readonly int BubbleTimeId = Id("_BubbleTime");
        private static readonly int SurfaceTimeId = Id("_SurfaceTime");
        private static readonly int FoamSpeedId = Id("_FoamSpeed");

        private readonly ComputeKernel kernel;

        public WhitewaterMotionPass(FluidShaderSet shaders)
            : base(shaders, "WhitewaterMotion")
        {
            kernel = Kernel();
        }

        /// <param name="cmd">Command buffer to record into, after the neighbour setup.</param>
        /// <param name="solver">The liquid at the end of the frame.</param>
        /// <param name="buffers">The pieces, which are changed in their places.</param>
        /// <param name="duration">Length of the frame [s].</param>
        public void Record(CommandBuffer cmd, FluidSolver solver, WhitewaterBuffers buffers, float duration)
        {
            FluidSolverSettings settings = solver.Settings;
            using (Sample(cmd))
            {
                solver.BindNeighbours(cmd, kernel);
                DomainBindings.SetFaces(cmd, kernel, settings);
                SetBodies(cmd, solver, buffers);
                kernel.SetOut(cmd, buffers.Present);
                kernel.Set(cmd, buffers.State);
                kernel.SetVector(cmd, Gravity, settings.Gravity);
                kernel.SetFloat(cmd, Duration, duration);
                kernel.SetFloat(cmd, Spacing, settings.Spacing);
                kernel.SetFloat(cmd, SupportRadius, settings.SupportRadius);
                kernel.SetFloat(cmd, FieldWeight,
                    (float)(Math.Pow(settings.Spacing / (double)settings.SupportRadius, 3.0) * 315.0 / (64.0 * Math.PI)));
                kernel.SetFloat(cmd, NeighbourScale, (float)Math.Pow(2.0 * settings.Spacing / settings.SupportRadius, 3.0));
                kernel.SetFloat(cmd, SprayDragId, SprayDrag);
                kernel.SetFloat(cmd, BubbleRiseId, BubbleRise);
                kernel.SetFloat(cmd, BubbleTimeId, BubbleTime);
                kernel.SetFloat(cmd, SurfaceTimeId, SurfaceTime);
                kernel.SetFloat(cmd, FoamSpeedId, FoamSpeed);
                kernel.DispatchThreads(cmd, buffers.Capacity);
            }
        }

        // The bodies' motion of the whole frame.
        private void SetBodies(CommandBuffer cmd, FluidSolver solver, WhitewaterBuffers buffers)
        {
            kernel.Set(cmd, buffers.NoBodies);
            kernel.Set(cmd, buffers.NoTriangles);
            kernel.Set(cmd, buffers.NoLists);
            if (solver.State.HasBodies) solver.State.Bodies.Bind(cmd, kernel, 0f, 1f);
        }
    }
}
