using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Brings settings into their range: not a number counts as the least, infinity as the largest number, a choice that there is not as
    /// the first one.
    /// </summary>
    internal static class Limits
    {
        /// <summary>A number from least to most.</summary>
        public static float Clamp(float value, float least, float most = float.MaxValue) => value > least ? Mathf.Min(value, most) : least;

        /// <summary>Lengths, none below 0.</summary>
        public static Vector3 NotNegative(Vector3 value) => new Vector3(Clamp(value.x, 0f), Clamp(value.y, 0f), Clamp(value.z, 0f));

        /// <summary>Any number; not a number counts as 0.</summary>
        public static float Finite(float value) => float.IsNaN(value) ? 0f : Mathf.Clamp(value, float.MinValue, float.MaxValue);

        /// <summary>A colour of numbers.</summary>
        public static Color Finite(Color value) => new Color(Finite(value.r), Finite(value.g), Finite(value.b), Finite(value.a));

        /// <summary>One of the choices that there are: a scene's may be from another version of the package.</summary>
        public static T Known<T>(T choice) where T : struct, Enum => Array.IndexOf(Choices<T>.All, choice) >= 0 ? choice
            : Choices<T>.All[0];

        private static class Choices<T>
        {
            public static readonly T[] All = (T[])Enum.GetValues(typeof(T));
        }
    }
}
