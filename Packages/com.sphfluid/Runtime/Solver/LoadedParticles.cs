using System;
using System.Collections.Generic;
using Unity.Collections;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The particles that a solver was given, and how many of those since counted by the GPU live.</summary>
    internal sealed class LoadedParticles
    {
        private static readonly FluidParticle[] NoParticle = { new FluidParticle { Removed = 1f } };

        private readonly IFluidStepper stepper;
        private readonly FluidState state;
        private readonly CounterReadback counters;
        private long loaded, bornBefore, removedBefore;

        /// <param name="stepper">What steps them.</param>
        /// <param name="counters">What the GPU has counted.</param>
        public LoadedParticles(IFluidStepper stepper, CounterReadback counters)
        {
            this.stepper = stepper;
            this.counters = counters;
            state = stepper.State;
        }

        /// <summary>An id that no particle has, nor those that follow.</summary>
        public uint NextId { get; set; }

        /// <summary>Particles that live, as of the last finished read-back.</summary>
        public long LiveCount => loaded + counters.Counters.Born - bornBefore - (counters.Counters.Removed - removedBefore);

        /// <summary>Checks that a liquid can start from particles.</summary>
        /// <param name="settings">The physics.</param>
        /// <param name="initial">The particles.</param>
        /// <param name="isFixed">Whether all of them count: the method has a fixed number, of one or more.</param>
        /// <param name="name">Name of the caller's argument.</param>
        /// <returns>A copy of them; without those that are marked as removed where the number may change.</returns>
        /// <exception cref="ArgumentException">There is no particle, one lies outside the domain, or an offset of the density is not
        /// finite.</exception>
        public static FluidParticle[] Check(in FluidSolverSettings settings, IReadOnlyList<FluidParticle> initial, bool isFixed,
            string name)
        {
            if (initial == null || isFixed && initial.Count == 0) throw new ArgumentException("A fluid needs one particle or more.", name);
            var particles = new FluidParticle[initial.Count];
            int count = 0, outside = 0, unknown = 0;
            for (int i = 0; i < particles.Length; i++)
            {
                if (!isFixed && initial[i].IsRemoved) continue;
                outside += DomainSpace.Holds(initial[i].Position, settings.DomainSize) ? 0 : 1;
                unknown += AffineMath.IsFinite(initial[i].DensityOffset) ? 0 : 1;
                particles[count++] = initial[i];
            }

            if (outside > 0)
            {
                throw new ArgumentException(
                    $"{outside} of {particles.Length} particles lie outside the domain of {settings.DomainSize} m. Move the liquid or " +
                    "enlarge the domain.",
                    name);
            }

            if (unknown > 0)
            {
                throw new ArgumentException(
                    $"{unknown} of {particles.Length} particles have a DensityOffset that is not finite. Set it to 0: the liquid finds it.",
                    name);
            }

            Array.Resize(ref particles, count);
            return particles;
        }

        /// <summary>Slots that a liquid starts with.</summary>
        /// <param name="method">Its method.</param>
        /// <param name="count">Number of particles.</param>
        /// <param name="capacity">Slots that were asked for, where particles can come in.</param>
        public static int SlotsFor(FluidMethod method, int count, int capacity) =>
            Math.Max(1, Math.Max(count, method.Has(FluidMethodFeatures.ChangingCount) ? capacity : 0));

        /// <summary>Uploads particles, for which there are slots.</summary>
        public void Upload(FluidParticle[] particles)
        {
            state.Published.Particles.SetData(particles.Length > 0 ? particles : NoParticle);
            state.LoadedCount = particles.Length;
            state.ParticleCount = Math.Max(1, particles.Length);
            loaded = particles.Length;
            foreach (FluidParticle particle in particles) NextId = Math.Max(NextId, unchecked(particle.Id + 1u));
        }

        /// <summary>Uploads particles in the place of the present ones, whose counts have been read.</summary>
        public void Replace(FluidParticle[] live)
        {
            if (live.Length > state.Capacity) ((IExchangingStepper)stepper).Reserve(null, live.Length);
            Upload(live);
            (bornBefore, removedBefore) = (counters.Counters.Born, counters.Counters.Removed);
        }

        /// <summary>Uploads particles in the place of the present ones, for which there are slots; nothing is born among them.</summary>
        /// <param name="shown">The particles.</param>
        /// <param name="count">Number of them.</param>
        /// <exception cref="ArgumentException">There are more than slots.</exception>
        public void Show(NativeArray<FluidParticle> shown, int count)
        {
            GraphicsBuffer published = state.Published.Particles;
            if (count > state.Capacity)
            {
                throw new ArgumentException(
                    $"A frame of the playback has {count} particles, more than the {state.Capacity} that its MostParticles gave at the " +
                    "start.");
            }
            if (count > 0) published.SetData(shown, 0, 0, count);
            else published.SetData(NoParticle);
            state.LoadedCount = count;
            state.ParticleCount = Math.Max(1, count);
            loaded = count;
        }

        /// <summary>
        /// Lowers the number of slots in use to what the GPU's counts leave possible, and frees what nothing uses any more.
        /// </summary>
        /// <param name="exchange">What comes and goes; null: nothing.</param>
        public void Bound(ParticleExchange exchange)
        {
            state.Retired.Release(counters.Received - 1);
            if (exchange == null) return;
            FluidCounters known = counters.Counters;
            exchange.Bound(LiveCount, known.Born + known.Blocked + known.Refused);
        }
    }
}
