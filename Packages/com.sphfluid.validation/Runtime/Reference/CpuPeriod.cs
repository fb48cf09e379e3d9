using Unity.Mathematics;

namespace SphFluid.Validation
{
    /// <summary>Periodic axes: Shaders/Solver/DomainFaces.hlsl in double precision.</summary>
    internal struct CpuPeriod
    {
        public double3 Length; // m, the box along the axis; 0: the axis has walls

        public static CpuPeriod Of(in FluidSolverSettings settings)
        {
            return new CpuPeriod { Length = CpuFluidParticle.Double(settings.PeriodLength) };
        }

        public bool X => Length.x > 0.0;

        public bool Y => Length.y > 0.0;

        public bool Z => Length.z > 0.0;

        /// <summary>From the second position to the first, from the nearest image along periodic axes.</summary>
        public double3 Separation(double3 position, double3 from)
        {
            double3 d = position - from;
            return new double3(Nearest(d.x, Length.x), Nearest(d.y, Length.y), Nearest(d.z, Length.z));
        }

        /// <summary>The position inside the box along periodic axes.</summary>
        public double3 Wrap(double3 p) => new double3(Wrap(p.x, Length.x), Wrap(p.y, Length.y), Wrap(p.z, Length.z));

        /// <summary>A value an axis where that axis has walls, zero where it is periodic.</summary>
        public double3 WhereWalls(double3 v) => new double3(X ? 0.0 : v.x, Y ? 0.0 : v.y, Z ? 0.0 : v.z);

        private static double Nearest(double d, double length) => length > 0.0 ? d - length * math.round(d / length) : d;

        private static double Wrap(double p, double length)
        {
            return length > 0.0 ? math.clamp(p - length * math.floor(p / length + 0.5), -0.5 * length, 0.5 * length) : p;
        }
    }
}
