using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A place on a wall of the liquid: a face of the domain, or a triangle of a collider.</summary>
    internal readonly struct WallPlace
    {
        /// <summary>The place [m, simulation space].</summary>
        public readonly Vector3 Point;

        /// <summary>Normal of the wall there, towards the liquid.</summary>
        public readonly Vector3 Normal;

        /// <summary>How far from where it was looked for [m].</summary>
        public readonly float Distance;

        /// <summary>The collider; null of a face of the domain.</summary>
        public readonly FluidObstacle Obstacle;

        public WallPlace(Vector3 point, Vector3 normal, float distance, FluidObstacle obstacle)
        {
            Point = point;
            Normal = normal;
            Distance = distance;
            Obstacle = obstacle;
        }
    }

    /// <summary>Finds the wall of the liquid that is nearest to a place.</summary>
    internal static class WallFinder
    {
        // Of the support radius: by so much a wall that faces the right way comes before one that does not.
        private const float Preference = 1e-3f;

        /// <summary>The nearest wall within the support radius.</summary>
        /// <param name="solids">The colliders, in simulation space.</param>
        /// <param name="settings">The liquid's.</param>
        /// <param name="place">Where to look [m, simulation space].</param>
        /// <param name="forward">Direction that decides where distance does not: on an edge, and on which side of a sheet.</param>
        /// <returns>Null where there is none.</returns>
        public static WallPlace? Find(IReadOnlyList<FluidObstacle> solids, in FluidSolverSettings settings, Vector3 place, Vector3 forward)
        {
            float reach = settings.SupportRadius, best = float.PositiveInfinity;
            WallPlace? found = Face(settings, place, forward, ref best);
            for (int i = 0; i < solids.Count; i++)
            {
                TriangleMesh mesh = solids[i].Mesh;
                if (mesh.TriangleCount == 0 || mesh.Bounds.SqrDistance(place) > reach * reach) continue;
                float before = best;
                WallPlace? nearest = Triangle(solids[i], reach, place, forward, ref best);
                if (best < before) found = nearest;
            }
            return found;
        }

        private static WallPlace? Face(in FluidSolverSettings settings, Vector3 place, Vector3 forward, ref float best)
        {
            WallPlace? found = null;
            FluidFaces walls = ~(settings.Boundaries.Open | FluidBoundaries.FacesOf(settings.Boundaries.Periodic));
            Vector3 half = 0.5f * settings.DomainSize;
            for (int face = 0; face < 6; face++)
            {
                int axis = face / 2;
                float side = face % 2 == 0 ? -1f : 1f, distance = Mathf.Abs(place[axis] - side * half[axis]);
                if ((walls & FaceOf(face)) == 0 || distance > settings.SupportRadius) continue;
                Vector3 point = Vector3.Max(-half, Vector3.Min(half, place)), normal = Vector3.zero;
                point[axis] = side * half[axis];
                normal[axis] = -side;
                float away = Vector3.Distance(place, point),
                    score = away - Preference * settings.SupportRadius * Vector3.Dot(normal, forward);
                if (away > settings.SupportRadius || score >= best) continue;
                best = score;
                found = new WallPlace(point, normal, away, null);
            }
            return found;
        }

        private static FluidFaces FaceOf(int face) => face == 0 ? FluidFaces.LowX : face == 1 ? FluidFaces.HighX : face == 2
            ? FluidFaces.LowY
            : face == 3 ? FluidFaces.HighY : face == 4 ? FluidFaces.LowZ : FluidFaces.HighZ;

        // From within a closed collider the liquid is on the other side of its face.
        private static WallPlace? Triangle(FluidObstacle solid, float reach, Vector3 place, Vector3 forward, ref float best)
        {
            WallPlace? found = null;
            TriangleMesh mesh = solid.Mesh;
            bool? isWithin = null;
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                Vector3 point = TriangleMath.ClosestPoint(place, a, b, c), away = place - point;
                float distance = away.magnitude;
                Vector3 normal = Vector3.Cross(b - a, c - a).normalized;
                if (!(distance <= reach) || normal == Vector3.zero || distance - 2f * Preference * reach > best) continue;
                bool isOn = distance < 1e-4f * reach;
                isWithin ??= mesh.IsClosed && mesh.Covers(place, 0f);
                float sign = Vector3.Dot(normal, isOn ? forward : isWithin.Value ? -away : away);
                normal = sign < 0f ? -normal : normal;
                float square = isOn ? 1f : Mathf.Abs(Vector3.Dot(normal, away)) / distance;
                float score = distance - Preference * reach * (Vector3.Dot(normal, forward) + square);
                if (score >= best) continue;
                best = score;
                found = new WallPlace(point, normal, distance, solid);
            }
            return found;
        }
    }
}
