using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>What the passes of the Robust method work on.</summary>
    internal sealed class RobustState : CellState
    {
        public RobustState(in FluidSolverSettings settings, int particleCount, bool isPlanned = false)
            : base(settings, particleCount, isPlanned)
        {
            try
            {
                Motion = new RobustBuffers(particleCount, isPlanned);
            }
            catch
            {
                base.Dispose();
                throw;
            }
        }

        /// <summary>The method's own buffers.</summary>
        public RobustBuffers Motion { get; }

        /// <summary>The constants that only this method has.</summary>
        public RobustSettings Own => Settings.Own<RobustSettings>();

        /// <inheritdoc/>
        public override bool HasStableOrder => Own.StableOrder;

        /// <inheritdoc/>
        public override FluidBuffer Carried => Motion.NewStarts;

        /// <inheritdoc/>
        public override FluidBuffer CarriedSorted => Motion.Starts;

        /// <inheritdoc/>
        protected override bool WantsLists => Own.NeighbourList;

        /// <inheritdoc/>
        protected override long OwnBytes => base.OwnBytes + Motion.Bytes;

        /// <summary>Makes the prediction what a sort makes of it, in the order of the last one.</summary>
        public void TakePrediction()
        {
            FluidBuffer.Exchange(Buffers.Positions, Buffers.NewPositions);
            FluidBuffer.Exchange(Buffers.Velocities, Buffers.NewVelocities);
            FluidBuffer.Exchange(Motion.Starts, Motion.NewStarts);
        }

        /// <inheritdoc/>
        public override void Dispose()
        {
            Motion.Dispose();
            base.Dispose();
        }

        /// <inheritdoc/>
        protected override void ResizeOwn(int capacity, ICollection<IDisposable> replaced) => Motion.Resize(capacity, replaced);
    }
}
