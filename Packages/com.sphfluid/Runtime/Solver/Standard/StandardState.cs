using System;
using System.Collections.Generic;
using UnityEngine;

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

        /// <summary>What surface tension needs; null where there never was any.</summary>
        public TensionBuffers Tension { get; private set; }

        /// <summary>How far the density is taken ahead where it grows, over the step before; 0 where that step is not known.</summary>
        public Vector2 Impact { get; set; }

        /// <summary>The constants that only this method has.</summary>
        public StandardSettings Own => Settings.Own<StandardSettings>();

        /// <inheritdoc/>
        public override bool HasStableOrder => Own.StableOrder;

        /// <inheritdoc/>
        protected override bool WantsLists => Own.NeighbourList;

        /// <inheritdoc/>
        protected override long OwnBytes => base.OwnBytes + (Viscous?.Bytes ?? 0) + (Tension?.Bytes ?? 0);

        /// <summary>Makes <see cref="Viscous"/>, if it is not there.</summary>
        public void RequireViscous() => Viscous ??= new ViscousBuffers(Capacity, IsPlanned);

        /// <summary>0 with surface tension, whose constants are calibrated with the whole profile.</summary>
        public override float SteepestWall => Tension != null ? 0f : base.SteepestWall;

        /// <summary>Makes <see cref="Tension"/>, if it is not there.</summary>
        public void RequireTension() => Tension ??= new TensionBuffers(Capacity, IsPlanned);

        /// <inheritdoc/>
        public override void Dispose()
        {
            Viscous?.Dispose();
            Tension?.Dispose();
            base.Dispose();
        }

        /// <inheritdoc/>
        protected override void ResizeOwn(int capacity, ICollection<IDisposable> replaced)
        {
            ViscousBuffers viscous = Viscous == null ? null : new ViscousBuffers(capacity);
            TensionBuffers tension = Tension == null ? null : new TensionBuffers(capacity);
            if (Viscous != null) replaced.Add(Viscous);
            if (Tension != null) replaced.Add(Tension);
            (Viscous, Tension) = (viscous, tension);
        }
    }
}
