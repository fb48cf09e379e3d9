using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Which groups of sorted particles have one that is awake, so that the steps pass over the others
    /// (Shaders/Solver/Cells/Sleep/Sleeping.hlsl). The lists hold from a sort to the next.
    /// </summary>
    internal sealed class AwakeGroups
    {
        /// <summary>ALL_GROUPS in Sleeping.hlsl: there are no lists.</summary>
        public static readonly uint[] All = { uint.MaxValue };

        // CELL_THREADS in Shaders/Solver/Cells/CellRows.hlsl.
        private const int GroupSize = 64;

        private static readonly int ListBegin = Shader.PropertyToID("_GroupListBegin");
        private static readonly int AwakeBegin = Shader.PropertyToID("_AwakeGroupsBegin");
        private static readonly int AsleepBegin = Shader.PropertyToID("_AsleepGroupsBegin");
        private static readonly uint[] None = { 0u };

        // Groups along x, y and z, and nothing, of each list: one at least, as the first of a dispatch empties what others fill.
        private static readonly uint[] NoGroups = { 1u, 1u, 1u, 0u, 1u, 1u, 1u, 0u };

        private const uint AsleepArguments = 4 * sizeof(uint);

        private readonly FluidBuffer arguments;

        /// <param name="arguments">For dispatches over the two lists.</param>
        public AwakeGroups(FluidBuffer arguments) => this.arguments = arguments;

        /// <summary>Numbers of <c>_SleepArguments</c>.</summary>
        public static int ArgumentWords => NoGroups.Length;

        /// <summary>Whether there are lists of the present order.</summary>
        public bool AreListed { get; set; }

        /// <summary>Numbers of the lists for that many particles.</summary>
        public static long Words(int particleCount) => All.Length + 2L * ListWords(particleCount);

        /// <summary>Whether a dispatch over the awake leaves any particle out.</summary>
        public static bool AreLeftOut(CellState state) => state.HasSleepers && state.Sleep.Groups.AreListed;

        /// <summary>Records a dispatch over the groups with a particle that is awake.</summary>
        public static void Dispatch(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            if (!AreLeftOut(state))
            {
                DispatchAll(cmd, kernel, state);
                return;
            }
            kernel.SetInt(cmd, ListBegin, FirstList(state));
            kernel.DispatchIndirect(cmd, state.Sleep.Groups.arguments);
        }

        /// <summary>Records a dispatch over all groups.</summary>
        public static void DispatchAll(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            kernel.SetInt(cmd, ListBegin, state.Buffers.GroupLists.Begin);
            kernel.DispatchThreads(cmd, state.ParticleCount);
        }

        /// <summary>Records a dispatch over the others.</summary>
        public void DispatchAsleep(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            kernel.SetInt(cmd, ListBegin, SecondList(state));
            kernel.DispatchIndirect(cmd, arguments, AsleepArguments);
        }

        /// <summary>Empties the lists for a kernel that fills them.</summary>
        public void Begin(CommandBuffer cmd, ComputeKernel kernel, CellState state)
        {
            cmd.SetBufferData(arguments, NoGroups);
            cmd.SetBufferData(state.Buffers.CellTable, None, 0, FirstList(state), 1);
            cmd.SetBufferData(state.Buffers.CellTable, None, 0, SecondList(state), 1);
            kernel.SetInt(cmd, AwakeBegin, FirstList(state));
            kernel.SetInt(cmd, AsleepBegin, SecondList(state));
            kernel.SetOut(cmd, arguments);
            kernel.SetOut(cmd, state.Buffers.CellTable);
            AreListed = true;
        }

        private static int FirstList(CellState state) => state.Buffers.GroupLists.Begin + All.Length;

        private static int SecondList(CellState state) => FirstList(state) + ListWords(state.Capacity);

        // How many there are, and which.
        private static int ListWords(int particleCount) => 1 + (particleCount + GroupSize - 1) / GroupSize;
    }
}
