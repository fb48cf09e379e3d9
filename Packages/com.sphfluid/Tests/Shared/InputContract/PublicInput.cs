using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// A number or a choice that users set, found in the public API: a property, a field of a value, and the serialised field behind it.
    /// </summary>
    internal sealed class PublicInput
    {
        private const BindingFlags Public = BindingFlags.Instance | BindingFlags.Public,
            Hidden = BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public;

        private readonly MemberInfo[] path;   // as scripts go
        private readonly MemberInfo[] stored; // as a scene file has it; null: no file has it

        private PublicInput(MemberInfo[] path, MemberInfo[] stored)
        {
            this.path = path;
            this.stored = stored;
        }

        /// <summary>Name of the member, with what it is in: Boundaries.LowX.</summary>
        public string Name => string.Join(".", path.Select(m => m.Name));

        /// <summary>Name of the member.</summary>
        public string Label => path[path.Length - 1].Name;

        /// <summary>What it is.</summary>
        public Type Type => TypeOf(path[path.Length - 1]);

        /// <summary>Type that has the member.</summary>
        public Type Declaring => path[path.Length - 1].DeclaringType;

        /// <summary>Whether a scene file can set it past the property.</summary>
        public bool IsStored => stored != null;

        /// <summary>Smallest and largest value by the attributes of its field.</summary>
        public (double least, double most) Declared
        {
            get
            {
                MemberInfo field = stored?[stored.Length - 1] ?? path[path.Length - 1];
                if (field.GetCustomAttribute<RangeAttribute>() is RangeAttribute range) return (range.min, range.max);
                return (field.GetCustomAttribute<MinAttribute>() is MinAttribute min ? min.min : double.NegativeInfinity,
                    double.PositiveInfinity);
            }
        }

        /// <summary>The field's tooltip.</summary>
        public string Tooltip => (stored?[stored.Length - 1] ?? path[path.Length - 1]).GetCustomAttribute<TooltipAttribute>()?.tooltip ??
            "";

        public object Get(object root) => path.Aggregate(root, (inner, member) => ValueOf(member, inner));

        /// <summary>Sets it as a script does.</summary>
        public void Set(object root, object value) => Set(root, path, 0, value);

        /// <summary>Sets it as a scene file does.</summary>
        public void Store(object root, object value) => Set(root, stored, 0, value);

        /// <summary>All of a type.</summary>
        public static List<PublicInput> Of(Type type)
        {
            var found = new List<PublicInput>();
            Find(type, new MemberInfo[0], new MemberInfo[0], found);
            return found;
        }

        private static void Find(Type type, MemberInfo[] path, MemberInfo[] stored, List<PublicInput> found)
        {
            bool isFile = typeof(Object).IsAssignableFrom(type) || path.Length > 0;
            foreach (MemberInfo member in type.GetMembers(Public))
            {
                if (!PublicCalls.IsOurs(member.DeclaringType) || !IsInput(member)) continue;
                MemberInfo[] way = path.Append(member).ToArray();
                MemberInfo field = stored == null ? null : member is FieldInfo ? member : FieldOf(type, member);
                MemberInfo[] file = field == null || !isFile ? null : stored.Append(field).ToArray();
                if (BadValues.Has(TypeOf(member))) found.Add(new PublicInput(way, file));
                else Find(TypeOf(member), way, file, found);
            }
        }

        // What can be set, or is of a kind whose members can.
        private static bool IsInput(MemberInfo member)
        {
            Type type = member is FieldInfo || member is PropertyInfo ? TypeOf(member) : typeof(void);
            bool isSet = member is FieldInfo field ? !field.IsInitOnly && !field.IsLiteral
                : member is PropertyInfo property && property.GetIndexParameters().Length == 0 && property.GetGetMethod() != null &&
                    property.GetSetMethod() != null;
            if (BadValues.Has(type)) return isSet;
            if (!PublicCalls.IsOurs(type) || typeof(Object).IsAssignableFrom(type) || !type.IsSerializable) return false;
            return type.IsValueType ? isSet : type.IsClass;
        }

        // particleSpacing of Spacing.
        private static FieldInfo FieldOf(Type type, MemberInfo member)
        {
            for (; type != null && PublicCalls.IsOurs(type); type = type.BaseType)
                foreach (FieldInfo field in type.GetFields(Hidden | BindingFlags.DeclaredOnly))
                    if (field.FieldType == TypeOf(member) && field.IsDefined(typeof(SerializeField)) &&
                        field.Name.EndsWith(member.Name, StringComparison.OrdinalIgnoreCase))
                    {
                        return field;
                    }
            return null;
        }

        private static void Set(object outer, MemberInfo[] way, int at, object value)
        {
            if (at < way.Length - 1)
            {
                object inner = ValueOf(way[at], outer);
                Set(inner, way, at + 1, value);
                if (!inner.GetType().IsValueType) return;
                value = inner;
            }
            if (way[at] is FieldInfo field) field.SetValue(outer, value);
            else
            {
                try
                {
                    ((PropertyInfo)way[at]).SetValue(outer, value);
                }
                catch (TargetInvocationException exception)
                {
                    throw exception.InnerException;
                }
            }
        }

        private static object ValueOf(MemberInfo member, object outer) => member is FieldInfo field ? field.GetValue(outer)
            : ((PropertyInfo)member).GetValue(outer);

        private static Type TypeOf(MemberInfo member) => member is FieldInfo field ? field.FieldType : ((PropertyInfo)member).PropertyType;
    }
}
