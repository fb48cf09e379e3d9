using System;
using Unity.Collections;
using Unity.Jobs;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Lists of triangles by cell: a cell has each triangle whose box and plane are within the reach of the cell. A particle's own cell
    /// then has every triangle within that reach of it. Made by Burst jobs.
    /// </summary>
    internal sealed class BodyGrid : IDisposable
    {
        private const long MostCells = 2 * 1024 * 1024;

        // 64 MiB: lists that would be longer are of cells of twice the side, which takes a quarter of the memory.
        private const long MostReferences = 16 * 1024 * 1024;

        private NativeArray<uint> starts, references;

        /// <summary>Cells over the triangles' bounds, the reach added.</summary>
        /// <param name="triangles">The body's.</param>
        /// <param name="ends">Where their corners go, straight; null where they rest. The cells are larger then: these lists are made every
        /// frame.</param>
        /// <param name="reach">How far a cell looks [m].</param>
        /// <param name="within">Bounds beyond which no particle is; null for none.</param>
        /// <param name="firstTriangle">Number that the first triangle has in the lists.</param>
        /// <param name="firstReference">Number that the first entry of the lists has in the ranges.</param>
        public BodyGrid(BodyTriangle[] triangles, BodyTriangle[] ends, float reach, Bounds? within, uint firstTriangle = 0u,
            uint firstReference = 0u)
        {
            Vector3 min = Vector3.positiveInfinity, max = Vector3.negativeInfinity;
            for (int i = 0; i < triangles.Length; i++)
            {
                BodyTriangle end = ends == null ? triangles[i] : ends[i];
                min = Vector3.Min(min, Vector3.Min(triangles[i].Low, end.Low));
                max = Vector3.Max(max, Vector3.Max(triangles[i].High, end.High));
            }
            BoundsMin = min;
            BoundsMax = max;
            Vector3 low = min - reach * Vector3.one, high = max + reach * Vector3.one;
            if (within.HasValue)
            {
                Vector3 margin = 0.01f * reach * Vector3.one; // a particle on a face is in a cell
                low = Vector3.Max(low, within.Value.min - margin);
                high = Vector3.Min(high, within.Value.max + margin);
            }
            float side = ends == null ? 0.5f * reach : reach;
            using (var given = new NativeArray<BodyTriangle>(triangles, Allocator.TempJob))
            using (var goals = new NativeArray<BodyTriangle>(ends ?? triangles, Allocator.TempJob))
            {
                Count(given, goals, BodyCells.Over(low, high, reach, side, MostCells), firstReference);
                if (starts[Cells.Count] - (long)firstReference > MostReferences)
                {
                    Count(given, goals, BodyCells.Over(low, high, reach, 2f * side, MostCells), firstReference);
                }
                references = new NativeArray<uint>((int)(starts[Cells.Count] - firstReference), Allocator.Persistent,
                    NativeArrayOptions.UninitializedMemory);
                new BodyListJob
                {
                    Cells = Cells,
                    FirstReference = firstReference,
                    FirstTriangle = firstTriangle,
                    Triangles = given,
                    Ends = goals,
                    Starts = starts,
                    References = references,
                }.Run();
            }
        }

        public BodyCells Cells { get; private set; }
        public Vector3 BoundsMin { get; }
        public Vector3 BoundsMax { get; }

        /// <summary>Ranges of the cells in <see cref="References"/>: one entry more than cells.</summary>
        public NativeArray<uint> Starts => starts;

        /// <summary>Numbers of triangles, cell by cell.</summary>
        public NativeArray<uint> References => references;

        private void Count(NativeArray<BodyTriangle> triangles, NativeArray<BodyTriangle> ends, in BodyCells cells, uint firstReference)
        {
            Dispose();
            Cells = cells;
            starts = new NativeArray<uint>(cells.Count + 1, Allocator.Persistent);
            new BodyCountJob { Cells = cells, FirstReference = firstReference, Triangles = triangles, Ends = ends, Starts = starts }.Run();
        }

        public void Dispose()
        {
            if (starts.IsCreated) starts.Dispose();
            if (references.IsCreated) references.Dispose();
        }
    }
}
