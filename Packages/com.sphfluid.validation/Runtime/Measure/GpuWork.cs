using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>Commands that are recorded and submitted at once.</summary>
    internal static class GpuWork
    {
        // One submission, besides its work: a command buffer of so many is recorded before the GPU has anything to do.
        private const int StepsPerSubmission = 50;

        /// <summary>Submits commands.</summary>
        /// <param name="name">Name in frame debuggers.</param>
        /// <param name="record">Records them.</param>
        public static void Submit(string name, Action<CommandBuffer> record)
        {
            using (var cmd = new CommandBuffer { name = name })
            {
                record(cmd);
                Graphics.ExecuteCommandBuffer(cmd);
            }
        }

        /// <summary>Submits steps of a solver.</summary>
        /// <param name="name">Name in frame debuggers.</param>
        /// <param name="solver">The solver.</param>
        /// <param name="steps">Number of steps.</param>
        public static void Step(string name, FluidSolver solver, long steps)
        {
            int most = Math.Max(1, Math.Min(StepsPerSubmission, FluidSolver.WorkPerSubmission / Math.Max(1, solver.ParticleCount)));
            for (; steps > 0; steps -= most)
            {
                int now = (int)Math.Min(most, steps);
                Submit(name, cmd => solver.RecordSteps(cmd, now));
            }
        }
    }
}
