namespace Headless.Engine;

internal readonly record struct BufferEntry(int NameId, string Name, int Binding);
