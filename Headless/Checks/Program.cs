using Headless.Checks;
using Headless.Checks.Api;
using Headless.Checks.Cross;
using Headless.Checks.Documents;
using Headless.Checks.Dxc;
using Headless.Checks.Form;
using Headless.Checks.Format;
using Headless.Checks.Fxc;
using Headless.Checks.Gpu;
using Headless.Checks.Shaders;

string[] names = ["api", "surface", "fxc", "dxc", "cross", "gpu", "uniform", "form", "docs", "format"];
var usage = $"usage: sphchecks PROJECT [--stand-in FOLDER] [--cache FOLDER] [--only {string.Join('|', names)}] [--update]";
string? project = null, standIn = null, only = null, family = null, shaderCache = null;
var update = false;
var cache = Path.Combine(Environment.GetEnvironmentVariable("XDG_CACHE_HOME") is { Length: > 0 } home ? home : Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.UserProfile), ".cache"), "sphfluid");
for (var i = 0; i < args.Length; i++)
{
    if (args[i] == "--stand-in" && i + 1 < args.Length) standIn = args[++i];
    else if (args[i] == "--cache" && i + 1 < args.Length) cache = args[++i];
    else if (args[i] == "--only" && i + 1 < args.Length) only = args[++i];
    else if (args[i] == "--update") update = true;
    // The child process of the GPU check.
    else if (args[i] == "--compile-for" && i + 1 < args.Length) family = args[++i];
    else if (args[i] == "--shader-cache" && i + 1 < args.Length) shaderCache = args[++i];
    else if (!args[i].StartsWith('-') && project is null) project = Path.GetFullPath(args[i]);
    else { Console.Error.WriteLine($"unknown argument '{args[i]}'; {usage}"); return 2; }
}
if (project is null || !Directory.Exists(Path.Combine(project, "Packages"))) { Console.Error.WriteLine($"no Unity project at '{project}'; {usage}"); return 2; }

var packages = new ProjectPackages(project);
shaderCache ??= Path.Combine(cache, "shaders");
if (family is not null) return FamilyCompiler.Run(GpuFamily.All.First(f => f.Name == family), packages, shaderCache);
if (only is not null && !names.Contains(only)) { Console.Error.WriteLine($"--only: no check '{only}'; {usage}"); return 2; }
if (update && only != "gpu") { Console.Error.WriteLine($"--update writes the GPU tables: --only gpu --update; {usage}"); return 2; }
var reports = new List<CheckReport>();
void Add(string name, Func<IEnumerable<CheckReport>> run)
{
    if (only is not null && only != name) return;
    foreach (var report in run()) { report.Print(); reports.Add(report); }
}

Add("api", () => new ApiCheck(packages).Run());
if (standIn is not null) Add("surface", () => [new StandInSurfaceCheck(standIn).Run()]);
Add("fxc", () => [new FxcCheck(packages, cache).Run()]);
Add("dxc", () => [new DxcCheck(packages, cache).Run()]);
Add("cross", () => new CrossCheck(packages, shaderCache).Run());
Add("gpu", () => new GpuCheck(packages, shaderCache, Path.Combine(project, "Headless", "Checks", "Gpu", "Data")).Run(update));
Add("uniform", () => [new UniformBranchCheck(packages, shaderCache).Run()]);
Add("form", () => FormChecks.Run(packages));
Add("docs", () => DocumentChecks.Run(packages));
Add("format", () => [new CodeFormatCheck(project).Run(), new TextFormatCheck(project).Run()]);

var failed = reports.Count(r => !r.Passed && r.SkippedBecause is null);
var skipped = reports.Count(r => r.SkippedBecause is not null);
Console.WriteLine($"{reports.Count - failed - skipped} passed, {failed} failed, {skipped} skipped");
return failed > 0 ? 1 : 0;
