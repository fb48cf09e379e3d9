using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace SphFluid
{
    /// <summary>Where each cell's list begins: counts the triangles of each cell and sums them up.</summary>
    [BurstCompile(FloatPrecision.High, FloatMode.Strict)]
    internal struct BodyCountJob : IJob
    {
        public BodyCells Cells;
        public uint FirstReference;

        [ReadOnly] public NativeArray<BodyTriangle> Triangles;

        /// <summary>Where they go; the same where they rest.</summary>
        [ReadOnly] public NativeArray<BodyTriangle> Ends;

        /// <summary>One entry more than cells.</summary>
        public NativeArray<uint> Starts;

        public void Execute()
        {
            Starts[0] = FirstReference;
            for (int t = 0; t < Triangles.Length; t++)
            {
                var walk = new BodyCellWalk(Cells, Triangles[t], Ends[t]);
                while (walk.Next()) Starts[walk.Number + 1] += 1u;
            }

            for (int cell = 0; cell + 1 < Starts.Length; cell++) Starts[cell + 1] += Starts[cell];
        }
    }

    /// <summary>Each cell's list of triangles, in their order.</summary>
    [BurstCompile(FloatPrecision.High, FloatMode.Strict)]
    internal struct BodyListJob : IJob
    {
        public BodyCells Cells;
        public uint FirstReference;
        public uint FirstTriangle;

        [ReadOnly] public NativeArray<BodyTriangle> Triangles;

        /// <summary>Where they go; the same where they rest.</summary>
        [ReadOnly] public NativeArray<BodyTriangle> Ends;

        /// <summary>As <see cref="BodyCountJob"/> left them; unchanged in the end.</summary>
        public NativeArray<uint> Starts;

        [WriteOnly] public NativeArray<uint> References;

        public void Execute()
        {
            for (int t = 0; t < Triangles.Length; t++)
            {
                var walk = new BodyCellWalk(Cells, Triangles[t], Ends[t]);
                while (walk.Next())
                {
                    References[(int)(Starts[walk.Number] - FirstReference)] = FirstTriangle + (uint)t;
                    Starts[walk.Number] += 1u;
                }
            }

            // Filling a list moves its start to its end, the start of the next: one place back restores all.
            for (int cell = Starts.Length - 1; cell > 0; cell--) Starts[cell] = Starts[cell - 1];
            Starts[0] = FirstReference;
        }
    }
}
