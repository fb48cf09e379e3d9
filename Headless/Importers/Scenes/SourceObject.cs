using Headless.Importers.Yaml;

namespace Headless.Importers.Scenes;

/// <summary>An object as the files describe it, prefab overrides applied, before it becomes a <see cref="UnityEngine.Object"/>.</summary>
public sealed class SourceObject(int classId, string className, long fileId, YamlMap body, SourceScope scope, int line = 0)
{
    public int ClassId { get; } = classId;
    public string ClassName { get; } = className;
    public long FileId { get; } = fileId;
    public YamlMap Body { get; } = body;

    /// <summary>Where a reference without a GUID in <see cref="Body"/> is looked up.</summary>
    public SourceScope Scope { get; } = scope;

    /// <summary>Line of its header in the file that it comes from; 0 for objects made here.</summary>
    public int Line { get; } = line;

    public UnityEngine.Object? Instance { get; set; }

    public string Name => Body.Text("m_Name");

    public override string ToString() => $"{Scope.AssetPath}: {ClassName} {FileId}";
}
