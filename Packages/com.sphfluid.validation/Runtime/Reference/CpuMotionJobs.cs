using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace SphFluid.Validation
{
    /// <summary>Thesis 6.3.3: the fluid's acceleration, limited; the collisions'; gravity and the body force.</summary>
    [BurstCompile(FloatPrecision.High, FloatMode.Strict)]
    internal struct CpuAccelerationJob : IJobParallelFor
    {
        public CpuRounding Rounding;
        public CpuCollision Collision;
        public double PrintedMass; // kg: 6.3.3 as printed multiplies by it; 0: force density over density, equation (9)
        public double AccelerationLimit;
        public double3 Gravity;
        public double3 BodyForceCentre;
        public double3 BodyForceRate; // 1/s^2

        [ReadOnly] public NativeArray<CpuFluidParticle> Particles;

        [ReadOnly] public NativeArray<double> Density;

        [ReadOnly] public NativeArray<double3> Force;

        [WriteOnly] public NativeArray<double3> Acceleration;

        [WriteOnly] public NativeArray<int> Events;

        public void Execute(int index)
        {
            CpuFluidParticle particle = Particles[index];
            double3 acceleration = PrintedMass > 0.0 ? Force[index] * PrintedMass : Force[index] / Density[index];
            double magnitude = math.length(acceleration);
            bool limited = magnitude > AccelerationLimit;
            if (limited) acceleration *= AccelerationLimit / magnitude;

            acceleration += Collision.Force(particle.Position, particle.VelT0);
            acceleration += BodyForceRate * (BodyForceCentre - particle.Position);
            Acceleration[index] = Rounding.Store(acceleration + Gravity);
            Events[index] = limited ? CpuCountJob.Limited : 0;
        }
    }

    /// <summary>Thesis 6.3.4: leapfrog, equations (19) to (21).</summary>
    [BurstCompile(FloatPrecision.High, FloatMode.Strict)]
    internal struct CpuNewPositionJob : IJobParallelFor
    {
        public CpuRounding Rounding;
        public CpuPeriod Period;
        public double TimeStep;
        public double KickStep; // s, from the middle of the last step to the middle of this one
        public double KickPart; // the part of it up to the time of the force
        public bool FirstStep; // VelT0 is still v(0), not v(-dt/2)
        public double3 HalfSize;

        [ReadOnly] public NativeArray<double3> Acceleration;

        public NativeArray<CpuFluidParticle> Particles;

        public NativeArray<int> Events;

        public void Execute(int index)
        {
            CpuFluidParticle particle = Particles[index];
            int events = Events[index];
            double3 kick = Acceleration[index] * KickStep;
            double3 v0 = FirstStep ? particle.VelT0 - kick * 0.5 : particle.VelT0;
            double3 v = Rounding.Store(v0 + kick);
            double3 velT1 = Rounding.Store(v0 * (1.0 - KickPart) + v * KickPart);
            double3 position = Rounding.Store(particle.Position + v * TimeStep);
            if (!math.all(math.isfinite(position)) || !math.all(math.isfinite(v)))
            {
                events |= CpuCountJob.NonFinite; // it stays where it was, at rest
                position = particle.Position;
                v = double3.zero;
                velT1 = v;
            }

            position = Rounding.Store(Period.Wrap(position));
            double3 inside = math.clamp(position, -HalfSize, HalfSize);
            if (inside.x != position.x || inside.y != position.y || inside.z != position.z)
            {
                events |= CpuCountJob.Clamped;
                v = new double3(inside.x == position.x ? v.x : 0.0, inside.y == position.y ? v.y : 0.0, inside.z == position.z ? v.z : 0.0);
            }

            particle.VelT1 = velT1;
            particle.VelT0 = v;
            particle.Position = inside;
            Particles[index] = particle;
            Events[index] = events;
        }
    }

    /// <summary>Sums of the events and maxima of a step: what <see cref="FluidCounters"/> tells.</summary>
    [BurstCompile(FloatPrecision.High, FloatMode.Strict)]
    internal struct CpuCountJob : IJob
    {
        public const int Limited = 1;
        public const int Clamped = 2;
        public const int NonFinite = 4;

        [ReadOnly] public NativeArray<CpuFluidParticle> Particles;

        [ReadOnly] public NativeArray<double> Density;

        [ReadOnly] public NativeArray<int> Events;

        public NativeArray<long> Totals;   // limited, clamped, not finite
        public NativeArray<double> Maxima; // speed, density

        public void Execute()
        {
            for (int i = 0; i < Particles.Length; i++)
            {
                Totals[0] += Events[i] & 1;
                Totals[1] += (Events[i] >> 1) & 1;
                Totals[2] += (Events[i] >> 2) & 1;
                Maxima[0] = math.max(Maxima[0], math.length(Particles[i].VelT0));
                Maxima[1] = math.max(Maxima[1], Density[i]);
            }
        }
    }
}
