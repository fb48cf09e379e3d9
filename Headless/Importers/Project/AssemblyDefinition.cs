namespace Headless.Importers.Project;

public sealed record AssemblyDefinition(string Name, string Path, bool EditorOnly);
