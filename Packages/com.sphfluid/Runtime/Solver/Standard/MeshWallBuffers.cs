using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What the Standard method needs only where there are triangles: walls near particles, and the list of contacts.</summary>
    internal sealed class MeshWallBuffers : IDisposable
    {
        /// <summary>Bytes of PackedWall in Shaders/Solver/Standard/NearWall.hlsl.</summary>
        public const int WallStride = 48;

        // With Direct3D 11 Unity gives a buffer of indirect arguments typed and raw views, never structured ones.
        const GraphicsBuffer.Target ArgumentTarget = GraphicsBuffer.Target.IndirectArguments | GraphicsBuffer.Target.Raw;

        GraphicsBuffer wallSlot, nearWalls, contactList, contactArguments;

        public MeshWallBuffers(int particleCount)
        {
            try
            {
                wallSlot = GpuBuffers.Create("WallSlot", particleCount, 4);
                nearWalls = GpuBuffers.Create("NearWalls", particleCount, WallStride);
                contactList = GpuBuffers.Create("ContactList", particleCount, 4);
                contactArguments = GpuBuffers.Create("ContactArguments", 4, 4, ArgumentTarget);
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>Of each particle 1 + the place of its walls in <see cref="NearWalls"/>, or 0.</summary>
        public GraphicsBuffer WallSlot => wallSlot;

        /// <summary>PackedWall each.</summary>
        public GraphicsBuffer NearWalls => nearWalls;

        /// <summary>Particles whose step is not free.</summary>
        public GraphicsBuffer ContactList => contactList;

        /// <summary>Groups that resolve them, x, y, z, and their number.</summary>
        public GraphicsBuffer ContactArguments => contactArguments;

        /// <summary>Bytes of all buffers.</summary>
        public long Bytes => GpuBuffers.Size(wallSlot, nearWalls, contactList, contactArguments);

        public void Dispose()
        {
            GpuBuffers.Dispose(ref wallSlot);
            GpuBuffers.Dispose(ref nearWalls);
            GpuBuffers.Dispose(ref contactList);
            GpuBuffers.Dispose(ref contactArguments);
        }
    }
}
