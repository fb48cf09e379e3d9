using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>The GPU buffers that an object holds, itself or by what it holds: found by its fields.</summary>
    internal static class ReachableBuffers
    {
        private const BindingFlags Fields = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic |
            BindingFlags.DeclaredOnly;

        public static IReadOnlyList<GraphicsBuffer> Of(object owner)
        {
            var found = new HashSet<GraphicsBuffer>();
            Visit(owner, found, new HashSet<object>(new ByReference()));
            return found.ToArray();
        }

        public static long Bytes(object owner) => Of(owner).Sum(b => (long)b.count * b.stride);

        private static void Visit(object value, HashSet<GraphicsBuffer> found, HashSet<object> seen)
        {
            if (value is GraphicsBuffer buffer)
            {
                found.Add(buffer);
                return;
            }
            if (value == null || !seen.Add(value)) return;
            if (value is IEnumerable items && !(value is string))
            {
                foreach (object item in items)
                    if (item is GraphicsBuffer || IsOurs(item)) Visit(item, found, seen);
                return;
            }
            if (!IsOurs(value)) return;
            for (Type type = value.GetType(); type != null && type != typeof(object); type = type.BaseType)
                foreach (FieldInfo field in type.GetFields(Fields))
                    if (!field.FieldType.IsPrimitive) Visit(field.GetValue(value), found, seen);
        }

        // Objects of the package; assets and components are shared, not held.
        private static bool IsOurs(object value) =>
            value != null && !(value is UnityEngine.Object) && !(value is Delegate) &&
                ProductTypes.Assemblies.Contains(value.GetType().Assembly);

        private sealed class ByReference : IEqualityComparer<object>
        {
            bool IEqualityComparer<object>.Equals(object a, object b) => ReferenceEquals(a, b);

            int IEqualityComparer<object>.GetHashCode(object value) => System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode(value);
        }
    }
}
