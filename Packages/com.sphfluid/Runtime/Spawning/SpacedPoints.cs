using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Points by cell of a cubic grid, so that it is quickly known whether one is near a place.</summary>
    internal sealed class SpacedPoints
    {
        private readonly float cell;
        private readonly Dictionary<Vector3Int, List<Vector3>> cells = new Dictionary<Vector3Int, List<Vector3>>();

        /// <param name="reach">Largest distance that is asked for [m].</param>
        public SpacedPoints(float reach)
        {
            cell = reach;
        }

        /// <summary>Adds a point.</summary>
        /// <param name="point">Point [m].</param>
        public void Add(Vector3 point)
        {
            Vector3Int key = CellOf(point);
            if (!cells.TryGetValue(key, out List<Vector3> points)) cells.Add(key, points = new List<Vector3>());
            points.Add(point);
        }

        /// <summary>Whether a point is nearer to a place than a distance.</summary>
        /// <param name="place">Place [m].</param>
        /// <param name="distance">Distance [m], at most the reach.</param>
        public bool HasNear(Vector3 place, float distance)
        {
            Vector3Int middle = CellOf(place);
            for (int z = -1; z <= 1; z++)
                for (int y = -1; y <= 1; y++)
                    for (int x = -1; x <= 1; x++)
                        if (cells.TryGetValue(middle + new Vector3Int(x, y, z), out List<Vector3> points) &&
                            HasNear(points, place, distance))
                        {
                            return true;
                        }
            return false;
        }

        private static bool HasNear(List<Vector3> points, Vector3 place, float distance)
        {
            foreach (Vector3 point in points)
                if ((point - place).sqrMagnitude < distance * distance) return true;
            return false;
        }

        private Vector3Int CellOf(Vector3 place) => new Vector3Int(Index(place.x), Index(place.y), Index(place.z));

        private int Index(float coordinate) => (int)Math.Floor((double)coordinate / cell);
    }
}
