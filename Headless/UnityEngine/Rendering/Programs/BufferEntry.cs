using Headless.Shaders;

namespace Headless.Engine;

/// <summary>A buffer as a stage declares it.</summary>
/// <param name="Stride">Bytes of an element of a structured buffer.</param>
internal readonly record struct BufferEntry(int NameId, string Name, int Binding, ResourceKind Kind, int Stride);
