using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What the passes of a method work on: settings, grid, buffers, the scene's triangles.</summary>
    public sealed class FluidState : IDisposable
    {
        internal FluidState(in FluidSolverSettings settings, int particleCount, FluidMethodKind kind = FluidMethodKind.Thesis)
        {
            Settings = settings;
            Grid = FluidGrid.For(settings);
            Buffers = new FluidBuffers(particleCount, Grid.CellCount);
            try
            {
                if (kind == FluidMethodKind.Standard)
                {
                    Cells = new CellRows(Grid);
                    Standard = new StandardBuffers(particleCount, Cells.CellCount);
                }
                else
                {
                    Thesis = new ThesisBuffers(particleCount);
                }
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        /// <summary>The physics, SI.</summary>
        public FluidSolverSettings Settings { get; internal set; }

        /// <summary>The grid over the domain.</summary>
        public FluidGrid Grid { get; }

        /// <summary>The buffers.</summary>
        public FluidBuffers Buffers { get; }

        /// <summary>The thesis method's own buffers; null with another method.</summary>
        public ThesisBuffers Thesis { get; }

        /// <summary>The Standard method's cells; those of <see cref="Grid"/> and a border.</summary>
        internal CellRows Cells { get; }

        /// <summary>The Standard method's own buffers; null with another method.</summary>
        internal StandardBuffers Standard { get; }

        /// <summary>Bytes of all buffers; the triangles belong to their maker.</summary>
        public long Bytes => Buffers.Bytes + (Thesis?.Bytes ?? 0) + (Standard?.Bytes ?? 0);

        /// <summary>Number of particles.</summary>
        public int ParticleCount => Buffers.ParticleCount;

        /// <summary>Triangles of the scene, CollisionTriangle in Shaders/Collision/CollisionTypes.hlsl; never null.</summary>
        public GraphicsBuffer Triangles { get; private set; }

        /// <summary>Meshes of the scene, CollisionCollider in Shaders/Collision/CollisionTypes.hlsl; never null.</summary>
        public GraphicsBuffer Colliders { get; private set; }

        /// <summary>Number of meshes.</summary>
        public int ColliderCount { get; private set; }

        internal void SetTriangles(GraphicsBuffer triangles, GraphicsBuffer colliders, int colliderCount)
        {
            bool none = triangles == null || colliders == null || colliderCount == 0;
            Triangles = none ? Buffers.NoTriangles : triangles;
            Colliders = none ? Buffers.NoColliders : colliders;
            ColliderCount = none ? 0 : colliderCount;
        }

        /// <summary>Releases the buffers that the state made; the triangles belong to their maker.</summary>
        public void Dispose()
        {
            Buffers.Dispose();
            Thesis?.Dispose();
            Standard?.Dispose();
        }
    }
}
