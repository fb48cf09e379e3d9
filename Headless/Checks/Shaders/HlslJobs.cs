using Headless.Checks.Fxc;
using Headless.Shaders;

namespace Headless.Checks.Shaders;

/// <summary>What Microsoft's compilers are given: every entry point of the packages in every choice of keywords, tests' shaders included.</summary>
/// <param name="Files">Files with shaders.</param>
internal sealed record HlslJobs(IReadOnlyList<FxcJob> Jobs, int Files)
{
    /// <param name="problems">Gets a message for each file that cannot be read, and one where there is none.</param>
    public static HlslJobs Read(ProjectPackages packages, List<string> problems)
    {
        var jobs = new List<FxcJob>();
        var includes = new IncludeResolver(packages.Project);
        var files = packages.Files().Where(f => Path.GetExtension(f) is ".compute" or ".shader").ToList();
        foreach (var file in files)
        {
            try
            {
                var made = Path.GetExtension(file) == ".compute"
                    ? FxcJob.FromCompute(ComputeSource.Parse(file, includes))
                    : FxcJob.FromShader(ShaderLabSource.Parse(file, includes));
                jobs.AddRange(made.Select(job => job with { File = file }));
            }
            catch (ShaderCompileException e) { problems.Add(e.Message); }
        }
        if (jobs.Count == 0 && problems.Count == 0) problems.Add($"no shaders below {packages.Folder}");
        return new HlslJobs(jobs, files.Count);
    }

    /// <summary>Writes each text as NUMBER.hlsl, and returns the lines of a job list: number, file, entry point, profile, and a file for its code.</summary>
    /// <param name="code">Whether a job's code is to be written.</param>
    public IReadOnlyList<string> Write(string folder, Func<string, string> profile, Func<FxcJob, bool> code) =>
    [
        .. Jobs.Select((job, i) =>
        {
            File.WriteAllText(Path.Combine(folder, $"{i}.hlsl"), job.Text);
            return $"{i}\t{i}.hlsl\t{job.Entry}\t{profile(job.Profile)}{(code(job) ? $"\t{i}.code" : "")}";
        }),
    ];
}
