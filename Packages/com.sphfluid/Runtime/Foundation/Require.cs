using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// What arguments must be; else an <see cref="ArgumentException"/> names the argument, its value and what it must be.
    /// </summary>
    internal static class Require
    {
        public static double Positive(double value, string name) =>
            That(value > 0.0 && !double.IsInfinity(value), value, name, "a positive number");
        public static double NotNegative(double value, string name) =>
            That(value >= 0.0 && !double.IsInfinity(value), value, name, "zero or a positive number");
        public static void Within(double value, double least, double most, string name)
        {
            if (!(value >= least && value <= most)) That(false, value, name, FormattableString.Invariant($"from {least} to {most}"));
        }

        /// <summary>What can be summed over a lattice.</summary>
        public static void SupportRatio(double ratio) => Within(ratio, 0.0, 64.0, "SupportRatio, SupportRadius over Spacing,");

        public static Vector3 Finite(Vector3 value, string name) => That(AffineMath.IsFinite(value), value, name, "three finite numbers");
        public static void Finite(in Matrix4x4 value, string name)
        {
            bool isFinite = true;
            for (int i = 0; i < 16; i++) isFinite &= AffineMath.IsFinite(value[i]);
            That(isFinite, value, name, "finite numbers");
        }

        public static void Size(Vector3 value, string name) =>
            That(AffineMath.IsFinite(value) && value.x > 0f && value.y > 0f && value.z > 0f, value, name, "three positive edge lengths");
        public static void Area(Vector2 value, string name) =>
            That(AffineMath.IsFinite(value) && value.x > 0f && value.y > 0f, value, name, "two positive edge lengths");
        public static void Rotation(Quaternion value, string name)
        {
            float norm = value.x * value.x + value.y * value.y + value.z * value.z + value.w * value.w;
            That(Mathf.Abs(norm - 1f) < 1e-3f, value, name, "a quaternion of length 1");
        }

        /// <summary>A place named centre and rotation.</summary>
        public static void Place(Vector3 centre, Quaternion rotation)
        {
            Finite(centre, nameof(centre));
            Rotation(rotation, nameof(rotation));
        }

        public static void Known<T>(T choice, string name)
            where T : struct,
                Enum =>
                    That(EqualityComparer<T>.Default.Equals(Limits.Known(choice), choice), choice, name,
                        "one of the choices that there are");

        private static T That<T>(bool holds, T value, string name, string must) =>
            holds ? value : throw new ArgumentException(FormattableString.Invariant($"{name} is {value}; it must be {must}."), name);
    }
}
