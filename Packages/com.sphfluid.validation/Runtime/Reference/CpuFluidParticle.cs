using Unity.Mathematics;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A <see cref="FluidParticle"/> in double precision. Simulation space: metres from the centre of the domain box.</summary>
    public struct CpuFluidParticle
    {
        /// <summary>Position [m].</summary>
        public double3 Position;

        /// <summary>Velocity half a step after the last force [m/s]; the initial velocity before the first step.</summary>
        public double3 VelT0;

        /// <summary>Velocity at the time of the last force [m/s], one step before <see cref="Position"/>.</summary>
        public double3 VelT1;

        /// <summary>Number given at the start; sorting moves particles, not their numbers.</summary>
        public uint Id;

        internal CpuFluidParticle(in FluidParticle particle)
        {
            Position = Double(particle.Position);
            VelT0 = Double(particle.VelT0);
            VelT1 = Double(particle.VelT1);
            Id = particle.Id;
        }

        /// <summary>The particle as the GPU's buffer would hold it, rounded to float.</summary>
        /// <returns>The rounded particle.</returns>
        public FluidParticle ToFloat()
        {
            return new FluidParticle(Single(Position), Single(VelT0), Id) { VelT1 = Single(VelT1) };
        }

        internal static double3 Double(Vector3 v) => new double3(v.x, v.y, v.z);

        private static Vector3 Single(double3 v) => new Vector3((float)v.x, (float)v.y, (float)v.z);
    }
}
