using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace SphFluid.Validation
{
    /// <summary>Thesis 6.3.1: density by poly6, equations (11) and (12), and pressure, equation (10).</summary>
    [BurstCompile(FloatPrecision.High, FloatMode.Strict)]
    internal struct CpuDensityJob : IJobParallelFor
    {
        public CpuNeighbours Neighbours;
        public CpuRounding Rounding;
        public double SmoothLengthSquared;
        public double Coefficient; // m 315 / (64 pi h^9)
        public double RestDensity;
        public double Stiffness;
        public double PressureFloor;
        public bool SelfDensity;

        [ReadOnly] public NativeArray<CpuFluidParticle> Particles;

        [WriteOnly] public NativeArray<double> Density;

        [WriteOnly] public NativeArray<double> Pressure;

        public void Execute(int index)
        {
            double3 position = Particles[index].Position;
            double factor = 0.0;
            for (int k = 0; k < Neighbours.RangeCount; k++)
            {
                Neighbours.Range(position, k, out int first, out int end);
                for (int j = first; j < end; j++)
                {
                    double3 d = Neighbours.Separation(position, Particles[j].Position);
                    double t = SmoothLengthSquared - math.dot(d, d);
                    factor += t > 0.0 && (j != index || SelfDensity) ? t * t * t : 0.0;
                }
            }

            double density = Rounding.Store(factor * Coefficient);
            Density[index] = density;
            Pressure[index] = Rounding.Store(math.max((density - RestDensity) * Stiffness, PressureFloor));
        }
    }
}
