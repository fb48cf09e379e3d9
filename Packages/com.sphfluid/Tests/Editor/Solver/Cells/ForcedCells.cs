using System;

namespace SphFluid.Tests
{
    /// <summary>While it lives, liquids that start store all cells or only those with particles, whatever their domain.</summary>
    internal sealed class ForcedCells : IDisposable
    {
        private readonly int before = SparseCells.MostDense;

        public ForcedCells(bool sparse) => SparseCells.MostDense = sparse ? 0 : int.MaxValue;

        public void Dispose() => SparseCells.MostDense = before;
    }
}
