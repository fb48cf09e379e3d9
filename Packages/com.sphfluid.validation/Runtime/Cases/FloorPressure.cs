using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Pressure on a domain's floor, read at points a spacing apart by Shepard's average p = Σ p_j W_j / Σ W_j over the particles
    /// within R (Shepard 1968). The force of a symmetric form bears an odd-even mode in the layers at a wall, which an average
    /// of several layers does not see. What is nearer to a side wall than three spacings is kept apart.
    /// </summary>
    internal sealed class FloorPressure
    {
        /// <summary>Spacings from a side wall at which the face begins.</summary>
        public const double Edge = 3.0;

        private readonly FluidSolverSettings settings;
        private readonly List<Vector3> face = new List<Vector3>(), edges = new List<Vector3>();
        private double faceSum, edgeSum;
        private int samples;

        /// <summary>A reading.</summary>
        /// <param name="settings">The liquid's; the floor is the domain's lower face.</param>
        public FloorPressure(in FluidSolverSettings settings)
        {
            this.settings = settings;
            Vector3 size = settings.DomainSize;
            double dx = settings.Spacing;
            for (double z = 0.5 * dx; z < size.z; z += dx)
                for (double x = 0.5 * dx; x < size.x; x += dx)
                {
                    var point = new Vector3((float)(x - 0.5 * size.x), -0.5f * size.y, (float)(z - 0.5 * size.z));
                    (IsNearSide(settings, point) ? edges : face).Add(point);
                }
        }

        /// <summary>Whether a point is nearer than <see cref="Edge"/> spacings to a wall at the side.</summary>
        public static bool IsNearSide(in FluidSolverSettings settings, Vector3 point)
        {
            double edge = Edge * settings.Spacing;
            FluidAxes periodic = settings.Boundaries.Periodic;
            return (periodic & FluidAxes.X) == 0 && 0.5 * settings.DomainSize.x - Mathf.Abs(point.x) < edge
                || (periodic & FluidAxes.Z) == 0 && 0.5 * settings.DomainSize.z - Mathf.Abs(point.z) < edge;
        }

        /// <summary>Mean over the face and time [Pa]; not a number without particles or points there.</summary>
        public double Face => faceSum / face.Count / samples;

        /// <summary>Mean over the strips at side walls and time [Pa]; not a number without side walls.</summary>
        public double Edges => edgeSum / edges.Count / samples;

        /// <summary>Whether there are side walls.</summary>
        public bool HasEdges => edges.Count > 0;

        /// <summary>Reads a state.</summary>
        public void Sample(FluidSnapshot state)
        {
            var near = new List<int>();
            for (int i = 0; i < state.Count; i++)
            {
                if (state.LocalPositions[i].y + 0.5f * settings.DomainSize.y < settings.SupportRadius) near.Add(i);
            }
            faceSum += Sum(face, state, near);
            edgeSum += Sum(edges, state, near);
            samples++;
        }

        private double Sum(List<Vector3> points, FluidSnapshot state, List<int> near)
        {
            Vector3 period = settings.PeriodLength;
            double sum = 0.0;
            foreach (Vector3 point in points)
            {
                double weights = 0.0, pressures = 0.0;
                foreach (int i in near)
                {
                    Vector3 d = state.LocalPositions[i] - point;
                    for (int axis = 0; axis < 3; axis++)
                    {
                        d[axis] -= period[axis] > 0f ? period[axis] * Mathf.Round(d[axis] / period[axis]) : 0f;
                    }
                    double weight = CpuKernels.Wendland(d.magnitude / settings.SupportRadius);
                    weights += weight;
                    pressures += weight * state.Pressures[i];
                }
                sum += pressures / weights;
            }
            return sum;
        }
    }
}
