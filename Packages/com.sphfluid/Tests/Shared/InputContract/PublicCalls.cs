using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace SphFluid.Tests
{
    /// <summary>A number or a choice of an argument: itself, or a member of a value, or of the first of a list of values.</summary>
    internal sealed class ArgumentInput
    {
        private readonly int place;
        private readonly PublicInput member; // null: the argument itself
        private readonly FieldInfo own;      // of a method's own constants within settings; null: not of those

        private ArgumentInput(ParameterInfo parameter, PublicInput member, FieldInfo own)
        {
            place = parameter.Position;
            Parameter = parameter.Name;
            Name = own?.Name ?? member?.Label ?? parameter.Name;
            this.member = member;
            this.own = own;
            Type = own?.FieldType ?? member?.Type ?? PublicCalls.Plain(parameter.ParameterType);
        }

        /// <summary>Name of the argument.</summary>
        public string Parameter { get; }

        /// <summary>Name of the number.</summary>
        public string Name { get; }

        public Type Type { get; }

        /// <summary>All numbers and choices of a call's arguments.</summary>
        public static IEnumerable<ArgumentInput> Of(MethodBase call, Func<ParameterInfo, object> example)
        {
            foreach (ParameterInfo parameter in call.GetParameters())
            {
                Type type = PublicCalls.Plain(parameter.ParameterType);
                if (parameter.IsOut) continue;
                if (BadValues.Has(type))
                {
                    yield return new ArgumentInput(parameter, null, null);
                    continue;
                }
                if (PublicCalls.ElementOf(type) is Type element) type = element;
                if (!PublicCalls.IsOurs(type) || !type.IsValueType && type.GetConstructor(Type.EmptyTypes) == null ||
                    typeof(UnityEngine.Object).IsAssignableFrom(type))
                {
                    continue;
                }
                foreach (PublicInput member in PublicInput.Of(type)) yield return new ArgumentInput(parameter, member, null);
                if (type != typeof(FluidSolverSettings)) continue;
                foreach (FieldInfo constant in OwnOf(example(parameter)).GetType().GetFields(BindingFlags.Instance | BindingFlags.Public))
                    if (BadValues.Has(constant.FieldType)) yield return new ArgumentInput(parameter, null, constant);
            }
        }

        public object Get(object[] arguments) => own != null ? own.GetValue(OwnOf(arguments[place])) : member != null
            ? member.Get(FirstOf(arguments[place])) : arguments[place];

        /// <summary>The arguments with another value of this.</summary>
        public object[] With(object[] arguments, object value)
        {
            var changed = (object[])arguments.Clone();
            if (own != null)
            {
                object settings = Copy(arguments[place]), constants = Copy(OwnOf(settings));
                own.SetValue(constants, value);
                OwnField.SetValue(settings, constants);
                changed[place] = settings;
            }
            else if (member == null) changed[place] = value;
            else
            {
                object holder = Copy(FirstOf(arguments[place]));
                member.Set(holder, value);
                changed[place] = holder;
                if (arguments[place] is IList list)
                {
                    Array copy = Array.CreateInstance(holder.GetType(), list.Count);
                    list.CopyTo(copy, 0);
                    copy.SetValue(holder, 0);
                    changed[place] = copy;
                }
            }
            return changed;
        }

        private static FieldInfo OwnField => typeof(FluidSolverSettings).GetField("own", BindingFlags.Instance | BindingFlags.NonPublic);

        private static object OwnOf(object settings) => OwnField.GetValue(settings);

        private static object FirstOf(object argument) => argument is IList list ? list[0] : argument;

        private static object Copy(object value) =>
            typeof(object).GetMethod("MemberwiseClone", BindingFlags.Instance | BindingFlags.NonPublic).Invoke(value, null);
    }

    /// <summary>Calls of the public API that take numbers.</summary>
    internal static class PublicCalls
    {
        /// <summary>Whether a type is of one of the packages for games.</summary>
        public static bool IsOurs(Type type) => type.Namespace == "SphFluid";

        /// <summary>Methods and constructors of an assembly, of all that is for games.</summary>
        public static IEnumerable<MethodBase> Of(Assembly assembly)
        {
            const BindingFlags flags = BindingFlags.Public | BindingFlags.Instance | BindingFlags.Static | BindingFlags.DeclaredOnly;
            foreach (Type type in assembly.GetExportedTypes())
            {
                if (!IsOurs(type) || type.IsInterface || typeof(Delegate).IsAssignableFrom(type)) continue;
                foreach (MethodBase call in type.GetMethods(flags).Cast<MethodBase>().Concat(type.GetConstructors(flags)))
                {
                    bool isPlain = call is ConstructorInfo && !type.IsAbstract || !call.IsSpecialName && !call.IsGenericMethod &&
                        call.Name != "Equals";
                    if (isPlain && call.GetParameters().Any(p => !p.IsOut)) yield return call;
                }
                foreach (PropertyInfo property in type.GetProperties(flags))
                    if (property.GetSetMethod() is MethodInfo setter && !typeof(UnityEngine.Object).IsAssignableFrom(type) &&
                        !type.IsSerializable && BadValues.Has(property.PropertyType))
                    {
                        yield return setter;
                    }
            }
        }

        /// <summary>Name of a call with its parameters.</summary>
        public static string NameOf(MethodBase call) =>
            $"{call.DeclaringType.Name}.{(call is ConstructorInfo ? "new" : call.Name)}" +
            $"({string.Join(", ", call.GetParameters().Select(p => p.Name))})";

        /// <summary>A type without "in", "ref" and "?".</summary>
        public static Type Plain(Type type)
        {
            if (type.IsByRef) type = type.GetElementType();
            return Nullable.GetUnderlyingType(type) ?? type;
        }

        /// <summary>What a list has; null: it is none.</summary>
        public static Type ElementOf(Type type) => type.IsArray ? type.GetElementType()
            : type.IsGenericType && type.IsInterface && typeof(IEnumerable).IsAssignableFrom(type) ? type.GetGenericArguments()[0] : null;
    }
}
