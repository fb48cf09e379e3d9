using Unity.Mathematics;

namespace SphFluid.Validation
{
    /// <summary>How a value is stored: the one place where <see cref="CpuFluidPrecision"/> acts.</summary>
    internal struct CpuRounding
    {
        public bool ToFloat;

        public double Store(double value) => ToFloat ? (float)value : value;

        public double3 Store(double3 v) => new double3(Store(v.x), Store(v.y), Store(v.z));
    }
}
