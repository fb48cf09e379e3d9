using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>What the passes work on that methods with a counting sort share: cells, lists of neighbours, walls of triangles.</summary>
    internal abstract class CellState : FluidState
    {
        protected CellState(in FluidSolverSettings settings, int particleCount, bool isPlanned)
            : base(Countable(settings), particleCount, isPlanned, SparseCells.For(new CellRows(FluidGrid.For(settings)).CellCount))
        {
            IsPlanned = isPlanned;
            try
            {
                Cells = new CellRows(Grid);
                Buffers = new CellBuffers(particleCount, Cells.CellCount, Sparse, isPlanned);
            }
            catch
            {
                base.Dispose();
                throw;
            }
        }

        /// <summary>
        /// Below so many spacings from a mesh what a plane adds goes on with the slope that it has there: a film of one layer on a curved
        /// wall is else at the border of what the time step bears.
        /// </summary>
        public virtual float SteepestWall => 0.51f;

        /// <summary>Whether the faces of the domain are mirrors, which walls of triangles leave out.</summary>
        public virtual bool HasMirrors => false;

        /// <summary>Whether only the buffers' sizes are asked for.</summary>
        protected bool IsPlanned { get; }

        /// <summary>The cells of the sort: those of the grid and a border.</summary>
        public CellRows Cells { get; }

        /// <summary>The particles in the order of their cells.</summary>
        public CellBuffers Buffers { get; }

        /// <summary>Which parts of the liquid sleep; null: none do.</summary>
        public SleepBricks Sleep { get; private set; }

        /// <summary>Whether the method's passes leave out particles that sleep, with the forces that act.</summary>
        public virtual bool SleepsInParts => false;

        /// <inheritdoc/>
        public override void SetSleep(SleepRule? rule)
        {
            if (rule is SleepRule given && SleepsInParts)
            {
                Sleep ??= new SleepBricks(Cells, IsPlanned);
                Sleep.Rule = given;
                return;
            }
            if (Sleep != null) Retired.Add(Sleep);
            Sleep = null;
        }

        /// <inheritdoc/>
        public override void KeepAwake(IReadOnlyList<Bounds> boxes) => Sleep?.SetBoxes(boxes);

        /// <inheritdoc/>
        public override bool HasSleepers => Sleep != null && SleepsInParts;

        /// <inheritdoc/>
        public override IReadOnlyList<Bounds> ReadSleepers() => HasSleepers ? Sleep.ReadAsleep(Cells) : base.ReadSleepers();

        /// <inheritdoc/>
        public override bool Wake(bool all)
        {
            Sleep?.Wake(all);
            return HasSleepers;
        }

        /// <summary>Records the walls of triangles near particles that sleep, where <see cref="MeshWallBuffers.LackSleepers"/>.</summary>
        public Action<CommandBuffer> GatherAsleep { get; set; }

        /// <summary>What triangles need; null where there never were any.</summary>
        public MeshWallBuffers Walls { get; private set; }

        /// <summary>Neighbours of the last density pass; of length 0 for a step that searches twice.</summary>
        public NeighbourList List { get; private set; }

        /// <inheritdoc/>
        public override int CellCount => Cells.CellCount;

        /// <inheritdoc/>
        public override bool ListsNeighbours => List != null && List.Length > 0;

        /// <summary>
        /// Whether particles of a cell are ordered by their ids, so that equal runs are equal to the last bit; else by thread timing.
        /// </summary>
        public abstract bool HasStableOrder { get; }

        /// <summary>Whether neighbours are to be listed where the device's buffers hold the lists.</summary>
        protected abstract bool WantsLists { get; }

        /// <summary>A float4 a particle that the method takes along in the sort, in the order that a step leaves; null for none.</summary>
        public virtual FluidBuffer Carried => null;

        /// <summary>The same in the order of the sort.</summary>
        public virtual FluidBuffer CarriedSorted => null;

        /// <summary>
        /// Whether that is besides what <see cref="CellBuffers.NewPositions"/> take along, and its w a particle's
        /// <see cref="FluidParticle.DensityOffset"/>.
        /// </summary>
        public virtual bool CarriesBesides => false;

        /// <summary>Whether settings and device allow lists of neighbours.</summary>
        public bool MayListNeighbours => ListLength(Capacity) > 0;

        /// <summary>How long the next lists of neighbours are to serve, from the first step that uses them to the last [s].</summary>
        public float ListTime { get; set; }

        /// <inheritdoc/>
        protected override long OwnBytes => Buffers.Bytes + (Walls?.Bytes ?? 0) + (List?.Bytes ?? 0) + (Sleep?.Bytes ?? 0);

        /// <summary>Makes <see cref="Walls"/>, if they are not there.</summary>
        public void RequireWalls() => Walls ??= new MeshWallBuffers(Capacity, IsPlanned);

        /// <summary>Makes <see cref="List"/>, with entries or without as the settings and the device have it.</summary>
        public void RequireList()
        {
            int length = ListLength(Capacity);
            if (List != null && List.Length > 0 == length > 0) return;
            List?.Dispose();
            List = null;
            List = new NeighbourList(Capacity, length, IsPlanned);
        }

        /// <summary>Makes all buffers for another number of particles; what they held waits in <see cref="FluidState.Retired"/>.</summary>
        /// <param name="capacity">Number of slots.</param>
        /// <exception cref="FluidDeviceException">The device has too little memory for a buffer of this size.</exception>
        public void Resize(int capacity)
        {
            var replaced = new List<IDisposable>();
            NeighbourList list = new NeighbourList(capacity, ListLength(capacity));
            MeshWallBuffers walls = Walls == null ? null : new MeshWallBuffers(capacity);
            Buffers.Resize(capacity, replaced);
            ResizeOwn(capacity, replaced);
            Published.Resize(capacity, replaced);
            if (List != null) replaced.Add(List);
            if (Walls != null) replaced.Add(Walls);
            (List, Walls, Capacity) = (list, walls, capacity);
            if (Sleep != null) Sleep.Groups.AreListed = false;
            foreach (IDisposable old in replaced) Retired.Add(old);
        }

        /// <inheritdoc/>
        public override void BindNeighbourList(CommandBuffer cmd, ComputeKernel kernel)
        {
            if (ListsNeighbours) List.Set(cmd, kernel);
            else base.BindNeighbourList(cmd, kernel);
        }

        /// <inheritdoc/>
        public override void BindNearWalls(CommandBuffer cmd, ComputeKernel kernel)
        {
            bool isGathered = ListsNeighbours && HasBodies && Walls != null;
            kernel.SetKeyword(cmd, MeshWalls, isGathered);
            if (!isGathered) return;
            if (Walls.LackSleepers) GatherAsleep(cmd);
            kernel.Set(cmd, List.WallSlot);
            kernel.Set(cmd, Walls.NearWalls);
        }

        /// <summary>Makes the method's own buffers for another number of particles.</summary>
        protected virtual void ResizeOwn(int capacity, ICollection<IDisposable> replaced)
        {
        }

        // 0: both passes over the neighbours search.
        private int ListLength(int capacity)
        {
            int length = NeighbourList.LengthFor(Settings);
            return WantsLists && NeighbourList.Fits(capacity, length) ? length : 0;
        }

        // Too many cells are named before any buffer is made.
        private static FluidSolverSettings Countable(in FluidSolverSettings settings)
        {
            _ = new CellRows(FluidGrid.For(settings));
            return settings;
        }

        /// <inheritdoc/>
        public override void Dispose()
        {
            Sleep?.Dispose();
            Walls?.Dispose();
            List?.Dispose();
            Buffers.Dispose();
            base.Dispose();
        }
    }
}
