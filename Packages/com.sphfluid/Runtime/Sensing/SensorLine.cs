using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A line of points along which the level of a liquid is read.</summary>
    internal readonly struct SensorLine
    {
        // Points a particle spacing: the density falls from liquid to air over about two spacings.
        private const float PointsPerSpacing = 2f;

        /// <summary>Distance of the first point from the foot [m].</summary>
        public readonly float First;

        /// <summary>Distance between points [m].</summary>
        public readonly float Step;

        /// <summary>Number of points, of a line 2 or more; it does not depend on the pose.</summary>
        public readonly int Count;

        /// <summary>Its foot alone.</summary>
        public static SensorLine Point => new SensorLine(0f, 0f, 1);

        private SensorLine(float first, float step, int count)
        {
            First = first;
            Step = step;
            Count = count;
        }

        /// <summary>The part of a line that is in a domain.</summary>
        /// <param name="foot">Where it begins, in simulation space [m].</param>
        /// <param name="direction">Unit vector.</param>
        /// <param name="length">Its length [m].</param>
        /// <param name="domain">Edge lengths of the domain [m].</param>
        /// <param name="spacing">Particle spacing [m].</param>
        public static SensorLine Create(Vector3 foot, Vector3 direction, float length, Vector3 domain, float spacing)
        {
            length = length > 0f ? Math.Min(length, 2f * domain.magnitude) : 0f;
            float from = 0f, to = length;
            for (int axis = 0; axis < 3; axis++)
            {
                float half = 0.5f * domain[axis], place = foot[axis], along = direction[axis];
                if (Math.Abs(along) < 1e-6f)
                {
                    if (Math.Abs(place) > half) to = 0f;
                    continue;
                }
                float low = (-half - place) / along, high = (half - place) / along;
                from = Math.Max(from, Math.Min(low, high));
                to = Math.Min(to, Math.Max(low, high));
            }
            int count = 2 + (int)Math.Ceiling(Math.Min(length, domain.magnitude) * PointsPerSpacing / spacing);
            return to > from ? new SensorLine(from, (to - from) / (count - 1), count) : new SensorLine(0f, 0f, count);
        }

        /// <summary>
        /// Height of the surface of the lowest liquid on the line over its foot [m]: where the density falls below half the rest density,
        /// by linear interpolation. 0 without liquid; the upper end where liquid reaches it.
        /// </summary>
        /// <param name="densities">Of the points, from the foot on [kg/m³].</param>
        /// <param name="restDensity">ρ0 [kg/m³].</param>
        public float Level(IReadOnlyList<float> densities, float restDensity)
        {
            float half = 0.5f * restDensity;
            int i = 0;
            while (i < Count && !(densities[i] > half)) i++;
            if (i == Count) return 0f;
            while (i < Count && densities[i] > half) i++;
            if (i == Count) return First + (Count - 1) * Step;
            float below = densities[i - 1], above = densities[i];
            return First + (i - 1 + (below - half) / (below - above)) * Step;
        }
    }
}
