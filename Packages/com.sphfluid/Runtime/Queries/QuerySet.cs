using System;
using System.Linq;

namespace SphFluid
{
    /// <summary>The requests of all kinds; their answers lie in one buffer, kind after kind.</summary>
    internal sealed class QuerySet
    {
        private readonly QuerySlots[] kinds = new QuerySlots[QueryKind.All.Count];
        private uint lastGeneration;

        public QuerySet()
        {
            foreach (QueryKind kind in QueryKind.All) kinds[kind.Index] = new QuerySlots(kind);
        }

        /// <summary>The requests of a kind.</summary>
        public QuerySlots this[QueryKind kind] => kinds[kind.Index];

        /// <summary>Number of requests.</summary>
        public int Count
        {
            get
            {
                int sum = 0;
                foreach (QuerySlots slots in kinds) sum += slots.Count;
                return sum;
            }
        }

        /// <summary>Places before larger buffers are made.</summary>
        public int Capacity
        {
            get
            {
                int sum = 0;
                foreach (QuerySlots slots in kinds) sum += slots.Capacity;
                return sum;
            }
        }

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => kinds.Sum(s => s.GpuBytes);

        /// <summary>Adds a request of no words yet.</summary>
        public FluidQuery Add(QueryKind kind) => this[kind].Add(lastGeneration = Math.Max(1, unchecked(lastGeneration + 1)));

        /// <summary>Ends a request; one that is none or was removed before is left as it is.</summary>
        public void Remove(FluidQuery query)
        {
            QuerySlots slots = this[query.Kind];
            if (slots.Has(query)) slots.Remove(query);
        }

        /// <summary>Checks that a request is one of these.</summary>
        /// <exception cref="ArgumentException">It was removed, or is of another kind.</exception>
        public void Require(FluidQuery query, QueryKind kind)
        {
            if (!this[kind].Has(query))
            {
                throw new ArgumentException($"The query was removed, or is no {kind.Name}'s. Add it first.", nameof(query));
            }
        }

        /// <summary>Where the answers of each kind begin, and, last, how many there are.</summary>
        /// <param name="firsts">Receives them: one more than there are kinds.</param>
        public void CopyRanges(int[] firsts)
        {
            firsts[0] = 0;
            for (int kind = 0; kind < kinds.Length; kind++) firsts[kind + 1] = firsts[kind] + kinds[kind].Used;
        }

        /// <summary>Copies what changed to the GPU.</summary>
        /// <param name="retired">Takes buffers that are replaced.</param>
        public void Upload(RetiredBuffers retired)
        {
            foreach (QuerySlots slots in kinds) slots.Upload(retired);
        }

        /// <summary>Frees the GPU memory.</summary>
        public void Free()
        {
            foreach (QuerySlots slots in kinds) slots.Free();
        }
    }
}
