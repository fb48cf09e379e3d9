using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Text;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// What the statics of the packages' assemblies hold, read by reflection. Those that may outlive play are passed over.
    /// </summary>
    internal static class StaticState
    {
        private const BindingFlags Statics = BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;
        private const BindingFlags Instance = BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic |
            BindingFlags.DeclaredOnly;

        /// <summary>A line of text for each static field, down to the last number; what belongs to the engine is marked.</summary>
        public static Dictionary<string, string> Read()
        {
            var read = new Dictionary<string, string>();
            foreach (Type type in AppDomain.CurrentDomain.GetAssemblies().Where(IsOurs).SelectMany(a => a.GetTypes()).SelectMany(Closed))
                foreach (FieldInfo field in type.GetFields(Statics).Where(f => !f.IsLiteral && !MayStay(f)))
                {
                    read[$"{type}.{field.Name}"] = Tell(field.GetValue(null));
                }
            return read;
        }

        /// <summary>A value as text, with everything that it leads to.</summary>
        public static string Tell(object value)
        {
            var text = new StringBuilder();
            Tell(text, value, new HashSet<object>(new ByReference()));
            return text.ToString();
        }

        /// <summary>Whether a value leads to an object of the engine, alive or not.</summary>
        public static bool LeadsToTheEngine(string told) => told.Contains("<Unity");

        private static bool IsOurs(Assembly assembly) => assembly.GetName().Name.StartsWith("SphFluid") &&
            !assembly.GetName().Name.Contains("Tests");

        private static IEnumerable<Type> Closed(Type type)
        {
            if (!type.ContainsGenericParameters) return new[] { type };
            return type != typeof(FluidParts<>) ? Enumerable.Empty<Type>() : type.Assembly.GetTypes().SelectMany(t => t.GetInterfaces())
                .Where(i => i.IsGenericType && i.GetGenericTypeDefinition() == typeof(IFluidPart<>)).Distinct()
                .Select(i => type.MakeGenericType(i.GetGenericArguments()));
        }

        private static bool MayStay(FieldInfo field)
        {
            string property = field.Name.StartsWith("<") ? field.Name.Substring(1, field.Name.IndexOf('>') - 1) : "";
            return field.IsDefined(typeof(OutlivesPlayAttribute), false) || field.Name.StartsWith("<>")
                || field.DeclaringType.GetProperty(property, Statics)?.IsDefined(typeof(OutlivesPlayAttribute), false) == true;
        }

        private static void Tell(StringBuilder text, object value, HashSet<object> above)
        {
            Type type = value?.GetType();
            if (value is null || type.IsPrimitive || type.IsEnum || value is string || value is decimal ||
                value is MemberInfo) text.Append(value ?? "null");
            else if (value
                is Delegate action) text
                    .Append(string.Join(", ", action.GetInvocationList().Select(d => $"{d.Method.DeclaringType}.{d.Method.Name}")));
            else if (!above.Add(value)) text.Append("as above");
            else if (value is Object ||
                (type.IsClass && !type.IsArray && type.Assembly.GetName().Name.StartsWith("Unity"))) text.Append($"<{type}>");
            else if (value is IEnumerable items && (type.IsArray || type.Namespace.StartsWith("System")))
            {
                text.Append('[');
                foreach (object item in items) Next(text, item, above);
                text.Append(']');
            }
            else
            {
                text.Append('{');
                for (Type part = type; part != null && part != typeof(object) && part != typeof(ValueType); part = part.BaseType)
                    foreach (FieldInfo field in part.GetFields(Instance)
                        .Where(f => !f.FieldType.IsPointer && f.FieldType != typeof(IntPtr)))
                    {
                        Next(text, field.GetValue(value), above);
                    }
                text.Append('}');
            }
        }

        private static void Next(StringBuilder text, object value, HashSet<object> above)
        {
            Tell(text, value, above);
            text.Append("; ");
        }

        private sealed class ByReference : IEqualityComparer<object>
        {
            bool IEqualityComparer<object>.Equals(object a, object b) => ReferenceEquals(a, b);

            int IEqualityComparer<object>.GetHashCode(object value) => RuntimeHelpers.GetHashCode(value);
        }
    }
}
