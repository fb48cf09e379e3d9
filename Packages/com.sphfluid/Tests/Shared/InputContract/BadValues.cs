using System;
using System.Collections;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What a number or a choice should not be. Of vectors, lists and the like one part is bad at a time, each in turn.</summary>
    internal static class BadValues
    {
        private static readonly double[] Numbers = { double.NaN, double.PositiveInfinity, double.NegativeInfinity, -1.0, 0.0, 1e30 };
        private static readonly long[] Counts = { long.MinValue, -1L, 0L, long.MaxValue };

        private static readonly Dictionary<Type, int> Parts = new Dictionary<Type, int>
        {
            [typeof(Vector2)] = 2, [typeof(Vector3)] = 3, [typeof(Vector4)] = 4, [typeof(Quaternion)] = 4, [typeof(Color)] = 4,
            [typeof(Matrix4x4)] = 16,
            [typeof(Vector2Int)] = 2, [typeof(Vector3Int)] = 3,
        };

        /// <summary>Whether a type is a number, a choice, or made of numbers.</summary>
        public static bool Has(Type type)
        {
            type = Nullable.GetUnderlyingType(type) ?? type;
            return type.IsEnum || type == typeof(float) || type == typeof(double) || type == typeof(int) || type == typeof(uint) ||
                type == typeof(long) ||
                Parts.ContainsKey(type) || ElementOf(type) is Type element && Has(element);
        }

        /// <summary>Every bad value of a type, made of a good one.</summary>
        public static IEnumerable<object> Of(Type type, object good)
        {
            type = Nullable.GetUnderlyingType(type) ?? type;
            if (type.IsEnum) return new[] { Enum.ToObject(type, 12345), Enum.ToObject(type, -1) };
            if (type == typeof(float)) return Array.ConvertAll(Numbers, n => (object)(float)n);
            if (type == typeof(double)) return Array.ConvertAll(Numbers, n => (object)n);
            if (type == typeof(int)) return Array.ConvertAll(Counts, n => (object)(int)Math.Max(int.MinValue, Math.Min(int.MaxValue, n)));
            if (type == typeof(long)) return Array.ConvertAll(Counts, n => (object)n);
            if (type == typeof(uint)) return new object[] { 0u, uint.MaxValue };
            return ElementOf(type) == null ? OfParts(type, good) : OfElements((IList)good);
        }

        /// <summary>The numbers and choices that a value is made of.</summary>
        public static IEnumerable<object> PartsOf(object value)
        {
            if (value is IList list)
            {
                foreach (object element in list)
                    foreach (object part in PartsOf(element)) yield return part;
            }
            else if (value != null && Parts.TryGetValue(value.GetType(), out int count))
            {
                for (int i = 0; i < count; i++) yield return Part(value.GetType()).GetValue(value, new object[] { i });
            }
            else yield return value;
        }

        /// <summary>Whether all of its numbers can be computed with, and all of its choices are some.</summary>
        public static bool IsUsable(object value)
        {
            foreach (object part in PartsOf(value))
            {
                if (part is float f && (float.IsNaN(f) || float.IsInfinity(f)) || part is double d &&
                    (double.IsNaN(d) || double.IsInfinity(d)))
                {
                    return false;
                }
                if (part is Enum && !IsNamed(part)) return false;
            }
            return true;
        }

        /// <summary>Smallest and largest of its numbers.</summary>
        public static (double least, double most) RangeOf(object value)
        {
            (double least, double most) = (double.PositiveInfinity, double.NegativeInfinity);
            foreach (object part in PartsOf(value))
            {
                if (part is Enum || part == null) continue;
                double number = Convert.ToDouble(part);
                (least, most) = (Math.Min(least, number), Math.Max(most, number));
            }
            return (least, most);
        }

        /// <summary>Whether two values are the same, NaN included.</summary>
        public static bool Same(object a, object b)
        {
            using (IEnumerator<object> first = PartsOf(a).GetEnumerator(), second = PartsOf(b).GetEnumerator())
            {
                while (first.MoveNext())
                    if (!second.MoveNext() || !Equals(first.Current, second.Current)) return false;
                return !second.MoveNext();
            }
        }

        /// <summary>A value as a failure shows it.</summary>
        public static string Text(object value) => value is IList || value != null &&
            Parts.ContainsKey(value.GetType()) ? "(" + string.Join(", ", PartsOf(value)) + ")" : $"{value}";

        private static bool IsNamed(object choice)
        {
            Type type = choice.GetType();
            if (!type.IsDefined(typeof(FlagsAttribute), false)) return Enum.IsDefined(type, choice);
            long all = 0;
            foreach (object one in Enum.GetValues(type)) all |= Convert.ToInt64(one);
            return (Convert.ToInt64(choice) & ~all) == 0;
        }

        private static IEnumerable<object> OfParts(Type type, object good)
        {
            object first = Part(type).GetValue(good, new object[] { 0 });
            int place = 0;
            foreach (object bad in Of(first.GetType(), first))
            {
                // Unboxed and boxed again: a copy.
                object changed = typeof(object).GetMethod("MemberwiseClone", BindingFlags.Instance | BindingFlags.NonPublic)
                    .Invoke(good, null);
                Part(type).SetValue(changed, bad, new object[] { place++ % Parts[type] });
                yield return changed;
            }
        }

        private static IEnumerable<object> OfElements(IList good)
        {
            int place = 0;
            foreach (object bad in Of(good[0].GetType(), good[0]))
            {
                Array changed = Array.CreateInstance(good[0].GetType(), good.Count);
                good.CopyTo(changed, 0);
                changed.SetValue(bad, place++ % good.Count);
                yield return changed;
            }
        }

        private static PropertyInfo Part(Type type) => type.GetProperty("Item", new[] { typeof(int) });

        private static Type ElementOf(Type type) => type.IsArray ? type.GetElementType()
            : type.IsGenericType && type.IsInterface && typeof(IEnumerable).IsAssignableFrom(type) ? type.GetGenericArguments()[0] : null;
    }
}
