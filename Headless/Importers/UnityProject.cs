using System.Reflection;
using Headless.Engine;
using Headless.Files;
using Headless.Importers.Assets;
using Headless.Importers.Project;
using Headless.Importers.Scenes;
using Headless.Shaders;

namespace Headless.Importers;

/// <summary>A Unity project folder opened for the engine: assets, scenes and settings are found from here on.</summary>
public sealed class UnityProject
{
    private UnityProject(ProjectIndex index, ProjectAssets assets)
    {
        Index = index;
        Assets = assets;
    }

    public ProjectIndex Index { get; }
    public ProjectAssets Assets { get; }

    /// <param name="scripts">Finds a script assembly by name, without extension.</param>
    /// <param name="report">Takes lines about what is wrong with the project's files.</param>
    public static UnityProject Open(string root, Func<string, Assembly?> scripts, IncludeResolver includes, Action<string> report)
    {
        var index = new ProjectIndex(root);
        var assets = new ProjectAssets(index, scripts, includes, report);
        var database = new ProjectDatabase(assets);
        EngineState.ProjectPath = index.Root;
        ProjectSettingsReader.Apply(index.Root, report);
        EngineHooks.Assets = database;
        EngineHooks.LoadScene = new SceneLoader(assets).Load;
        EngineHooks.SaveScene = (scene, path) => SceneWriter.Save(assets, scene, path);
        EngineHooks.ScenesInBuild = () => ProjectSettingsReader.ScenesInBuild(index.Root);
        EngineHooks.LoadResource = database.LoadResource;
        EngineHooks.LoadAllResources = (path, type) => [.. database.LoadAllResources(path, type, exact: false)];
        ShaderLibrary.Resolver = assets.FindShader;
        PipelineSettings.Apply(index.Root, assets);
        foreach (string name in index.MissingPackages)
            report($"Packages/manifest.json asks for the package '{OneLine.Value(name)}', which is neither in Packages nor in Library/PackageCache; its assets and scripts are missing. Copy its folder to Packages/{OneLine.Value(name)}, or open the project once in the Editor.");
        if (index.MissingMetas is [var first, ..])
            report($"{index.MissingMetas.Count} asset(s) have no .meta file, so nothing can refer to them (first: '{first}'). Open the project in the Editor once, so that they get one.");
        return new UnityProject(index, assets);
    }
}
