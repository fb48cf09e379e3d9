using Headless.Shaders;
using System.Text.RegularExpressions;

namespace Headless.Checks.Form;

/// <summary>
/// Materials and renderers of the samples and of Assets use shaders of the packages that have a SubShader for each render pipeline:
/// those of the Built-in pipeline are magenta in URP and HDRP. A skybox's SubShader is drawn by Built-in and URP alike, and HDRP draws no skyboxes.
/// </summary>
internal sealed partial class MaterialCheck(ProjectPackages packages)
{
    private static readonly string[] pipelines = ["UniversalPipeline", "HDRenderPipeline", ""];

    public CheckReport Run()
    {
        var report = new CheckReport("materials");
        var shaders = Shaders(report);
        var materials = Files(".mat");
        foreach (var file in materials)
        {
            var guid = ShaderGuid().Match(File.ReadAllText(file)).Groups[1].Value;
            if (!shaders.TryGetValue(guid, out var served))
                report.Findings.Add($"{Shown(file)}: its shader is not one of the packages'");
            else if (pipelines.Except(served).ToList() is { Count: > 0 } missing)
                report.Findings.Add($"{Shown(file)}: its shader has no SubShader for {string.Join(", ", missing.Select(m => m.Length > 0 ? m : "the Built-in pipeline"))}");
        }
        var scenes = Files(".unity").Concat(Files(".prefab")).ToList();
        foreach (var file in scenes)
            foreach (Match list in MaterialList().Matches(File.ReadAllText(file)))
                if (list.Value.Contains("guid: 0000000000000000", StringComparison.Ordinal))
                    report.Findings.Add($"{Shown(file)}: a renderer uses a material of the Built-in pipeline");
        report.Figures = $"{materials.Count} materials and {scenes.Count} scenes and prefabs for Built-in, URP and HDRP";
        return report;
    }

    /// <summary>By GUID: the pipelines that a shader's SubShaders name, "" for any.</summary>
    private Dictionary<string, List<string>> Shaders(CheckReport report)
    {
        var found = new Dictionary<string, List<string>>();
        var includes = new IncludeResolver(packages.Project);
        foreach (var file in packages.Files().Where(f => f.EndsWith(".shader", StringComparison.Ordinal) && File.Exists(f + ".meta")))
        {
            try
            {
                var parts = ShaderLabSource.Parse(file, includes).SubShaders;
                var served = parts.Select(s => Tag(s, "RenderPipeline")).ToList();
                if (served.Contains("") && parts.All(s => Tag(s, "PreviewType") == "Skybox")) served = [.. pipelines];
                found[MetaGuid().Match(File.ReadAllText(file + ".meta")).Groups[1].Value] = served;
            }
            catch (ShaderCompileException e) { report.Findings.Add(e.Message); }
        }
        return found;
    }

    private static string Tag(SubShader part, string name) =>
        part.Tags.FirstOrDefault(t => t.Key.Equals(name, StringComparison.OrdinalIgnoreCase)).Value ?? "";

    private List<string> Files(string extension) => packages.SceneFolders()
        .SelectMany(f => Directory.GetFiles(f, "*" + extension, SearchOption.AllDirectories)).Order().ToList();

    private string Shown(string path) => Path.GetRelativePath(packages.Project, path);

    [GeneratedRegex(@"m_Shader: \{fileID: -?\d+, guid: ([0-9a-f]{32})")] private static partial Regex ShaderGuid();
    [GeneratedRegex(@"^guid: ([0-9a-f]{32})", RegexOptions.Multiline)] private static partial Regex MetaGuid();
    [GeneratedRegex(@"m_Materials:\s*\n(?:\s*- \{[^}]*\}\s*\n)+")] private static partial Regex MaterialList();
}
