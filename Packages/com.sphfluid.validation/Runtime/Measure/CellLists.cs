using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Particles by cells of one edge length, in a hash table; for measurements on the CPU.</summary>
    internal sealed class CellLists
    {
        private readonly Dictionary<Vector3Int, List<int>> cells = new Dictionary<Vector3Int, List<int>>();
        private readonly float edge;

        public CellLists(Vector3[] positions, float edge)
        {
            this.edge = edge;
            for (int i = 0; i < positions.Length; i++)
            {
                if (float.IsNaN(positions[i].sqrMagnitude) || float.IsInfinity(positions[i].sqrMagnitude)) continue;
                Vector3Int cell = Cell(positions[i]);
                if (!cells.TryGetValue(cell, out List<int> list)) cells.Add(cell, list = new List<int>());
                list.Add(i);
            }
        }

        public int CountWithin(Vector3[] positions, int particle, float radius)
        {
            int count = 0;
            foreach (int other in Around(positions[particle]))
            {
                count += other != particle && (positions[other] - positions[particle]).sqrMagnitude < radius * radius ? 1 : 0;
            }
            return count;
        }

        /// <summary>The particles of the 27 cells around a position: all within the cells' edge of it, and others.</summary>
        public IEnumerable<int> Around(Vector3 position)
        {
            Vector3Int centre = Cell(position);
            for (int z = -1; z <= 1; z++)
                for (int y = -1; y <= 1; y++)
                    for (int x = -1; x <= 1; x++)
                    {
                        if (!cells.TryGetValue(centre + new Vector3Int(x, y, z), out List<int> list)) continue;
                        foreach (int particle in list) yield return particle;
                    }
        }

        private Vector3Int Cell(Vector3 position) => Vector3Int.FloorToInt(position / edge);
    }
}
