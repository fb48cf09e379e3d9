using System.Reflection;
using Headless.Engine;
using Headless.Files;
using Headless.Importers.Project;
using Headless.Player.Output;
using Headless.Shaders;
using NUnit.Framework.Interfaces;
using UnityEngine.TestTools;

namespace Headless.Player.Commands;

/// <summary>
/// Runs the project's NUnit and Unity tests. As in Unity, an assembly for the Editor only holds EditMode tests, any other
/// PlayMode tests. The last line is the sum.
/// </summary>
internal static class TestCommand
{
    private const string TestFramework = "nunit.framework";

    public static int Run(TestOptions options)
    {
        using Direct3DFrontEnd? direct3D = options.Direct3D ? new Direct3DFrontEnd(UserCache.Folder) : null;
        if (direct3D?.Missing is { } missing)
        {
            Console.WriteLine($"skipped: kernels cannot be compiled as for Direct3D, {missing}");
            Console.WriteLine("0 passed, 0 failed, 1 skipped");
            return 0;
        }
        using var output = new TestRunOutput(Console.Out);
        using EngineSession session = EngineSession.Start(
            options.Project, options.Assemblies, options.Device, options.Validate, output.AddConsoleLine, options.Pipeline, direct3D,
            options.Checks);
        AsyncReadbacks.Frames = options.ReadbackFrames;
        if (options.Twice is not null) EngineSession.RequireStaticsThatStay("--twice");
        if (session.PipelineNotice is { } notice) Console.WriteLine(notice);
        Console.WriteLine($"graphics device: {GraphicsDevice.Device.Adapter}{options.Checks}");
        var definitions = new AssemblyDefinitions(session.Project.Index);
        ILookup<bool, Assembly> tests = session.Assemblies.Where(HasTests)
            .ToLookup(a => definitions.All.Any(d => d.Name == a.GetName().Name && d.EditorOnly));
        if (tests.Count == 0) throw new UsageException("--assemblies: none of the script assemblies holds a test.");

        using TestCoverage? coverage = options.Coverage is { } file ? new TestCoverage(file) : null;
        var selection = new TestSelection { Filter = options.Filter, Names = options.Tests, StopOnFail = options.StopOnFail };
        bool succeeded = RunOnce(options, selection, tests, output, coverage, direct3D);
        while (options.Again && Console.In.ReadLine() is { } names)
        {
            session.Project.Assets.ReimportChangedComputeShaders();
            succeeded &= RunOnce(options, selection with { Names = TestOptions.ReadNames(names) }, tests, output, coverage, direct3D);
        }
        return succeeded ? 0 : 1;
    }

    private static bool RunOnce(
        TestOptions options, TestSelection selection, ILookup<bool, Assembly> tests, TestRunOutput output, TestCoverage? coverage,
        Direct3DFrontEnd? direct3D)
    {
        int passed = 0, failed = 0, skipped = 0;
        List<(TestPlatform, TestSelection)> runs = [(TestPlatform.EditMode, selection), (TestPlatform.PlayMode, selection)];
        if (options.Twice is { } again) runs.Add((TestPlatform.PlayMode, selection with { Within = again }));
        foreach ((TestPlatform mode, TestSelection selected) in runs)
        {
            bool edit = mode == TestPlatform.EditMode;
            if (failed > 0 && options.StopOnFail) break;
            if (!(edit ? options.Mode.Edit : options.Mode.Play) || !tests[edit].Any()) continue;
            Console.WriteLine($"{mode}:");
            TestRunResult result = UnityTestRunner.Run([.. tests[edit]], mode, selected, output, coverage is null ? null : coverage.Add);
            passed += result.Passed;
            failed += result.Failed + result.Inconclusive;
            skipped += result.Skipped;
        }
        if (!EngineSession.ReportValidation()) failed++;
        if (direct3D is not null) skipped += ReportCompiler(direct3D);
        Console.WriteLine($"{output.UsedGpu} tests used the GPU ({GraphicsDevice.Device.Adapter.Name})");
        Console.WriteLine($"{passed} passed, {failed} failed, {skipped} skipped");
        return failed == 0 && passed > 0;
    }

    // A kernel that glslang had to make counts as skipped.
    private static int ReportCompiler(Direct3DFrontEnd direct3D)
    {
        foreach ((string kernel, string reason) in direct3D.Untranslated)
            Console.WriteLine($"  skip  {kernel} ran as glslang makes it: {reason}");
        Console.WriteLine($"{ExecutedKernels.ByDirect3D} kernel variants ran as Direct3D's compiler makes them ({direct3D.Version}), "
            + $"{ExecutedKernels.ByOthers} as glslang does; the stages of passes are glslang's");
        return direct3D.Untranslated.Count;
    }

    private static bool HasTests(Assembly assembly) =>
        assembly.GetReferencedAssemblies().Any(r => r.Name == TestFramework)
        && TypeLookup.Types(assembly).SelectMany(t => t.GetMethods()).Any(m => m.GetCustomAttributes(true).Any(a => a is ITestBuilder or ISimpleTestBuilder));
}
