using System.Collections.Concurrent;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System;

namespace Headless.Engine;

/// <summary>The bytes behind arrays whose element type is only known at run time.</summary>
internal static class ArrayBytes
{
    private static readonly ConcurrentDictionary<Type, bool> Blittable = new();

    public static int ElementSize(Array array) => RuntimeHelpers.SizeOf(array.GetType().GetElementType()!.TypeHandle);

    public static Span<byte> Of(Array array, int start, int count)
    {
        int size = ElementSize(array);
        ref byte first = ref MemoryMarshal.GetArrayDataReference(array);
        return MemoryMarshal.CreateSpan(ref Unsafe.Add(ref first, (nint)start * size), checked(count * size));
    }

    public static void RequireBlittable(Array array, string method)
    {
        Type element = array.GetType().GetElementType()!;
        if (!IsBlittable(element))
        {
            throw new ArgumentException(
                $"Array passed to {method} must be blittable.\n{element.Name} holds references.");
        }
    }

    private static bool IsBlittable(Type type) =>
        Blittable.GetOrAdd(type, static t => t.IsPrimitive || t.IsEnum || t.IsPointer || (t.IsValueType && FieldsAreBlittable(t)));

    [System.Diagnostics.CodeAnalysis.UnconditionalSuppressMessage("Trimming", "IL2070", Justification = "Fields of a value type in use are kept.")]
    private static bool FieldsAreBlittable(Type type)
    {
        foreach (FieldInfo field in type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic))
        {
            if (!IsBlittable(field.FieldType))
            {
                return false;
            }
        }

        return true;
    }
}
