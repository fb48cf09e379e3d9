using Unity.Mathematics;

namespace SphFluid.Validation
{
    /// <summary>Walls that hold the liquid next to them: Shaders/Solver/WallDrag.hlsl in double precision.</summary>
    internal struct CpuWallDrag
    {
        public CpuPeriod Period;
        public bool On;
        public double Speed;    // friction nu / dx, m/s
        public double Distance; // dx, m
        public double Kick;     // s
        public double3 LowX;    // m/s
        public double3 LowY;
        public double3 LowZ;
        public double3 HighX;
        public double3 HighY;
        public double3 HighZ;

        public static CpuWallDrag Of(in FluidSolverSettings settings, double kick)
        {
            FluidBoundaries walls = settings.Boundaries;
            return new CpuWallDrag
            {
                Period = CpuPeriod.Of(settings),
                On = walls.Friction > 0f,
                Speed = walls.Friction * settings.Viscosity / ((double)settings.RestDensity * settings.Spacing),
                Distance = settings.Spacing,
                Kick = kick,
                LowX = CpuFluidParticle.Double(walls.LowX),
                LowY = CpuFluidParticle.Double(walls.LowY),
                LowZ = CpuFluidParticle.Double(walls.LowZ),
                HighX = CpuFluidParticle.Double(walls.HighX),
                HighY = CpuFluidParticle.Double(walls.HighY),
                HighZ = CpuFluidParticle.Double(walls.HighZ),
            };
        }

        /// <summary>Acceleration by the six faces [m/s²] from the distances to them.</summary>
        public double3 Domain(double3 low, double3 high, double3 velocity)
        {
            double3 lower = Period.WhereWalls(new double3(Rate(low.x), Rate(low.y), Rate(low.z)));
            double3 upper = Period.WhereWalls(new double3(Rate(high.x), Rate(high.y), Rate(high.z)));
            double3 drive = LowX * lower.x + HighX * upper.x + LowY * lower.y + HighY * upper.y + LowZ * lower.z + HighZ * upper.z;
            double3 both = lower + upper;
            var rate = new double3(both.y + both.z, both.z + both.x, both.x + both.y);
            return new double3(Capped(drive.x, rate.x, velocity.x), Capped(drive.y, rate.y, velocity.y),
                Capped(drive.z, rate.z, velocity.z));
        }

        /// <summary>Acceleration by a mesh at rest [m/s²]: unit vector and distance from its nearest point.</summary>
        public double3 Mesh(double3 away, double distance, double3 velocity)
        {
            return (away * math.dot(velocity, away) - velocity) * math.min(Rate(distance), 1.0 / Kick);
        }

        private double Rate(double distance) => distance < Distance ? Speed / math.max(distance, 0.05 * Distance) : 0.0;

        private double Capped(double drive, double rate, double speed) => (drive - rate * speed) / math.max(rate * Kick, 1.0);
    }
}
