using System.Text.RegularExpressions;

namespace Headless.Checks.Form;

/// <summary>Shaders name graphics APIs only to leave OpenGL out: a list of all the others is never complete, and what it
/// forgets (a new console, WebGPU) silently gets the wrong depth.</summary>
internal sealed partial class ShaderApiCheck(ProjectPackages packages)
{
    private static readonly string[] extensions = [".hlsl", ".cginc", ".compute", ".shader"];
    private static readonly string[] exceptions = ["GLCORE", "GLES", "GLES3"];

    // Arrays as long as Unity's pipeline makes them, which lists platforms by name.
    private static readonly string[] sizedByPipeline = ["UniversalLights.hlsl"];

    public CheckReport Run()
    {
        var report = new CheckReport("graphics APIs in shaders");
        var (files, tests) = (0, 0);
        foreach (var file in packages.Files().Where(f => extensions.Contains(Path.GetExtension(f)) && !sizedByPipeline.Contains(Path.GetFileName(f))))
        {
            files++;
            foreach (var (line, number) in JoinedLines(file))
            {
                if (!Condition().IsMatch(line)) continue;
                foreach (Match api in Api().Matches(line))
                {
                    tests++;
                    if (!exceptions.Contains(api.Groups[1].Value))
                        report.Findings.Add($"{Path.GetFileName(file)}({number}): SHADER_API_{api.Groups[1].Value} is listed by name; leave out {string.Join(", ", exceptions)} instead");
                }
            }
        }
        report.Figures = $"{tests} names in conditions of {files} shader files, OpenGL's only";
        return report;
    }

    // Lines that end in a backslash go on in the next.
    private static IEnumerable<(string Line, int Number)> JoinedLines(string file)
    {
        var lines = File.ReadAllLines(file);
        for (var i = 0; i < lines.Length; i++)
        {
            var (line, number) = (lines[i], i + 1);
            while (line.EndsWith('\\') && i + 1 < lines.Length) line = line[..^1] + lines[++i];
            yield return (line, number);
        }
    }

    [GeneratedRegex(@"^\s*#\s*(if|ifdef|ifndef|elif|define)\b")] private static partial Regex Condition();

    [GeneratedRegex(@"\bSHADER_API_(\w+)")] private static partial Regex Api();
}
