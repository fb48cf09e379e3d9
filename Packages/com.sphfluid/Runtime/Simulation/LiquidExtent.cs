using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Where the liquid starts, from which follow how deep it can stand and how fast it can get.</summary>
    internal readonly struct LiquidExtent
    {
        private readonly Vector3[] corners;
        private readonly Vector3 half;

        private LiquidExtent(Vector3[] corners, Vector3 half)
        {
            this.corners = corners;
            this.half = half;
        }

        /// <summary>Writes it.</summary>
        public void Save(SaveWriter writer)
        {
            writer.WriteItems(corners, corners.Length);
            writer.Write(half);
        }

        /// <summary>Reads what <see cref="Save"/> wrote.</summary>
        public static LiquidExtent Load(SaveReader reader) => new LiquidExtent(reader.ReadItems<Vector3>(), reader.Read<Vector3>());

        public static LiquidExtent Create(IReadOnlyList<LiquidShape> shapes, Vector3 domainSize)
        {
            var corners = new Vector3[shapes.Count * 8];
            for (int s = 0; s < shapes.Count; s++)
                for (int c = 0; c < 8; c++)
                {
                    corners[s * 8 + c] =
                        shapes[s].Frame.MultiplyPoint3x4(new Vector3((c & 1) - 0.5f, ((c >> 1) & 1) - 0.5f, (c >> 2) - 0.5f));
                }
            return new LiquidExtent(corners, domainSize * 0.5f);
        }

        /// <summary>Height of the liquid's top above the domain's lowest point along gravity [m]; no more than the domain's.</summary>
        /// <param name="gravity">Gravity in simulation space [m/s²].</param>
        public float FallHeight(Vector3 gravity)
        {
            float magnitude = gravity.magnitude;
            if (!(magnitude > 0f)) return 0f;
            Vector3 up = gravity / -magnitude;
            float reach = Mathf.Abs(up.x) * half.x + Mathf.Abs(up.y) * half.y + Mathf.Abs(up.z) * half.z;
            float top = -reach;
            foreach (Vector3 corner in corners) top = Mathf.Max(top, Vector3.Dot(up, corner));
            return Mathf.Min(top, reach) + reach;
        }

        /// <summary>The same of a liquid with emitters, which may be higher than its start.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="start">Where the liquid starts.</param>
        /// <param name="gravity">Gravity in simulation space [m/s²].</param>
        public static float FallHeight(in FluidSpec spec, in LiquidExtent start, Vector3 gravity)
        {
            float height = start.FallHeight(gravity);
            int count = spec.Emitters?.Count ?? 0;
            if (count == 0) return height;
            DomainPose worldToLocal = spec.WorldToLocal;
            var nozzles = new Vector3[count];
            for (int i = 0; i < count; i++) nozzles[i] = worldToLocal.MultiplyPoint3x4(spec.Emitters[i].Position);
            return Mathf.Max(height, new LiquidExtent(nozzles, 0.5f * spec.DomainSize).FallHeight(gravity));
        }

        /// <summary>
        /// Speed that a body force can give the liquid [m/s]: ω times the distance from its centre, or where it pushes away, times
        /// that of the domain's farther face.
        /// </summary>
        public float SpeedBy(in FluidBodyForce force)
        {
            float most = 0f;
            foreach (Vector3 corner in corners)
            {
                float squared = 0f;
                for (int axis = 0; axis < 3; axis++)
                {
                    float rate = force.RateSquared[axis], centre = force.Centre[axis];
                    float start = Mathf.Clamp(corner[axis], -half[axis], half[axis]) - centre;
                    float reach = rate > 0f ? start : half[axis] + Mathf.Abs(centre);
                    squared += Mathf.Abs(rate) * reach * reach;
                }
                most = Mathf.Max(most, squared);
            }
            return Mathf.Sqrt(most);
        }
    }
}
