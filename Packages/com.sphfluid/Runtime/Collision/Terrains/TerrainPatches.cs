using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The part of each terrain that lies over a domain, read when the domain leaves it or the terrain was edited. In projects without
    /// Unity's terrain modules no collider is a terrain.
    /// </summary>
    internal sealed class TerrainPatches
    {
        /// <summary>Most cells of a terrain over a domain.</summary>
        public const int MaxCells = 1 << 20;

#if SPHFLUID_TERRAIN
        // All terrains' edits: what was read is compared with what is read then.
        [OutlivesPlay("it is only compared")] private static int edits;

        private readonly Dictionary<Collider, Patch> patches = new Dictionary<Collider, Patch>();

        static TerrainPatches()
        {
            TerrainCallbacks.heightmapChanged += (terrain, region, synched) => edits++;
            TerrainCallbacks.textureChanged += (terrain, name, region, synched) => edits += name == TerrainData.HolesTextureName ? 1 : 0;
        }
#endif

        /// <summary>Whether a collider is a terrain's.</summary>
        public static bool IsTerrain(Collider collider)
        {
#if SPHFLUID_TERRAIN
            return collider is TerrainCollider;
#else
            return false;
#endif
        }

        /// <summary>Whether a terrain has data, of a size greater than zero.</summary>
        public static bool HasData(Collider collider)
        {
#if SPHFLUID_TERRAIN
            if (!(collider is TerrainCollider terrain) || terrain.terrainData == null) return false;
            Vector3 size = terrain.terrainData.size;
            return size.x > 0f && size.y > 0f && size.z > 0f;
#else
            return false;
#endif
        }

        /// <summary>Reads all terrains again; those that did not change keep their triangles.</summary>
        public void Refresh()
        {
#if SPHFLUID_TERRAIN
            foreach (Patch patch in patches.Values) patch.Edits = edits - 1;
#endif
        }

        /// <summary>The state of a collider: a terrain's is that of its triangles near the domain.</summary>
        /// <param name="collider">The collider.</param>
        /// <param name="friction">0 free slip to 1 no slip; negative: as the domain's faces.</param>
        /// <param name="worldToSimulation">World space to simulation space.</param>
        /// <param name="domain">Edge lengths of the domain [m].</param>
        /// <param name="spacing">Particle spacing dx [m].</param>
        public ColliderState StateOf(Collider collider, float friction, in DomainPose worldToSimulation, Vector3 domain, float spacing)
        {
#if SPHFLUID_TERRAIN
            if (collider is TerrainCollider terrain && Find(terrain, worldToSimulation, domain, spacing) is TriangleMesh mesh)
                return new ColliderState(collider, mesh, friction, worldToSimulation * Matrix4x4.Translate(collider.transform.position));
#endif
            return ColliderState.Read(collider, friction, worldToSimulation);
        }

#if SPHFLUID_TERRAIN
        // Null where there is no data, or too much.
        private TriangleMesh Find(TerrainCollider collider, in DomainPose worldToSimulation, Vector3 domain, float spacing)
        {
            if (!HasData(collider)) return null;
            TerrainData data = collider.terrainData;
            if (!patches.TryGetValue(collider, out Patch patch)) patch = Add(collider);

            Matrix4x4 toWorld = ((Matrix4x4)worldToSimulation).inverse;
            Vector3 centre = toWorld.GetPosition() - collider.transform.position;
            Vector3 extents = AffineMath.Extents(toWorld, 0.5f * domain + 4f * spacing * Vector3.one);
            Vector3 cell = data.size / (data.heightmapResolution - 1);
            cell.y = data.size.y;
            RectInt near = Cells(centre, extents, cell, data.heightmapResolution - 1);
            float floor = Mathf.Min(0f, centre.y - extents.y);
            bool held = patch.Holds(data, cell, near, floor);
            if (held && patch.Edits == edits) return patch.Mesh;

            // A quarter more than what is near, so that a domain that moves seldom asks again.
            RectInt taken = held ? patch.Cells : Cells(centre, 1.25f * extents, cell, data.heightmapResolution - 1);
            if ((long)taken.width * taken.height > MaxCells) return null;
            patch.Read(data, cell, taken, held ? patch.Floor : floor - 0.25f * extents.y - spacing);
            patch.Edits = edits;
            return patch.Mesh;
        }

        private Patch Add(Collider collider)
        {
            GoneKeys.Forget(patches);
            var patch = new Patch();
            patches.Add(collider, patch);
            return patch;
        }

        // At least one cell, the nearest.
        private static RectInt Cells(Vector3 centre, Vector3 extents, Vector3 cell, int count)
        {
            int x0 = Cell((centre.x - extents.x) / cell.x, count), x1 = Cell((centre.x + extents.x) / cell.x, count);
            int z0 = Cell((centre.z - extents.z) / cell.z, count), z1 = Cell((centre.z + extents.z) / cell.z, count);
            return new RectInt(x0, z0, x1 - x0 + 1, z1 - z0 + 1);
        }

        private static int Cell(float place, int count) => (int)Mathf.Clamp(Mathf.Floor(place), 0f, count - 1);

        private sealed class Patch
        {
            private TerrainData data;
            private Vector3 cell;
            private int resolution;
            private float[,] heights;
            private bool[,] surface;

            public int Edits { get; set; }
            public float Floor { get; private set; }
            public RectInt Cells { get; private set; }
            public TriangleMesh Mesh { get; private set; }

            public bool Holds(TerrainData terrain, Vector3 cellSize, RectInt near, float lowest) =>
                Mesh != null && ReferenceEquals(terrain, data) && cellSize == cell && resolution == terrain.heightmapResolution &&
                    Floor <= lowest &&
                near.xMin >= Cells.xMin && near.yMin >= Cells.yMin && near.xMax <= Cells.xMax && near.yMax <= Cells.yMax;

            public void Read(TerrainData terrain, Vector3 cellSize, RectInt cells, float lowest)
            {
                float[,] newHeights = terrain.GetHeights(cells.xMin, cells.yMin, cells.width + 1, cells.height + 1);
                bool[,] newSurface = terrain.GetHoles(cells.xMin, cells.yMin, cells.width, cells.height);
                bool same = Holds(terrain, cellSize, cells, lowest) && cells.Equals(Cells) && Same(heights, newHeights) &&
                    Same(surface, newSurface);
                if (same) return;
                (data, cell, resolution, Floor, Cells) = (terrain, cellSize, terrain.heightmapResolution, lowest, cells);
                (heights, surface) = (newHeights, newSurface);
                var metres = new float[heights.GetLength(0), heights.GetLength(1)];
                for (int z = 0; z < metres.GetLength(0); z++)
                    for (int x = 0; x < metres.GetLength(1); x++) metres[z, x] = heights[z, x] * cell.y;
                var corner = new Vector3(cells.xMin * cell.x, 0f, cells.yMin * cell.z);
                Mesh = TerrainMesh.Make(metres, surface, corner, cell.x, cell.z, Floor);
            }

            private static bool Same<T>(T[,] a, T[,] b) where T : IEquatable<T>
            {
                for (int z = 0; z < a.GetLength(0); z++)
                    for (int x = 0; x < a.GetLength(1); x++)
                        if (!a[z, x].Equals(b[z, x])) return false;
                return true;
            }
        }
#endif
    }
}
