using Headless.Shaders;

namespace Headless.Engine;

/// <summary>Holds what a shader declares against the view that the bound buffer has on Direct3D 11, where a mismatch is undefined.</summary>
internal static class BufferViewCheck
{
    /// <summary>What does not fit and how to mend it; null where the buffer fits.</summary>
    public static string? Mismatch(in BufferEntry entry, DeviceBuffer buffer)
    {
        if (entry.IsCounter)
        {
            return buffer.Counter is null ? $"'{entry.Name}' is counted, but buffer '{buffer.Name}' was created as {buffer.Targets.Flags}: create it as Append or Counter" : null;
        }

        BufferView view = buffer.Targets.View;
        bool fits = entry.Kind switch
        {
            ResourceKind.StructuredBuffer or ResourceKind.RWStructuredBuffer => view == BufferView.Structured && entry.Stride == buffer.Stride,
            ResourceKind.ByteAddressBuffer => view is BufferView.Raw or BufferView.Arguments,
            _ => view == BufferView.Raw,
        };
        return fits ? null : Describe(entry, buffer, view);
    }

    /// <summary>Why an indirect dispatch or draw cannot read the buffer; null where it can.</summary>
    public static string? NotArguments(DeviceBuffer buffer) => buffer.Targets.Arguments
        ? null
        : $"buffer '{buffer.Name}' was created as {buffer.Targets.Flags}, so it cannot hold indirect arguments: add IndirectArguments";

    private static string Describe(in BufferEntry entry, DeviceBuffer buffer, BufferView view)
    {
        bool structured = entry.Kind is ResourceKind.StructuredBuffer or ResourceKind.RWStructuredBuffer;
        string declared = structured ? $"a {entry.Kind} of {entry.Stride} bytes an element" : $"a {entry.Kind}";
        string actual = view switch
        {
            BufferView.Structured => $"a structured buffer of {buffer.Stride} bytes an element",
            BufferView.Raw => "a byte address buffer",
            BufferView.Arguments => "RWBuffer<uint> to write and ByteAddressBuffer to read",
            _ => "none that a shader reaches",
        };
        return $"'{entry.Name}' is declared as {declared}, but buffer '{buffer.Name}' was created as {buffer.Targets.Flags}, "
            + $"whose view on Direct3D 11 is {actual}: {Cure(structured, entry, buffer, view)}";
    }

    private static string Cure(bool structured, in BufferEntry entry, DeviceBuffer buffer, BufferView view) => (structured, view) switch
    {
        (true, BufferView.Structured) => $"make both strides equal ({entry.Stride} in the shader, {buffer.Stride} in the buffer)",
        (true, BufferView.Raw) => $"declare {(entry.Kind == ResourceKind.StructuredBuffer ? "ByteAddressBuffer" : "RWByteAddressBuffer")}",
        (true, BufferView.Arguments) =>
            $"create it with IndirectArguments | Raw and declare {(entry.Kind == ResourceKind.StructuredBuffer ? "ByteAddressBuffer" : "RWByteAddressBuffer")}",
        (true, _) => "create it as Structured, or, where it holds vertices or indices, add Raw and declare (RW)ByteAddressBuffer",
        (false, BufferView.Structured) => "create it as Raw instead, or declare (RW)StructuredBuffer",
        _ => "add Raw to what it is created as",
    };
}
