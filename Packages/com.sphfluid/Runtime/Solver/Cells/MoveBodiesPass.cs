using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The rigid bodies that the liquid moves: where they are at a step's start, and what the step makes of them.</summary>
    internal sealed class MoveBodiesPass : ComputePass
    {
        private static readonly int Moves = Id("_Moves");
        private static readonly int Begins = Id("_Begins");
        private static readonly int TimeStep = Id("_TimeStep");
        private static readonly int KickStep = Id("_KickStep");
        private static readonly int PushPart = Id("_PushPart");

        private readonly ComputeKernel kernel, join;

        public MoveBodiesPass(FluidShaderSet shaders)
            : base(shaders, "MoveBodies")
        {
            kernel = Kernel();
            join = Kernel("JoinBodies");
        }

        /// <summary>Poses at the start of a step, and at its end by the present velocities; before the walls are gathered.</summary>
        public void RecordBegin(CommandBuffer cmd, CellState state)
        {
            FloatingBodies bodies = state.Bodies.Floating;
            Record(cmd, state, false, bodies.Begins, 0f);
            bodies.Begins = false;
        }

        /// <summary>Velocities after the step's impulses, and poses at its end; after the particles' motion.</summary>
        public void Record(CommandBuffer cmd, CellState state, in FluidStep step) =>
            Record(cmd, state, true, false, step.IsFirst ? 0.5f * step.Length : step.Kick);

        private void Record(CommandBuffer cmd, CellState state, bool moves, bool begins, float kick)
        {
            using (Sample(cmd))
            {
                if (moves && state.Bodies.Floating.Joins) Dispatch(cmd, state, join, kick);
                kernel.SetBool(cmd, Moves, moves);
                kernel.SetBool(cmd, Begins, begins);
                state.Bodies.SetOut(cmd, kernel);
                Dispatch(cmd, state, kernel, kick);
            }
        }

        private static void Dispatch(CommandBuffer cmd, CellState state, ComputeKernel kernel, float kick)
        {
            Vector3 step = state.BodyStep;
            kernel.SetFloat(cmd, TimeStep, step.z);
            kernel.SetFloat(cmd, KickStep, kick);
            kernel.SetFloat(cmd, PushPart, step.y - step.x);
            state.Bodies.Floating.SetMotion(cmd, kernel);
            kernel.DispatchThreads(cmd, state.Bodies.Floating.Count);
        }
    }
}
