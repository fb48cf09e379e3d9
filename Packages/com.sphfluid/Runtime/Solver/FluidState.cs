using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What the passes of a method work on: settings, grid, buffers, the scene's triangles.</summary>
    public sealed class FluidState : IDisposable
    {
        Vector3? bodyStep;
        int bodyVersion;

        internal FluidState(in FluidSolverSettings settings, int particleCount)
        {
            Settings = settings;
            Grid = FluidGrid.For(settings);
            bool isStandard = settings.Method == FluidMethodKind.Standard;
            if (isStandard) Cells = new CellRows(Grid);
            Buffers = new FluidBuffers(particleCount, Grid.CellCount);
            try
            {
                if (isStandard)
                {
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

        /// <summary>The scene's bodies for methods that prove motion free; null for none.</summary>
        internal CollisionBodies Bodies { get; set; }

        /// <summary>Whether there is a triangle to meet.</summary>
        internal bool HasBodies => Standard != null && Bodies != null && Bodies.Count > 0;

        /// <summary>Where the step begins and ends in the bodies' motion of the frame, 0 to 1, and its length [s].</summary>
        internal Vector3 BodyStep => bodyStep ?? (Bodies != null && Bodies.IsUnderWay ? new Vector3(0f, 0f, 1f) : Vector3.one);

        /// <summary>Whether walls found before these steps are out of date: bodies move, or others came.</summary>
        internal bool WallsChange()
        {
            int version = Bodies?.Version ?? 0;
            bool changed = version != bodyVersion || HasBodies && Bodies.IsUnderWay;
            bodyVersion = version;
            return Standard != null && changed;
        }

        internal void BeginBodyStep(int step, int steps, float length)
        {
            bool moves = Bodies != null && Bodies.IsUnderWay;
            bodyStep = moves ? new Vector3(step / (float)steps, (step + 1) / (float)steps, length) : new Vector3(1f, 1f, length);
        }

        internal void EndBodySteps()
        {
            Bodies?.Arrive();
            bodyStep = null;
        }

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
