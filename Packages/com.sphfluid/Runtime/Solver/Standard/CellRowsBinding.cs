using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The globals of Shaders/Solver/Standard/CellRows.hlsl.</summary>
    internal static class CellRowsBinding
    {
        static readonly int CellOrigin = Shader.PropertyToID("_CellOrigin");
        static readonly int CellsPerMetre = Shader.PropertyToID("_CellsPerMetre");
        static readonly int CellCounts = Shader.PropertyToID("_CellCounts");
        static readonly int CellStart = Shader.PropertyToID("_CellStart");

        // Copied when recorded, so one array serves; command buffers are recorded on the main thread.
        static readonly int[] Counts = new int[3];

        /// <summary>The cells.</summary>
        public static void Set(CommandBuffer cmd, ComputeKernel kernel, in CellRows cells)
        {
            Counts[0] = cells.Counts.x;
            Counts[1] = cells.Counts.y;
            Counts[2] = cells.Counts.z;
            Vector3 side = cells.CellSize;
            kernel.SetVector(cmd, CellOrigin, cells.Origin);
            kernel.SetVector(cmd, CellsPerMetre, new Vector3(1f / side.x, 1f / side.y, 1f / side.z));
            kernel.SetInts(cmd, CellCounts, Counts);
        }

        /// <summary>The cells and their particles.</summary>
        public static void Set(CommandBuffer cmd, ComputeKernel kernel, in CellRows cells, GraphicsBuffer cellStart)
        {
            Set(cmd, kernel, cells);
            kernel.SetBuffer(cmd, CellStart, cellStart);
        }
    }
}
