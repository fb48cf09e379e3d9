using UnityEngine;

namespace SphFluid
{
    /// <summary>What is needed only where there are triangles: walls near particles, and the list of contacts.</summary>
    internal sealed class MeshWallBuffers : BufferSet
    {
        /// <summary>Bytes of PackedWall in Shaders/Solver/Cells/MeshWalls.hlsl.</summary>
        public const int WallStride = 108;

        /// <summary>Of each particle 1 + the place of its walls in <see cref="NearWalls"/>, or 0.</summary>
        public readonly FluidBuffer WallSlot;

        /// <summary>PackedWall each.</summary>
        public readonly FluidBuffer NearWalls;

        /// <summary>Numbers of the bodies that the liquid moves, of each particle's planes.</summary>
        public readonly FluidBuffer WallBodies;

        /// <summary>
        /// Where each particle gathered its walls, and how near to there surely no triangle at rest is [m], 0 where that is not known.
        /// </summary>
        public readonly FluidBuffer WallGap;

        /// <summary>Particles whose step is not free.</summary>
        public readonly FluidBuffer ContactList;

        /// <summary>Groups that resolve them, x, y, z, and their number.</summary>
        public readonly FluidBuffer ContactArguments;

        public MeshWallBuffers(int particleCount, bool isPlanned = false) : base(isPlanned)
        {
            WallSlot = Add("WallSlot", particleCount, 4);
            NearWalls = Add("NearWalls", particleCount, WallStride);
            WallBodies = Add("WallBodies", particleCount, 4);
            WallGap = Add("WallGap", particleCount, 16);
            ContactList = Add("ContactList", particleCount, 4);
            // With Direct3D 11 Unity gives a buffer of indirect arguments typed and raw views, never structured ones.
            ContactArguments = Add("ContactArguments", 4, 4, GraphicsBuffer.Target.IndirectArguments | GraphicsBuffer.Target.Raw);
        }
    }
}
