using System.Globalization;
using Headless.Engine;
using Headless.Shaders;
using Headless.Vulkan;
using NUnit.Framework;

namespace Headless.Tests.Fuzz;

/// <summary>
/// Files of this repository, broken at random: each is imported or refused in one line, in time, in bounds.
/// SPHFLUID_FUZZ=5000 breaks so many; SPHFLUID_FUZZ_SEED=7 starts elsewhere.
/// </summary>
[NonParallelizable]
[Category("Gpu")]
public sealed class FuzzTests
{
    private const int UsualCount = 60;
    private const int CompileEvery = 8;

    private FuzzProject project = null!;
    private string cache = "";
    private Action<UnityEngine.LogType, string>? console;

    [OneTimeSetUp]
    public void Open()
    {
        project = new FuzzProject();
        cache = Directory.CreateTempSubdirectory("fuzz-shaders-").FullName;
        GraphicsDevice.Initialize(new GpuDeviceOptions(), new ShaderCompiler(cache, new IncludeResolver(project.Root)));
        console = EngineHooks.Console;
        EngineHooks.Console = (_, _) => { };
    }

    [OneTimeTearDown]
    public void Close()
    {
        EngineHooks.Console = console;
        GraphicsDevice.Shutdown();
        project.Dispose();
        Directory.Delete(cache, recursive: true);
    }

    [Test]
    [Order(0)]
    public void TheFilesThemselvesAreImported()
    {
        Assert.Multiple(() =>
        {
            // The index of the project reads every meta file.
            foreach (string file in project.Files.Where(f => !f.EndsWith(".meta", StringComparison.Ordinal)))
                Assert.That(() => project.Import(file, compile: false), Throws.Nothing, file);
        });
    }

    [Test]
    [Order(1)]
    public void BrokenFilesAreImportedOrRefusedInOneLine()
    {
        int count = Setting("SPHFLUID_FUZZ", UsualCount), seed = Setting("SPHFLUID_FUZZ_SEED", 20_261_122), refused = 0;
        double slowest = 0;
        long largest = 0;
        var failures = new List<string>();
        for (int i = 0; i < count; i++)
        {
            var random = new Random(unchecked(seed * 31 + i));
            string file = project.Files[random.Next(project.Files.Count)];
            byte[] original = File.ReadAllBytes(file);
            File.WriteAllBytes(file, new FileMutator(random).Mutate(original, out string kind));
            GuardedRun.Result result;
            try
            {
                result = GuardedRun.Of(() => project.Import(file, compile: random.Next(CompileEvery) == 0));
            }
            finally
            {
                File.WriteAllBytes(file, original);
            }
            if (result.Refusal is not null) refused++;
            slowest = Math.Max(slowest, result.Seconds);
            largest = Math.Max(largest, result.Bytes);
            if (result.Problem is not null) failures.Add($"number {i}, {kind}, {Path.GetRelativePath(project.Root, file)}: {result.Problem}");
        }
        TestContext.Out.WriteLine(string.Create(CultureInfo.InvariantCulture,
            $"{count} broken files of {project.Files.Count}: {refused} refused, {failures.Count} failed; slowest {slowest:0.00} s of processor time, largest {largest >> 20} MiB allocated"));
        Assert.That(failures, Is.Empty);
    }

    private static int Setting(string name, int absent) =>
        int.TryParse(Environment.GetEnvironmentVariable(name), NumberStyles.Integer, CultureInfo.InvariantCulture, out int value) ? value : absent;
}
