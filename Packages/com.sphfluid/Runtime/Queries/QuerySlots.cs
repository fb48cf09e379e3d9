using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The requests of one kind: a place each, which the next one gets when it is removed, and their words on the GPU.</summary>
    internal sealed class QuerySlots
    {
        private readonly QueryKind kind;
        private readonly int words;
        private readonly Stack<int> free = new Stack<int>();
        private QueryWord[] items = Array.Empty<QueryWord>();
        private GraphicsBuffer buffer;
        private bool changed;

        public QuerySlots(QueryKind kind)
        {
            this.kind = kind;
            words = kind.Words;
        }

        /// <summary>Places in use, those of removed requests between them included.</summary>
        public int Used { get; private set; }

        /// <summary>Places before larger buffers are made.</summary>
        public int Capacity => items.Length / words;

        /// <summary>Number of requests.</summary>
        public int Count => Used - free.Count;

        /// <summary>The words on the GPU.</summary>
        public GraphicsBuffer Buffer => buffer;

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => GpuBuffers.Size(buffer);

        /// <summary>Adds a request of no words yet.</summary>
        /// <param name="generation">Its generation, 1 or more.</param>
        public FluidQuery Add(uint generation)
        {
            if (free.Count == 0 && Used == Capacity) Array.Resize(ref items, words * Math.Max(kind.Places, 2 * Used));
            int index = free.Count > 0 ? free.Pop() : Used++;
            items[words * index].Number = generation;
            changed = true;
            return new FluidQuery(kind, index, generation);
        }

        /// <summary>Whether a request of this kind is one of these.</summary>
        public bool Has(FluidQuery query) =>
            query.Generation != 0 && query.Kind == kind && query.Index < Used && items[words * query.Index].Number == query.Generation;

        /// <summary>Sets the vector of a request's first word.</summary>
        public void Set(FluidQuery query, Vector3 vector)
        {
            ref QueryWord word = ref items[words * query.Index];
            changed |= !word.Vector.Equals(vector);
            word.Vector = vector;
        }

        /// <summary>Sets another word.</summary>
        public void Set(FluidQuery query, int place, in QueryWord value)
        {
            ref QueryWord word = ref items[words * query.Index + place];
            changed |= word.Number != value.Number || !word.Vector.Equals(value.Vector);
            word = value;
        }

        /// <summary>Ends a request.</summary>
        public void Remove(FluidQuery query)
        {
            Array.Clear(items, words * query.Index, words);
            free.Push(query.Index);
            changed = true;
        }

        /// <summary>Copies what changed to the GPU.</summary>
        /// <param name="retired">Takes a buffer that is replaced.</param>
        public void Upload(RetiredBuffers retired)
        {
            if (Used == 0) return;
            if (buffer == null || buffer.count < items.Length)
            {
                if (buffer != null) retired.Add(buffer);
                buffer = GpuBuffers.Create($"Fluid Queries ({kind.Name})", items.Length, QueryWord.Stride);
                changed = true;
            }
            if (changed) buffer.SetData(items, 0, 0, words * Used);
            changed = false;
        }

        /// <summary>Frees the GPU memory.</summary>
        public void Free() => GpuBuffers.Dispose(ref buffer);
    }
}
