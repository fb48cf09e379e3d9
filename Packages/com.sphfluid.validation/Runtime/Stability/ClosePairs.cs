using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Particles that are too near to another one, across the faces of periodic axes too.</summary>
    static class ClosePairs
    {
        /// <summary>Share of the particles with another one nearer than a distance.</summary>
        /// <param name="state">The particles.</param>
        /// <param name="settings">Domain and periodic axes.</param>
        /// <param name="distance">The distance [m].</param>
        public static double Share(FluidSnapshot state, in FluidSolverSettings settings, double distance)
        {
            Vector3[] positions = WithImages(state.LocalPositions, settings, (float)distance);
            var cells = new CellLists(positions, (float)distance);
            int near = 0;
            for (int i = 0; i < state.Count; i++)
            {
                if (cells.CountWithin(positions, i, (float)distance) > 0)
                    near++;
            }
            return near / (double)System.Math.Max(1, state.Count);
        }

        // What lies within the distance of a periodic face is there once more beyond the other one.
        static Vector3[] WithImages(Vector3[] positions, in FluidSolverSettings settings, float distance)
        {
            var all = new List<Vector3>(positions);
            for (int axis = 0; axis < 3; axis++)
            {
                float length = settings.PeriodLength[axis];
                for (int i = 0, count = all.Count; length > 0f && i < count; i++)
                {
                    Vector3 image = all[i];
                    if (Mathf.Abs(image[axis]) <= 0.5f * length - distance)
                        continue;
                    image[axis] -= Mathf.Sign(image[axis]) * length;
                    all.Add(image);
                }
            }
            return all.ToArray();
        }
    }
}
