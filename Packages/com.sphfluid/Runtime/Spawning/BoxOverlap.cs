using UnityEngine;

namespace SphFluid
{
    /// <summary>How much of a liquid box lies outside the domain.</summary>
    internal static class BoxOverlap
    {
        const int Samples = 32;

        /// <summary>
        /// Share of the box's volume outside the domain: 0 or 1 exactly when the corners or bounds say so, else by
        /// 32³ regular samples.
        /// </summary>
        public static double OutsideShare(LiquidBox box, Vector3 domainSize)
        {
            Vector3 half = domainSize * 0.5f;
            Bounds bounds = box.Bounds;
            Vector3 min = bounds.min, max = bounds.max;
            float slack = 1e-5f * Mathf.Max(half.x, Mathf.Max(half.y, half.z));
            bool inside = true, apart = false;
            for (int axis = 0; axis < 3; axis++)
            {
                inside &= min[axis] >= -half[axis] - slack && max[axis] <= half[axis] + slack;
                apart |= min[axis] >= half[axis] - slack || max[axis] <= -half[axis] + slack;
            }
            if (inside) return 0.0;
            return apart ? 1.0 : Sampled(box.UnitToSimulation, half);
        }

        static double Sampled(Matrix4x4 unitToSimulation, Vector3 half)
        {
            int outside = 0;
            for (int k = 0; k < Samples; k++)
                for (int j = 0; j < Samples; j++)
                    for (int i = 0; i < Samples; i++)
                    {
                        Vector3 unit = (new Vector3(i, j, k) + Vector3.one * 0.5f) / Samples - Vector3.one * 0.5f;
                        Vector3 p = unitToSimulation.MultiplyPoint3x4(unit);
                        if (Mathf.Abs(p.x) > half.x || Mathf.Abs(p.y) > half.y || Mathf.Abs(p.z) > half.z) outside++;
                    }
            return outside / (double)(Samples * Samples * Samples);
        }
    }
}
