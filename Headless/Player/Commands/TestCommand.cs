using System.Reflection;
using Headless.Engine;
using Headless.Importers.Project;
using Headless.Player.Output;
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
        using var output = new TestRunOutput(Console.Out);
        using EngineSession session = EngineSession.Start(options.Project, options.Assemblies, options.Device, options.Validate, output.AddConsoleLine);
        Console.WriteLine($"graphics device: {GraphicsDevice.Device.Adapter}");
        var definitions = new AssemblyDefinitions(session.Project.Index);
        ILookup<bool, Assembly> tests = session.Assemblies.Where(HasTests)
            .ToLookup(a => definitions.All.Any(d => d.Name == a.GetName().Name && d.EditorOnly));
        if (tests.Count == 0) throw new UsageException("--assemblies: none of the script assemblies holds a test.");

        int passed = 0, failed = 0, skipped = 0;
        foreach (TestPlatform mode in new[] { TestPlatform.EditMode, TestPlatform.PlayMode })
        {
            bool edit = mode == TestPlatform.EditMode;
            if (!(edit ? options.Mode.Edit : options.Mode.Play) || !tests[edit].Any()) continue;
            Console.WriteLine($"{mode}:");
            TestRunResult result = UnityTestRunner.Run([.. tests[edit]], mode, options.Filter, output);
            passed += result.Passed;
            failed += result.Failed + result.Inconclusive;
            skipped += result.Skipped;
        }
        if (!EngineSession.ReportValidation()) failed++;
        Console.WriteLine($"{output.UsedGpu} tests used the GPU ({GraphicsDevice.Device.Adapter.Name})");
        Console.WriteLine($"{passed} passed, {failed} failed, {skipped} skipped");
        return failed == 0 && passed > 0 ? 0 : 1;
    }

    private static bool HasTests(Assembly assembly) =>
        assembly.GetReferencedAssemblies().Any(r => r.Name == TestFramework)
        && TypeLookup.Types(assembly).SelectMany(t => t.GetMethods()).Any(m => m.GetCustomAttributes(true).Any(a => a is ITestBuilder or ISimpleTestBuilder));
}
