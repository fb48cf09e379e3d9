using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;
using Unity.Mathematics;

namespace SphFluid.Validation
{
    /// <summary>Thesis 6.3.2: force densities [N/m³] of pressure, equations (13) and (14), and of viscosity, (15) to (17).</summary>
    [BurstCompile(FloatPrecision.High, FloatMode.Strict)]
    internal struct CpuForceJob : IJobParallelFor
    {
        public CpuNeighbours Neighbours;
        public CpuRounding Rounding;
        public double SmoothLength;
        public double PressureCoefficient;  // m 45 / (pi h^6), times 1/2 as equation (13) has it
        public double ViscosityCoefficient; // mu m 45 / (pi h^6)

        [ReadOnly] public NativeArray<CpuFluidParticle> Particles;

        [ReadOnly] public NativeArray<double> Density;

        [ReadOnly] public NativeArray<double> Pressure;

        [WriteOnly] public NativeArray<double3> Force;

        public void Execute(int index)
        {
            CpuFluidParticle particle = Particles[index];
            double pressure = Pressure[index];
            double3 force = double3.zero;
            for (int k = 0; k < Neighbours.RangeCount; k++)
            {
                Neighbours.Range(particle.Position, k, out int first, out int end);
                for (int j = first; j < end; j++)
                {
                    CpuFluidParticle other = Particles[j];
                    double3 d = Neighbours.Separation(particle.Position, other.Position);
                    double r = math.sqrt(math.dot(d, d));
                    if (j != index && r < SmoothLength)
                    {
                        double gap = SmoothLength - r;
                        double volume = 1.0 / Density[j];
                        force += Direction(d, r, particle.Id, other.Id) *
                            (PressureCoefficient * (pressure + Pressure[j]) * volume * gap * gap);
                        force += (other.VelT0 - particle.VelT0) * (ViscosityCoefficient * volume * gap);
                    }
                }
            }

            Force[index] = Rounding.Store(force);
        }

        // Unit vector from other to self. Two particles in one place have none: they part along x, by id.
        private double3 Direction(double3 d, double r, uint selfId, uint otherId)
        {
            return r > 1e-6 * SmoothLength ? d / r : new double3(selfId < otherId ? 1.0 : -1.0, 0.0, 0.0);
        }
    }
}
