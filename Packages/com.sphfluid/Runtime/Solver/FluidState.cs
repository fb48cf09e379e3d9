using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// What the passes of every method work on: settings, grid, published buffers, the scene's walls. A method adds its own.
    /// </summary>
    internal abstract class FluidState : IDisposable
    {
        /// <summary>Keyword of kernels that read the walls of triangles near particles.</summary>
        public const string MeshWalls = "FLUID_MESH_WALLS";

        private Vector3? bodyStep;
        private int bodyVersion;

        /// <param name="settings">The physics.</param>
        /// <param name="particleCount">Slots for particles.</param>
        /// <param name="isPlanned">Whether only the buffers' sizes are asked for: no memory is taken, and nothing can be recorded.</param>
        /// <param name="sparse">Whether the published cells are those with particles only, and how these are stored.</param>
        protected FluidState(in FluidSolverSettings settings, int particleCount, bool isPlanned, SparseCells sparse = default)
        {
            Settings = settings;
            Grid = FluidGrid.For(settings);
            Sparse = sparse;
            Published = new PublishedBuffers(particleCount, Grid.CellCount, sparse, isPlanned);
            Capacity = ParticleCount = LoadedCount = particleCount;
            SetTriangles(null, null, 0);
        }

        /// <summary>The physics, SI.</summary>
        public FluidSolverSettings Settings { get; set; }

        /// <summary>The grid over the domain, by which readers find neighbours.</summary>
        public FluidGrid Grid { get; }

        /// <summary>How cells are stored where only those with particles are.</summary>
        public SparseCells Sparse { get; }

        /// <summary>What readers see.</summary>
        public PublishedBuffers Published { get; }

        /// <summary>Cells of the method's own neighbour search.</summary>
        public virtual int CellCount => Grid.CellCount;

        /// <summary>Whether neighbours are listed.</summary>
        public virtual bool ListsNeighbours => false;

        /// <summary>Bytes of the method's own buffers.</summary>
        protected abstract long OwnBytes { get; }

        /// <summary>The scene's bodies for methods that prove motion free; null for none.</summary>
        public CollisionBodies Bodies { get; set; }

        /// <summary>Force zones for methods that have them; null for none.</summary>
        public ForceZones Zones { get; set; }

        /// <summary>The walls on which the liquid's force is summed, for methods that do so; null for none.</summary>
        public WallForces WallForces { get; set; }

        /// <summary>Whether there is a triangle that a step can hit.</summary>
        public bool HasBodies => Bodies != null && Bodies.Count > 0;

        /// <summary>Whether there are bodies that the liquid moves.</summary>
        public bool HasFloatingBodies => HasBodies && Bodies.Floating.Count > 0;

        /// <summary>Where the step begins and ends in the bodies' motion of the frame, 0 to 1, and its length [s].</summary>
        public Vector3 BodyStep => bodyStep ?? (Bodies != null && Bodies.IsUnderWay ? new Vector3(0f, 0f, 1f) : Vector3.one);

        /// <summary>Bytes of all buffers; the triangles belong to their maker.</summary>
        public long Bytes => Published.Bytes + OwnBytes;

        /// <summary>Slots for particles.</summary>
        public int Capacity { get; protected set; }

        /// <summary>
        /// Slots in use: live particles are the first of these, those that left may be among the last. Passes have a thread for each.
        /// </summary>
        public int ParticleCount { get; set; }

        /// <summary>Particles in <see cref="Published"/> that the next load takes.</summary>
        public int LoadedCount { get; set; }

        /// <summary>Whether particles were marked to leave in the step that is recorded.</summary>
        public bool IsDrained { get; set; }

        /// <summary>Buffers that were replaced.</summary>
        public RetiredBuffers Retired { get; } = new RetiredBuffers();

        /// <summary>Triangles of the scene, CollisionTriangle in Shaders/Collision/CollisionTypes.hlsl; never null.</summary>
        public GraphicsBuffer Triangles { get; private set; }

        /// <summary>Meshes of the scene, CollisionCollider in Shaders/Collision/CollisionTypes.hlsl; never null.</summary>
        public GraphicsBuffer Colliders { get; private set; }

        /// <summary>Number of meshes.</summary>
        public int ColliderCount { get; private set; }

        /// <summary>Whether walls found before these steps are out of date: bodies move, or others came.</summary>
        public bool WallsChange()
        {
            int version = Bodies?.Version ?? 0;
            bool changed = version != bodyVersion || HasBodies && Bodies.IsUnderWay;
            bodyVersion = version;
            return changed;
        }

        public void BeginBodyStep(int step, int steps, float length)
        {
            bool moves = Bodies != null && Bodies.IsUnderWay;
            bodyStep = moves ? new Vector3(step / (float)steps, (step + 1) / (float)steps, length) : new Vector3(1f, 1f, length);
        }

        public void EndBodySteps()
        {
            Bodies?.Arrive();
            bodyStep = null;
        }

        public void SetTriangles(GraphicsBuffer triangles, GraphicsBuffer colliders, int colliderCount)
        {
            bool none = triangles == null || colliders == null || colliderCount == 0;
            Triangles = none ? Published.NoTriangles : triangles;
            Colliders = none ? Published.NoColliders : colliders;
            ColliderCount = none ? 0 : colliderCount;
        }

        /// <summary>Lets parts of the liquid sleep, for methods that can; null: none.</summary>
        public virtual void SetSleep(SleepRule? rule)
        {
        }

        /// <summary>Where the liquid of the next steps is kept awake, in boxes of simulation space [m].</summary>
        public virtual void KeepAwake(IReadOnlyList<Bounds> boxes)
        {
        }

        /// <summary>Whether parts of the liquid may sleep now.</summary>
        public virtual bool HasSleepers => false;

        /// <summary>Where the liquid sleeps, in boxes of simulation space [m]; waits for the GPU.</summary>
        public virtual IReadOnlyList<Bounds> ReadSleepers() => Array.Empty<Bounds>();

        /// <summary>What sleeps wakes with the next neighbour setup.</summary>
        /// <param name="all">Or only what is kept awake.</param>
        /// <returns>Whether anything may sleep.</returns>
        public virtual bool Wake(bool all) => false;

        /// <summary>Records the list of neighbours, or one of length 0, for a kernel that reads it.</summary>
        public virtual void BindNeighbourList(CommandBuffer cmd, ComputeKernel kernel) =>
            GridNeighbours.SetNoList(cmd, kernel, Published.Density);

        /// <summary>Records the walls near particles for a kernel that reads them; its keyword is off where there are none.</summary>
        public virtual void BindNearWalls(CommandBuffer cmd, ComputeKernel kernel) => kernel.SetKeyword(cmd, MeshWalls, false);

        /// <summary>Releases the buffers that the state made; the triangles belong to their maker.</summary>
        public virtual void Dispose()
        {
            Retired.Dispose();
            Published.Dispose();
        }
    }
}
