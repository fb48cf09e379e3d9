using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Order of components as the hierarchy window shows them, the same in every session, unlike instance ids.</summary>
    internal static class HierarchyOrder
    {
        /// <summary>Compares two components of loaded scenes.</summary>
        public static int Compare(Component a, Component b)
        {
            if (ReferenceEquals(a, b)) return 0;
            if (ReferenceEquals(a.transform, b.transform)) return IndexOnObject(a).CompareTo(IndexOnObject(b));
            List<int> pathA = Path(a.transform), pathB = Path(b.transform);
            for (int i = 0; i < Math.Min(pathA.Count, pathB.Count); i++)
                if (pathA[i] != pathB[i]) return pathA[i].CompareTo(pathB[i]);
            int byDepth = pathA.Count.CompareTo(pathB.Count);
            return byDepth != 0 ? byDepth : string.CompareOrdinal(a.gameObject.scene.path, b.gameObject.scene.path);
        }

        private static List<int> Path(Transform transform)
        {
            var path = new List<int>();
            for (Transform t = transform; t != null; t = t.parent) path.Add(t.GetSiblingIndex());
            path.Reverse();
            return path;
        }

        private static int IndexOnObject(Component component) =>
            Array.IndexOf(component.gameObject.GetComponents<Component>(), component);
    }
}
