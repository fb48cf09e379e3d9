using System;
using System.Collections.Generic;
using Unity.Collections;
using Unity.Jobs;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>Triangles of all bodies and each body's lists by cell, on the CPU and on the GPU.</summary>
    internal sealed class BodyGeometry : IDisposable
    {
        private static readonly int TrianglesId = Shader.PropertyToID("_BodyTriangles");
        private static readonly int ListsId = Shader.PropertyToID("_BodyLists");
        private static readonly int ReferencesBeginId = Shader.PropertyToID("_CellTrianglesBegin");
        private static readonly int CellsBeginId = Shader.PropertyToID("_BodyCellsBegin");

        private readonly float reach;
        private readonly List<BodyTriangle> triangles = new List<BodyTriangle>();
        private readonly List<uint> edges = new List<uint>(); // of the triangles, as MeshSurfaces has them
        private readonly List<BodyTriangle> ends = new List<BodyTriangle>(); // of the body that is being added, where it deforms
        private readonly List<int> solids = new List<int>(); // of the body that is being added: number of each triangle's solid, 0 for none
        private readonly List<BodyGrid> grids = new List<BodyGrid>();
        private int first; // triangle of the body that is being added
        private uint surfaces; // of that body
        private uint cellCount, referenceCount;
        private Lengths steady; // before the bodies that are made anew every frame
        private GraphicsBuffer triangleBuffer;
        private GraphicsBuffer listBuffer; // edges, cells from one place on, references from another
        private int cellsBegin, referencesBegin;

        /// <param name="reach">How far a cell looks [m].</param>
        public BodyGeometry(float reach)
        {
            this.reach = reach;
        }

        /// <summary>Number of triangles.</summary>
        public int TriangleCount => triangles.Count;

        /// <summary>Triangles left out because a corner is not finite. Those without area stay: as edges they close cracks.</summary>
        public int LeftOut { get; private set; }

        /// <summary>Bytes of the GPU buffers.</summary>
        public long Bytes => GpuBuffers.Size(triangleBuffer, listBuffer);

        /// <summary>Begins anew.</summary>
        public void Clear()
        {
            triangles.Clear();
            edges.Clear();
            solids.Clear();
            DisposeGrids();
            first = LeftOut = 0;
            cellCount = referenceCount = 0u;
            steady = default;
        }

        /// <summary>What is added from here on is made anew every frame.</summary>
        public void BeginDeforming() =>
            steady = new Lengths { Triangles = triangles.Count, Cells = cellCount, References = referenceCount, LeftOut = LeftOut };

        /// <summary>Forgets what was added since <see cref="BeginDeforming"/>.</summary>
        public void RestartDeforming()
        {
            triangles.RemoveRange(steady.Triangles, triangles.Count - steady.Triangles);
            edges.RemoveRange(steady.Triangles, edges.Count - steady.Triangles);
            DisposeGrids();
            first = steady.Triangles;
            LeftOut = steady.LeftOut;
            (cellCount, referenceCount) = (steady.Cells, steady.References);
        }

        /// <summary>Adds triangles that deform to the body that <see cref="TryEndBody"/> ends.</summary>
        /// <param name="start">The triangles at the start of the frame.</param>
        /// <param name="end">The same at its end.</param>
        public void AddDeforming(TriangleMesh start, TriangleMesh end)
        {
            MeshSurfaces found = start.Surfaces.Deforming;
            foreach (int t in found.Order)
            {
                start.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                end.GetTriangle(t, out Vector3 d, out Vector3 e, out Vector3 f);
                if (!AffineMath.IsFinite(a + d) || !AffineMath.IsFinite(b + e) || !AffineMath.IsFinite(c + f))
                {
                    LeftOut++;
                    continue;
                }
                AddTriangle(a, b, c, found.Edges[t], 0);
                ends.Add(new BodyTriangle { A = d, B = e, C = f }); // kernels take the normal between the two
            }
        }

        /// <summary>Adds triangles to the body that <see cref="TryEndBody"/> ends.</summary>
        /// <param name="mesh">The triangles.</param>
        /// <param name="within">Bounds beyond which no particle is; null for none.</param>
        public void Add(TriangleMesh mesh, Bounds? within)
        {
            Vector3 half = within.HasValue ? within.Value.extents + reach * Vector3.one : Vector3.positiveInfinity;
            MeshSurfaces found = mesh.Surfaces;
            int solid = mesh.IsClosed ? triangles.Count + 1 : 0;
            foreach (int t in found.Order)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                if (!AffineMath.IsFinite(a) || !AffineMath.IsFinite(b) || !AffineMath.IsFinite(c)) LeftOut++;
                else if (!within.HasValue ||
                    TriangleMath.MayOverlap(within.Value.center, half, a, b, c)) AddTriangle(a, b, c, found.Edges[t], solid);
            }
            surfaces += (uint)found.Count;
        }

        private void AddTriangle(Vector3 a, Vector3 b, Vector3 c, uint own, int solid)
        {
            triangles.Add(BodyTriangle.Create(a, b, c));
            edges.Add(own + (surfaces << MeshSurfaces.NumberShift) + (solid > 0 ? MeshSurfaces.Deep : 0u));
            solids.Add(solid);
        }

        /// <summary>Makes the lists of the triangles added since the last body.</summary>
        /// <param name="within">Bounds beyond which no particle is; null for none.</param>
        /// <param name="leastStretch">Smallest stretch of the triangles in use: their cells look farther by its inverse.</param>
        /// <param name="body">Receives cells and bounds; the pose is none.</param>
        /// <returns>False when there are no triangles.</returns>
        public bool TryEndBody(Bounds? within, float leastStretch, out CollisionBody body)
        {
            body = default;
            int count = triangles.Count - first;
            if (count == 0) return false;
            float looks = reach / leastStretch;
            bool deforms = ends.Count > 0;
            var grid = new BodyGrid(triangles.GetRange(first, count).ToArray(), deforms ? ends.ToArray() : null, looks, within, (uint)first,
                referenceCount);
            grids.Add(grid);
            FindDepths(grid, looks);
            solids.Clear();
            body = new CollisionBody
            {
                Rotation0 = Quaternion.identity,
                Rotation1 = Quaternion.identity,
                FirstCell = cellCount,
                GridOrigin = grid.Cells.Origin,
                CellSide = grid.Cells.Side,
                GridCounts = new Vector3Int(grid.Cells.CountX, grid.Cells.CountY, grid.Cells.CountZ),
                BoundsMin = grid.BoundsMin,
                BoundsMax = grid.BoundsMax,
                PartsPerMetre = 1f / (1.7f * looks),
                StretchDiagonal0 = Vector3.one,
                StretchDiagonal1 = Vector3.one,
                EndTriangles = (uint)ends.Count,
            };
            triangles.AddRange(ends);
            for (int i = 0; i < ends.Count; i++) edges.Add(0u); // read by nothing
            ends.Clear();
            first = triangles.Count;
            surfaces = 0u;
            cellCount += (uint)grid.Starts.Length;
            referenceCount += (uint)grid.References.Length;
            return true;
        }

        // Of the last body, whose cells look so far: twice as far as a wall is felt.
        private void FindDepths(BodyGrid grid, float looks)
        {
            if (!solids.Exists(s => s > 0)) return;
            int count = triangles.Count - first;
            using (var given = new NativeArray<BodyTriangle>(triangles.GetRange(first, count).ToArray(), Allocator.TempJob))
            using (var numbers = new NativeArray<int>(solids.ToArray(), Allocator.TempJob))
            using (var found = new NativeArray<uint>(edges.GetRange(first, count).ToArray(), Allocator.TempJob))
            {
                new BodyDepthJob
                {
                    Cells = grid.Cells, FirstReference = referenceCount, FirstTriangle = (uint)first, Depth = 0.5f * looks,
                    Triangles = given, Solids = numbers,
                    Starts = grid.Starts, References = grid.References, Edges = found,
                }.Run();
                for (int i = 0; i < count; i++) edges[first + i] = found[i];
            }
        }

        /// <summary>Bytes that the buffers take once all is copied.</summary>
        public long PlannedBytes =>
            GpuBuffers.BytesOf(TriangleRoom, BodyTriangle.Stride) +
            GpuBuffers.BytesOf(CellRoom + ReferenceRoom + TriangleRoom, sizeof(uint));

        private long TriangleRoom => WithSlack(triangles.Count, steady.Triangles);
        private long CellRoom => WithSlack(cellCount, steady.Cells);
        private long ReferenceRoom => WithSlack(referenceCount, steady.References);

        /// <summary>
        /// Copies all to the GPU; buffers are replaced only when they grow, and leave room for what is made anew to grow by half.
        /// </summary>
        public void Upload()
        {
            GpuBuffers.Reserve(ref triangleBuffer, "BodyTriangles", TriangleRoom, BodyTriangle.Stride);
            if (listBuffer == null || !HasRoom(CellRoom, ReferenceRoom, TriangleRoom))
            {
                GpuBuffers.Dispose(ref listBuffer);
                listBuffer = GpuBuffers.Create("BodyLists", CellRoom + ReferenceRoom + TriangleRoom, sizeof(uint));
                (cellsBegin, referencesBegin) = ((int)TriangleRoom, (int)(TriangleRoom + CellRoom));
            }
            Upload(default);
        }

        /// <summary>Copies what was added since <see cref="BeginDeforming"/>.</summary>
        /// <returns>False where the buffers are too small: all has to be made and copied anew.</returns>
        public bool TryUploadDeforming()
        {
            if (triangles.Count > triangleBuffer.count || !HasRoom(cellCount, referenceCount, edges.Count)) return false;
            Upload(steady);
            return true;
        }

        private bool HasRoom(long cells, long references, long triangleCount) => triangleCount <= cellsBegin &&
            cells <= referencesBegin - cellsBegin && references <= listBuffer.count - referencesBegin;

        private void Upload(Lengths from)
        {
            triangleBuffer.SetData(triangles, from.Triangles, from.Triangles, triangles.Count - from.Triangles);
            listBuffer.SetData(edges, from.Triangles, from.Triangles, edges.Count - from.Triangles);
            int cell = cellsBegin + (int)from.Cells, reference = referencesBegin + (int)from.References;
            foreach (BodyGrid grid in grids)
            {
                Append(grid.Starts, ref cell);
                Append(grid.References, ref reference);
            }
            DisposeGrids();
        }

        /// <summary>Records the globals of Shaders/Collision/Bodies.hlsl that are triangles and cells.</summary>
        public void Bind(CommandBuffer cmd, ComputeKernel kernel)
        {
            kernel.SetBuffer(cmd, TrianglesId, triangleBuffer);
            kernel.SetBuffer(cmd, ListsId, listBuffer);
            kernel.SetInt(cmd, ReferencesBeginId, referencesBegin);
            kernel.SetInt(cmd, CellsBeginId, cellsBegin);
        }

        public void Dispose()
        {
            DisposeGrids();
            GpuBuffers.Dispose(ref triangleBuffer);
            GpuBuffers.Dispose(ref listBuffer);
        }

        private void DisposeGrids()
        {
            foreach (BodyGrid grid in grids) grid.Dispose();
            grids.Clear();
        }

        private static long WithSlack(long count, long before) => count + (count - before) / 2;

        // Of the lists.
        private struct Lengths
        {
            public int Triangles, LeftOut;
            public uint Cells, References;
        }

        private void Append(NativeArray<uint> data, ref int at)
        {
            if (data.Length > 0) listBuffer.SetData(data, 0, at, data.Length);
            at += data.Length;
        }
    }
}
