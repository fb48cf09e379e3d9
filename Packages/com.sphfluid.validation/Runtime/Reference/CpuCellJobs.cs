using Unity.Burst;
using Unity.Collections;
using Unity.Jobs;

namespace SphFluid.Validation
{
    /// <summary>Thesis 6.2.2: the cell of each particle.</summary>
    [BurstCompile(FloatPrecision.High, FloatMode.Strict)]
    internal struct CpuCellJob : IJobParallelFor
    {
        public CpuNeighbours Neighbours;

        [ReadOnly] public NativeArray<CpuFluidParticle> Particles;

        [WriteOnly] public NativeArray<int> Cells;

        public void Execute(int index)
        {
            Cells[index] = Neighbours.Cell(Particles[index].Position);
        }
    }

    /// <summary>
    /// Thesis 6.2.3 to 6.2.5 by a counting sort: by cell, then by place in the old order, which is what the bitonic sort of
    /// (cell, place) gives. Worked example: cells 2 0 2 give Order 1 0 2 and First 0 1 1 3.
    /// </summary>
    [BurstCompile]
    internal struct CpuCellListJob : IJob
    {
        [ReadOnly] public NativeArray<int> Cells;

        public NativeArray<int> First;

        public NativeArray<int> Order;

        public void Execute()
        {
            for (int c = 0; c < First.Length; c++) First[c] = 0;

            for (int i = 0; i < Cells.Length; i++) First[Cells[i] + 1] += 1;

            for (int c = 1; c < First.Length; c++) First[c] += First[c - 1];

            // Filling a cell moves its start to its end, the start of the next: one place back restores all.
            for (int i = 0; i < Cells.Length; i++)
            {
                int cell = Cells[i];
                Order[First[cell]] = i;
                First[cell] += 1;
            }

            for (int c = First.Length - 1; c > 0; c--) First[c] = First[c - 1];

            First[0] = 0;
        }
    }

    /// <summary>Thesis 6.2.6: the particles in the order of their cells.</summary>
    [BurstCompile]
    internal struct CpuReorderJob : IJobParallelFor
    {
        [ReadOnly] public NativeArray<CpuFluidParticle> Source;

        [ReadOnly] public NativeArray<int> Order;

        [WriteOnly] public NativeArray<CpuFluidParticle> Sorted;

        public void Execute(int index)
        {
            Sorted[index] = Source[Order[index]];
        }
    }
}
