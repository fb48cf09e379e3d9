using UnityEngine;

namespace SphFluid
{
    /// <summary>How much of a liquid shape lies outside the domain.</summary>
    internal static class BoxOverlap
    {
        private const int Samples = 32;

        /// <summary>
        /// Share of the shape's volume outside the domain: 0 or 1 exactly when its bounds say so, else by 32³ regular samples of its
        /// frame.
        /// </summary>
        public static double OutsideShare(LiquidShape shape, Vector3 domainSize)
        {
            Vector3 half = domainSize * 0.5f;
            Bounds bounds = shape.Bounds;
            Vector3 min = bounds.min, max = bounds.max;
            float slack = 1e-5f * Mathf.Max(half.x, Mathf.Max(half.y, half.z));
            bool inside = true, apart = false;
            for (int axis = 0; axis < 3; axis++)
            {
                inside &= min[axis] >= -half[axis] - slack && max[axis] <= half[axis] + slack;
                apart |= min[axis] >= half[axis] - slack || max[axis] <= -half[axis] + slack;
            }
            if (inside) return 0.0;
            return apart ? 1.0 : Sampled(shape, half);
        }

        private static double Sampled(LiquidShape shape, Vector3 half)
        {
            int outside = 0, all = 0;
            for (int k = 0; k < Samples; k++)
                for (int j = 0; j < Samples; j++)
                    for (int i = 0; i < Samples; i++)
                    {
                        Vector3 unit = (new Vector3(i, j, k) + Vector3.one * 0.5f) / Samples - Vector3.one * 0.5f;
                        Vector3 p = shape.Frame.MultiplyPoint3x4(unit);
                        if (!shape.Contains(p)) continue;
                        all++;
                        if (Mathf.Abs(p.x) > half.x || Mathf.Abs(p.y) > half.y || Mathf.Abs(p.z) > half.z) outside++;
                    }
            return all > 0 ? outside / (double)all : 0.0;
        }
    }
}
