using Headless.Checks;
using Headless.Checks.Api;
using Headless.Checks.Form;
using Headless.Checks.Fxc;

const string usage = "usage: sphchecks PROJECT [--stand-in FOLDER] [--cache FOLDER] [--only api|fxc|form|surface]";
string? project = null, standIn = null, only = null;
var cache = Path.Combine(Environment.GetEnvironmentVariable("XDG_CACHE_HOME") is { Length: > 0 } home ? home : Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.UserProfile), ".cache"), "sphfluid");
for (var i = 0; i < args.Length; i++)
{
    if (args[i] == "--stand-in" && i + 1 < args.Length) standIn = args[++i];
    else if (args[i] == "--cache" && i + 1 < args.Length) cache = args[++i];
    else if (args[i] == "--only" && i + 1 < args.Length) only = args[++i];
    else if (!args[i].StartsWith('-') && project is null) project = Path.GetFullPath(args[i]);
    else { Console.Error.WriteLine($"unknown argument '{args[i]}'; {usage}"); return 2; }
}
if (project is null || !Directory.Exists(Path.Combine(project, "Packages"))) { Console.Error.WriteLine($"no Unity project at '{project}'; {usage}"); return 2; }

var package = Path.Combine(project, "Packages", "com.sphfluid");
var reports = new List<CheckReport>();
void Add(string name, Func<IEnumerable<CheckReport>> run)
{
    if (only is not null && only != name) return;
    foreach (var report in run()) { report.Print(); reports.Add(report); }
}

Add("api", () => new ApiCheck(package).Run());
if (standIn is not null) Add("surface", () => [new StandInSurfaceCheck(standIn).Run()]);
Add("fxc", () => [new FxcCheck(project, package, cache).Run()]);
Add("form", () => [new PackageManifestCheck(package).Run(), new MetaFileCheck(project).Run(), new SerializedFieldCheck(package).Run(), new AssemblyProjectCheck(project).Run()]);

var failed = reports.Count(r => !r.Passed && r.SkippedBecause is null);
var skipped = reports.Count(r => r.SkippedBecause is not null);
Console.WriteLine($"{reports.Count - failed - skipped} passed, {failed} failed, {skipped} skipped");
return failed > 0 ? 1 : 0;
