using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Enabled components of a kind in all loaded scenes, in the order of the hierarchy as of the last that came; asking makes no garbage.</summary>
    internal sealed class ActiveComponents<T> where T : Component
    {
        readonly List<T> components = new List<T>();
        bool isSorted = true;

        /// <summary>The components.</summary>
        public IReadOnlyList<T> InOrder
        {
            get
            {
                if (!isSorted) components.Sort(HierarchyOrder.Compare);
                isSorted = true;
                return components;
            }
        }

        /// <summary>One was enabled.</summary>
        public void Add(T component)
        {
            components.Add(component);
            isSorted = components.Count == 1;
        }

        /// <summary>One was disabled.</summary>
        public void Remove(T component) => components.Remove(component);

        /// <summary>Forgets all.</summary>
        public void Clear() => components.Clear();
    }
}
