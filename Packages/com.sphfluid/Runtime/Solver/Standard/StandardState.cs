using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>What the passes of the Standard method work on.</summary>
    internal sealed class StandardState : CellState
    {
        public StandardState(in FluidSolverSettings settings, int particleCount, bool isPlanned = false) : base(settings, particleCount, isPlanned)
        {
        }

        /// <summary>What an implicit viscosity needs; null where it never was.</summary>
        public ViscousBuffers Viscous { get; private set; }

        /// <summary>The constants that only this method has.</summary>
        public StandardSettings Own => Settings.Own<StandardSettings>();

        /// <inheritdoc/>
        public override bool HasStableOrder => Own.StableOrder;

        /// <inheritdoc/>
        protected override bool WantsLists => Own.NeighbourList;

        /// <inheritdoc/>
        protected override long OwnBytes => base.OwnBytes + (Viscous?.Bytes ?? 0);

        /// <summary>Makes <see cref="Viscous"/>, if it is not there.</summary>
        public void RequireViscous() => Viscous ??= new ViscousBuffers(Capacity, IsPlanned);

        /// <inheritdoc/>
        public override void Dispose()
        {
            Viscous?.Dispose();
            base.Dispose();
        }

        /// <inheritdoc/>
        protected override void ResizeOwn(int capacity, ICollection<IDisposable> replaced)
        {
            if (Viscous == null) return;
            var viscous = new ViscousBuffers(capacity);
            replaced.Add(Viscous);
            Viscous = viscous;
        }
    }
}
