using System.Reflection;
using Headless.Engine;
using Headless.Files;
using Headless.Importers.Assets;
using Headless.Importers.Project;
using Headless.Importers.Scenes;
using Headless.Importers.Yaml;
using Headless.Player.Scripts;
using Headless.Shaders;
using UnityEngine;

namespace Headless.Tests.Fuzz;

/// <summary>A copy of this repository's own assets in a temporary project, one file of which may be broken at a time.</summary>
internal sealed class FuzzProject : IDisposable
{
    private static readonly string[] Extensions =
        [".unity", ".prefab", ".asset", ".mat", ".obj", ".compute", ".shader", ".meta", ".hlsl", ".cs", ".asmdef", ".json"];

    private readonly ScriptAssemblies scripts;
    private readonly ProjectIndex index;
    private readonly IncludeResolver includes;

    public FuzzProject()
    {
        Root = Directory.CreateTempSubdirectory("fuzz-").FullName;
        string repository = Repository;
        Copy(Path.Combine(repository, "Packages/com.sphfluid/Runtime"), "Packages/com.sphfluid/Runtime");
        Copy(Path.Combine(repository, "Packages/com.sphfluid/Shaders"), "Packages/com.sphfluid/Shaders");
        File.Copy(Path.Combine(repository, "Packages/com.sphfluid/package.json"), Path.Combine(Root, "Packages/com.sphfluid/package.json"));
        foreach (string sample in Directory.GetDirectories(Path.Combine(repository, "Packages/com.sphfluid/Samples~")))
        {
            // Two samples share no GUID, so all of them are assets of one project.
            Copy(sample, "Assets/" + Path.GetFileName(sample));
        }
        Copy(Path.Combine(repository, "Headless/Tests/Projects/Ripples/Assets"), "Assets/Ripples");
        Copy(Path.Combine(repository, "Assets/Settings"), "Assets/Settings");
        Copy(Path.Combine(repository, "ProjectSettings"), "ProjectSettings");
        scripts = new ScriptAssemblies(Path.Combine(repository, "Build/ScriptAssemblies"));
        includes = new IncludeResolver(Root);
        index = new ProjectIndex(Root);
        Files = [.. Directory.EnumerateFiles(Root, "*", SearchOption.AllDirectories)
            .Where(f => Path.GetExtension(f) is ".unity" or ".prefab" or ".asset" or ".mat" or ".obj" or ".compute" or ".shader" || IsMetaOfAsset(f))
            .Order(StringComparer.Ordinal)];
    }

    public static string Repository
    {
        get
        {
            for (DirectoryInfo? folder = new(AppContext.BaseDirectory); folder is not null; folder = folder.Parent)
                if (File.Exists(Path.Combine(folder.FullName, "Packages/com.sphfluid/package.json"))) return folder.FullName;
            throw new DirectoryNotFoundException($"Packages/com.sphfluid is not above {AppContext.BaseDirectory}.");
        }
    }

    public string Root { get; }

    /// <summary>What can be broken.</summary>
    public IReadOnlyList<string> Files { get; }

    /// <summary>Imports the file as the player does; the lines that it reports.</summary>
    /// <param name="compile">Also compiles one kernel or pass of a shader.</param>
    public IReadOnlyList<string> Import(string file, bool compile)
    {
        var reports = new List<string>();
        string path = Path.GetRelativePath(Root, file).Replace('\\', '/');
        bool isMeta = path.EndsWith(".meta", StringComparison.Ordinal);
        EngineState.Reset();
        ShaderLibrary.Resolver = null;
        // Settings and metas are read when a project is opened.
        bool anew = isMeta || path.StartsWith("ProjectSettings/", StringComparison.Ordinal);
        if (anew) ProjectSettingsReader.Apply(Root, reports.Add);
        var assets = new ProjectAssets(anew ? new ProjectIndex(Root) : index, scripts.Find, includes, reports.Add);
        ShaderLibrary.Resolver = assets.FindShader;
        string asset = isMeta ? path[..^5] : path;
        if (asset.EndsWith(".unity", StringComparison.Ordinal))
        {
            new SceneLoader(assets).Load(asset, SceneTable.Create("Fuzz", asset, loaded: false));
        }
        else if (asset.StartsWith("ProjectSettings/", StringComparison.Ordinal))
        {
            ProjectSettingsReader.ScenesInBuild(Root);
            PipelineSettings.Apply(Root, assets);
        }
        else if (assets.Index.GuidOf(asset) is not null)
        {
            foreach (UnityEngine.Object loaded in assets.LoadAll(asset))
                if (compile) Compile(loaded);
        }
        EngineState.Reset();
        return reports;
    }

    public void Dispose()
    {
        EngineState.Reset();
        Directory.Delete(Root, recursive: true);
    }

    private static void Compile(UnityEngine.Object loaded)
    {
        ShaderCompiler compiler = GraphicsDevice.Compiler;
        switch (loaded)
        {
            case ComputeShader compute:
                ComputeSource source = compute.Program.Source;
                compiler.CompileKernel(source, source.Kernels[0].Name, [.. source.KeywordSets.Select(s => s.Keywords[0])]);
                break;
        }
    }

    private static bool IsMetaOfAsset(string file) =>
        file.EndsWith(".meta", StringComparison.Ordinal) && Path.GetExtension(file[..^5]) is ".unity" or ".prefab" or ".asset" or ".mat" or ".obj" or ".compute" or ".shader";

    private void Copy(string from, string to)
    {
        foreach (string file in Directory.EnumerateFiles(from, "*", SearchOption.AllDirectories))
        {
            if (!Extensions.Contains(Path.GetExtension(file))) continue;
            string target = Path.Combine(Root, to, Path.GetRelativePath(from, file));
            Directory.CreateDirectory(Path.GetDirectoryName(target)!);
            File.Copy(file, target);
        }
    }
}
