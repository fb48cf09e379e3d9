using Headless.Checks;
using Headless.Checks.Api;
using Headless.Checks.Buffers;
using Headless.Checks.Cross;
using Headless.Checks.Documents;
using Headless.Checks.Dxc;
using Headless.Checks.Form;
using Headless.Checks.Format;
using Headless.Checks.Fxc;
using Headless.Checks.Gpu;
using Headless.Checks.Shaders;
using Headless.Checks.Wgsl;

CheckOptions options;
try
{
    options = CheckOptions.Parse(args);
}
catch (UsageException e)
{
    Console.Error.WriteLine($"check: {e.Message}");
    return 2;
}
string project = options.Project, cache = options.Cache, shaderCache = options.ShaderCache;
var packages = new ProjectPackages(project);
if (options.Family is { } family) return FamilyCompiler.Run(GpuFamily.All.First(f => f.Name == family), packages, shaderCache);
var reports = new List<CheckReport>();
void Add(string name, Func<IEnumerable<CheckReport>> run)
{
    if (options.Only is not null && options.Only != name) return;
    foreach (var report in run()) { report.Print(); reports.Add(report); }
}

Add("api", () => new ApiCheck(packages).Run());
if (options.StandIn is { } standIn) Add("surface", () => [new StandInSurfaceCheck(standIn).Run()]);
Add("fxc", () => [new FxcCheck(packages, cache).Run()]);
Add("dxc", () => [new DxcCheck(packages, cache).Run()]);
Add("cross", () => new CrossCheck(packages, shaderCache).Run());
Add("wgsl", () => [new WgslCheck(packages, shaderCache, cache).Run()]);
Add("gpu", () => new GpuCheck(packages, shaderCache, Path.Combine(project, "Headless", "Checks", "Gpu", "Data")).Run(options.Update));
Add("buffers", () => [new BufferCheck(packages, shaderCache, Path.Combine(project, "Headless", "Checks", "Buffers", "Data")).Run(options.Update)]);
Add("uniform", () => [new UniformBranchCheck(packages, shaderCache).Run()]);
Add("form", () => FormChecks.Run(packages));
Add("docs", () => DocumentChecks.Run(packages, options.StandIn ?? AppContext.BaseDirectory, options.Update));
Add("format", () => [new CodeFormatCheck(project).Run(), new CodeStyleCheck(packages).Run(), new TextFormatCheck(project).Run()]);

var failed = reports.Count(r => !r.Passed && r.SkippedBecause is null);
var skipped = reports.Count(r => r.SkippedBecause is not null);
Console.WriteLine($"{reports.Count - failed - skipped} passed, {failed} failed, {skipped} skipped");
return failed > 0 ? 1 : 0;
