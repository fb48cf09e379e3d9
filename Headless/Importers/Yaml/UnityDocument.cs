namespace Headless.Importers.Yaml;

/// <summary>One object of a Unity text file: <c>--- !u!ClassId &amp;FileId [stripped]</c>, the class name, its fields.</summary>
public sealed record UnityDocument(int ClassId, long FileId, bool Stripped, string ClassName, YamlMap Body, int Line);
