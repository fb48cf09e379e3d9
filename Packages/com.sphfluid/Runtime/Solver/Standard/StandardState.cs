using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What the passes of the Standard method work on.</summary>
    internal sealed class StandardState : CellState
    {
        public StandardState(in FluidSolverSettings settings, int particleCount, bool isPlanned = false)
            : base(settings, particleCount, isPlanned)
        {
        }

        /// <summary>What an implicit viscosity needs; null where it never was.</summary>
        public ViscousBuffers Viscous { get; private set; }

        private readonly Dictionary<ParticleForce, BufferSet> forces = new Dictionary<ParticleForce, BufferSet>();

        private ICarriedBuffers carried;

        /// <summary>Whether the present step goes on in the order of an earlier one.</summary>
        public bool KeepsOrder { get; set; }

        /// <summary>How far the density is taken ahead where it grows, over the step before; 0 where that step is not known.</summary>
        public Vector2 Impact { get; set; }

        /// <summary>The constants that only this method has.</summary>
        public StandardSettings Own => Settings.Own<StandardSettings>();

        /// <inheritdoc/>
        public override bool HasStableOrder => Own.StableOrder;

        /// <summary>Forces with passes of their own walk over all particles, and so does what is summed on walls.</summary>
        public override bool SleepsInParts => !Own.ImplicitViscosity && !forces.Keys.Any(force => force.Acts(Own)) && WallForces == null;

        /// <inheritdoc/>
        public override FluidBuffer Carried => carried?.Carried;

        /// <inheritdoc/>
        public override FluidBuffer CarriedSorted => carried?.Sorted;

        /// <inheritdoc/>
        public override bool CarriesBesides => true;

        /// <inheritdoc/>
        protected override bool WantsLists => Own.NeighbourList;

        /// <inheritdoc/>
        protected override long OwnBytes => base.OwnBytes + (Viscous?.Bytes ?? 0) + forces.Values.Sum(buffers => buffers.Bytes);

        /// <summary>Makes <see cref="Viscous"/>, if it is not there.</summary>
        public void RequireViscous() => Viscous ??= new ViscousBuffers(Capacity, IsPlanned);

        /// <summary>0 with a force that needs whole walls.</summary>
        public override float SteepestWall => forces.Keys.Any(force => force.NeedsWholeWalls) ? 0f : base.SteepestWall;

        /// <inheritdoc/>
        public override bool HasMirrors => forces.Keys.Any(force => force.MakesMirrors);

        /// <summary>Makes the buffers of a force, if they are not there.</summary>
        public void RequireForce(ParticleForce force)
        {
            if (!forces.ContainsKey(force)) Keep(force, force.MakeBuffers(Capacity, IsPlanned));
        }

        /// <summary>
        /// Makes what forces that act take along in the sort, and drops what those that do not act took: it would be of another order.
        /// </summary>
        /// <param name="all">All forces.</param>
        public void RequireCarried(IReadOnlyList<ParticleForce> all)
        {
            foreach (ParticleForce force in all)
            {
                if (!force.Carries) continue;
                if (force.Acts(Own)) RequireForce(force);
                else if (forces.Remove(force, out BufferSet buffers))
                {
                    carried = null;
                    Retired.Add(buffers);
                }
            }
        }

        /// <summary>Behind a sort: what was taken along is in its order.</summary>
        public void ExchangeCarried()
        {
            if (carried != null) FluidBuffer.Exchange(carried.Carried, carried.Sorted);
        }

        /// <summary>Buffers of a force, by their type; null where it never acted.</summary>
        public T ForceBuffers<T>() where T : BufferSet => forces.Values.OfType<T>().FirstOrDefault();

        /// <inheritdoc/>
        public override void Dispose()
        {
            Viscous?.Dispose();
            foreach (BufferSet buffers in forces.Values) buffers.Dispose();
            base.Dispose();
        }

        /// <inheritdoc/>
        protected override void ResizeOwn(int capacity, ICollection<IDisposable> replaced)
        {
            ViscousBuffers viscous = Viscous == null ? null : new ViscousBuffers(capacity);
            if (Viscous != null) replaced.Add(Viscous);
            Viscous = viscous;
            foreach (ParticleForce force in forces.Keys.ToArray())
            {
                BufferSet buffers = force.MakeBuffers(capacity, false);
                replaced.Add(forces[force]);
                Keep(force, buffers);
            }
        }

        private void Keep(ParticleForce force, BufferSet buffers)
        {
            forces[force] = buffers;
            carried = buffers as ICarriedBuffers ?? carried;
        }
    }
}
