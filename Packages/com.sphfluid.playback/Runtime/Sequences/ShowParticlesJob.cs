using System;
using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using UnityEngine;

namespace SphFluid
{
    /// <summary>How particles go from one frame to the next.</summary>
    internal enum SequenceBlend
    {
        /// <summary>Along a straight line: positions are all that is known.</summary>
        Linear,

        /// <summary>By cubic Hermite interpolation: positions and velocities of both frames are met.</summary>
        Hermite,
    }

    /// <summary>
    /// The particles at a place between two frames, found in both by their numbers. One that is in one frame only flies straight on and is
    /// there up to the middle. What is outside of the domain or no number is left out and counted; what interpolation alone would carry
    /// through a face stays at it.
    /// </summary>
    [BurstCompile(FloatPrecision.High, FloatMode.Strict)]
    internal struct ShowParticlesJob : IJob
    {
        /// <summary>Places in <see cref="Counts"/>.</summary>
        public const int Shown = 0, Outside = 1, NotFinite = 2, CountLength = 3;

        /// <summary>Particles of the frames, by ascending numbers.</summary>
        [ReadOnly] public NativeArray<StoredParticle> From, To;

        public int FromCount, ToCount;

        /// <summary>Part of the way behind, 0 up to 1; at 0 <see cref="To"/> is not looked at.</summary>
        public float Share;

        /// <summary>Time from frame to frame [s].</summary>
        public float Duration;

        public SequenceBlend Blend;

        /// <summary>Half the edge lengths of the domain [m].</summary>
        public Vector3 Half;

        /// <summary>Lengths of periodic axes, 0 of others [m].</summary>
        public Vector3 Period;

        /// <summary>Receives the particles; place for those of both frames.</summary>
        public NativeArray<FluidParticle> Particles;

        public NativeArray<int> Counts;

        private int shown, outside, notFinite;

        public void Execute()
        {
            shown = outside = notFinite = 0;
            ReadOnlySpan<StoredParticle> from = From.AsReadOnlySpan().Slice(0, FromCount);
            Span<FluidParticle> particles = Particles.AsSpan();
            if (Share > 0f) Merge(from, To.AsReadOnlySpan().Slice(0, ToCount), particles);
            else
                foreach (StoredParticle particle in from) Add(particles, particle.Position, particle.Velocity, particle.Id, false);
            (Counts[Shown], Counts[Outside], Counts[NotFinite]) = (shown, outside, notFinite);
        }

        private void Merge(ReadOnlySpan<StoredParticle> from, ReadOnlySpan<StoredParticle> to, Span<FluidParticle> particles)
        {
            int a = 0, b = 0;
            while (a < from.Length || b < to.Length)
            {
                if (b == to.Length || a < from.Length && from[a].Id < to[b].Id)
                {
                    if (Share < 0.5f) AddAlone(particles, from[a], Share * Duration);
                    a++;
                }
                else if (a == from.Length || to[b].Id < from[a].Id)
                {
                    if (Share >= 0.5f) AddAlone(particles, to[b], (Share - 1f) * Duration);
                    b++;
                }
                else AddBetween(particles, from[a++], to[b++]);
            }
        }

        private void AddAlone(Span<FluidParticle> particles, in StoredParticle particle, float time) =>
            Add(particles, particle.Position + time * particle.Velocity, particle.Velocity, particle.Id, IsInside(particle.Position));

        private void AddBetween(Span<FluidParticle> particles, in StoredParticle from, in StoredParticle to)
        {
            Vector3 way = new Vector3(Nearest(to.Position.x - from.Position.x, Period.x),
                Nearest(to.Position.y - from.Position.y, Period.y),
                Nearest(to.Position.z - from.Position.z, Period.z));
            bool isInside = IsInside(from.Position) && IsInside(to.Position);
            if (Blend == SequenceBlend.Linear)
            {
                Add(particles, from.Position + Share * way, way / Duration, from.Id, isInside);
                return;
            }
            // The basis functions of cubic Hermite interpolation and their derivatives; that of the first position is one less that of the
            // second.
            float s = Share, s2 = s * s, s3 = s2 * s;
            float atFrom = s3 - 2f * s2 + s, atTo = s3 - s2, travelled = 3f * s2 - 2f * s3;
            Vector3 position = from.Position + travelled * way + Duration * (atFrom * from.Velocity + atTo * to.Velocity);
            Vector3 velocity = (6f * (s - s2) / Duration) * way + (3f * s2 - 4f * s + 1f) * from.Velocity +
                (3f * s2 - 2f * s) * to.Velocity;
            Add(particles, position, velocity, from.Id, isInside);
        }

        private void Add(Span<FluidParticle> particles, Vector3 position, Vector3 velocity, uint id, bool staysInside)
        {
            if (!IsNumber(position.x + position.y + position.z + velocity.x + velocity.y + velocity.z))
            {
                notFinite++;
                return;
            }
            if (!IsInside(position))
            {
                if (!staysInside)
                {
                    outside++;
                    return;
                }
                position = new Vector3(Held(position.x, Half.x, Period.x), Held(position.y, Half.y, Period.y),
                    Held(position.z, Half.z, Period.z));
            }
            particles[shown++] = new FluidParticle(position, velocity, id);
        }

        private bool IsInside(Vector3 p) => Mathf.Abs(p.x) <= Half.x && Mathf.Abs(p.y) <= Half.y && Mathf.Abs(p.z) <= Half.z;

        private static bool IsNumber(float sum) => sum - sum == 0f;

        private static float Nearest(float way, float period) => period > 0f ? way - period * Mathf.Round(way / period) : way;

        private static float Held(float place, float half, float period)
        {
            if (period > 0f && Mathf.Abs(place) > half) place -= period * Mathf.Round(place / period);
            return Mathf.Max(-half, Mathf.Min(half, place));
        }
    }
}
