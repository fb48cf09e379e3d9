using System;
using System.Collections.Generic;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>What the passes of the Standard method work on.</summary>
    internal sealed class StandardState : FluidState
    {
        readonly bool isPlanned;

        public StandardState(in FluidSolverSettings settings, int particleCount, bool isPlanned = false)
            : base(Countable(settings), particleCount, isPlanned)
        {
            this.isPlanned = isPlanned;
            try
            {
                Cells = new CellRows(Grid);
                Buffers = new StandardBuffers(particleCount, Cells.CellCount, isPlanned);
            }
            catch
            {
                base.Dispose();
                throw;
            }
        }

        /// <summary>The cells of the sort: those of the grid and a border.</summary>
        public CellRows Cells { get; }

        /// <summary>The method's own buffers.</summary>
        public StandardBuffers Buffers { get; }

        /// <summary>What triangles need; null where there never were any.</summary>
        public MeshWallBuffers Walls { get; private set; }

        /// <summary>What an implicit viscosity needs; null where it never was.</summary>
        public ViscousBuffers Viscous { get; private set; }

        /// <summary>Neighbours of the last density pass; of length 0 for a step that searches twice.</summary>
        public NeighbourList List { get; private set; }

        /// <inheritdoc/>
        public override int CellCount => Cells.CellCount;

        /// <inheritdoc/>
        public override bool ListsNeighbours => List != null && List.Length > 0;

        /// <summary>Whether settings and device allow lists of neighbours.</summary>
        public bool MayListNeighbours => Own.NeighbourList && NeighbourList.Fits(Capacity, NeighbourList.LengthFor(Settings));

        /// <summary>How long the next lists of neighbours are to serve, from the first step that uses them to the last [s].</summary>
        public float ListTime { get; set; }

        /// <summary>The constants that only this method has.</summary>
        public StandardSettings Own => Settings.Own<StandardSettings>();

        /// <inheritdoc/>
        protected override long OwnBytes => Buffers.Bytes + (Walls?.Bytes ?? 0) + (List?.Bytes ?? 0) + (Viscous?.Bytes ?? 0);

        /// <summary>Makes <see cref="Walls"/>, if they are not there.</summary>
        public void RequireWalls() => Walls ??= new MeshWallBuffers(Capacity, isPlanned);

        /// <summary>Makes <see cref="Viscous"/>, if it is not there.</summary>
        public void RequireViscous() => Viscous ??= new ViscousBuffers(Capacity, isPlanned);

        /// <summary>Makes <see cref="List"/>, with entries or without as the settings and the device have it.</summary>
        public void RequireList()
        {
            int length = MayListNeighbours ? NeighbourList.LengthFor(Settings) : 0;
            if (List != null && List.Length > 0 == length > 0) return;
            List?.Dispose();
            List = null;
            List = new NeighbourList(Capacity, length, isPlanned);
        }

        /// <summary>Makes all buffers for another number of particles; what they held waits in <see cref="FluidState.Retired"/>.</summary>
        /// <param name="capacity">Number of slots.</param>
        /// <exception cref="FluidDeviceException">The device has too little memory for a buffer of this size.</exception>
        public void Resize(int capacity)
        {
            int length = Own.NeighbourList && NeighbourList.Fits(capacity, NeighbourList.LengthFor(Settings)) ? NeighbourList.LengthFor(Settings) : 0;
            var replaced = new List<IDisposable>();
            NeighbourList list = new NeighbourList(capacity, length);
            MeshWallBuffers walls = Walls == null ? null : new MeshWallBuffers(capacity);
            ViscousBuffers viscous = Viscous == null ? null : new ViscousBuffers(capacity);
            Buffers.Resize(capacity, replaced);
            Published.Resize(capacity, replaced);
            if (List != null) replaced.Add(List);
            if (Walls != null) replaced.Add(Walls);
            if (Viscous != null) replaced.Add(Viscous);
            (List, Walls, Viscous, Capacity) = (list, walls, viscous, capacity);
            foreach (IDisposable old in replaced) Retired.Add(old);
        }

        /// <inheritdoc/>
        public override void BindNeighbourList(CommandBuffer cmd, ComputeKernel kernel)
        {
            if (ListsNeighbours) List.Set(cmd, kernel);
            else base.BindNeighbourList(cmd, kernel);
        }

        // Too many cells are named before any buffer is made.
        static FluidSolverSettings Countable(in FluidSolverSettings settings)
        {
            _ = new CellRows(FluidGrid.For(settings));
            return settings;
        }

        /// <inheritdoc/>
        public override void Dispose()
        {
            Walls?.Dispose();
            List?.Dispose();
            Viscous?.Dispose();
            Buffers.Dispose();
            base.Dispose();
        }
    }
}
