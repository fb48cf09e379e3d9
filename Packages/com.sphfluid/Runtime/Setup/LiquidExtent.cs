using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Where the liquid starts, from which follow how deep it can stand and how fast it can get.</summary>
    internal readonly struct LiquidExtent
    {
        readonly Vector3[] corners;
        readonly float[] speeds;
        readonly Vector3 half;

        LiquidExtent(Vector3[] corners, float[] speeds, Vector3 half)
        {
            this.corners = corners;
            this.speeds = speeds;
            this.half = half;
        }

        public static LiquidExtent Of(IReadOnlyList<LiquidBox> boxes, Vector3 domainSize)
        {
            var corners = new Vector3[boxes.Count * 8];
            var speeds = new float[boxes.Count];
            for (int b = 0; b < boxes.Count; b++)
            {
                speeds[b] = boxes[b].Velocity.magnitude;
                for (int c = 0; c < 8; c++)
                    corners[b * 8 + c] = boxes[b].UnitToSimulation.MultiplyPoint3x4(new Vector3((c & 1) - 0.5f, ((c >> 1) & 1) - 0.5f, (c >> 2) - 0.5f));
            }
            return new LiquidExtent(corners, speeds, domainSize * 0.5f);
        }

        /// <summary>Height of the liquid's top above the domain's lowest point along gravity [m]; no more than the domain's.</summary>
        /// <param name="gravity">Gravity in simulation space [m/s²].</param>
        public float FallHeight(Vector3 gravity)
        {
            float height = 0f;
            for (int b = 0; b < speeds.Length; b++) height = Mathf.Max(height, FallHeight(b, gravity));
            return height;
        }

        /// <summary>Largest initial speed [m/s].</summary>
        public float InitialSpeed
        {
            get
            {
                float speed = 0f;
                foreach (float s in speeds) speed = Mathf.Max(speed, s);
                return speed;
            }
        }

        float FallHeight(int box, Vector3 gravity)
        {
            float magnitude = gravity.magnitude;
            if (!(magnitude > 0f)) return 0f;
            Vector3 up = gravity / -magnitude;
            float reach = Mathf.Abs(up.x) * half.x + Mathf.Abs(up.y) * half.y + Mathf.Abs(up.z) * half.z;
            float top = -reach;
            for (int c = 0; c < 8; c++) top = Mathf.Max(top, Vector3.Dot(up, corners[box * 8 + c]));
            return Mathf.Min(top, reach) + reach;
        }
    }
}
