using Headless.Engine;
using Headless.Importers.Assets;
using Headless.Importers.Yaml;

namespace Headless.Importers.Scenes;

/// <summary>Fills a scene from its .unity file. Objects exist and have their fields before any of them wakes.</summary>
internal sealed class SceneLoader(ProjectAssets project)
{
    /// <param name="name">Asset path with or without .unity, or a scene's name.</param>
    /// <returns>False when the project has no such scene.</returns>
    public bool Load(string name, SceneData scene)
    {
        if (FindPath(name) is not { } path) return false;
        project.Index.MountSample(path);
        scene.Path = path;
        scene.Name = Path.GetFileNameWithoutExtension(path);
        SourceFile file = project.Expander.Expand(path, UnityYaml.ReadDocuments(project.Index.FileOf(path)));
        var builder = new ObjectBuilder(project);
        builder.CreateHierarchy(file, scene);
        builder.FillAll(file);
        foreach (SourceObject settings in file.Objects.Where(o => o.ClassId == ClassIds.RenderSettings)) SceneSettings.Apply(builder.Fields(settings));
        return true;
    }

    private string? FindPath(string name)
    {
        string withExtension = name.EndsWith(".unity", StringComparison.Ordinal) ? name : name + ".unity";
        if (project.Index.AssetPathOf(withExtension) is { } path && File.Exists(project.Index.FileOf(path))) return path;
        return project.Index.AssetPaths.FirstOrDefault(p => p.EndsWith("/" + withExtension, StringComparison.Ordinal));
    }
}
