using System.Reflection;

namespace Headless.Importers.Serialization;

/// <summary>One field that Unity stores, with the names it may have in a file: its own first, then those of [FormerlySerializedAs].</summary>
public sealed record SerializedField(FieldInfo Field, IReadOnlyList<string> Names, bool ByReference);
