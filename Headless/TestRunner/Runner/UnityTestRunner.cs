using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;
using NUnit.Framework.Api;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using UnityEngine.TestTools;

namespace Headless.Engine;

/// <summary>Runs NUnit and Unity tests on the calling thread, frame by frame.</summary>
static class UnityTestRunner
{
    static readonly Dictionary<Assembly, Test> s_Suites = new();

    /// <summary>EditMode: Application.isPlaying false, isEditor true. PlayMode: inside a play session with an empty scene.</summary>
    /// <param name="filter">See <see cref="TestFilter"/>; empty for everything.</param>
    /// <param name="output">A line a test; null for standard output.</param>
    public static TestRunResult Run(IReadOnlyList<Assembly> assemblies, TestPlatform mode, string? filter = null, TextWriter? output = null) =>
        Run(assemblies, mode, new TestSelection { Filter = filter ?? "" }, output);

    /// <inheritdoc cref="Run(IReadOnlyList{Assembly}, TestPlatform, string?, TextWriter?)"/>
    /// <param name="finished">Called after each test.</param>
    public static TestRunResult Run(
        IReadOnlyList<Assembly> assemblies, TestPlatform mode, TestSelection selection, TextWriter? output = null,
        Action<TestOutcome>? finished = null)
    {
        output ??= Console.Out;
        var outcomes = new List<TestOutcome>();
        var clock = Stopwatch.StartNew();
        TestExecutionContext? outer = TestExecutionContext.CurrentContext;
        bool wasEditor = EngineState.IsEditor;
        Enter(mode, assemblies);
        try
        {
            bool failed = false;
            void Report(TestOutcome outcome)
            {
                outcomes.Add(outcome);
                failed |= outcome.Status == TestStatus.Failed;
                Print(output, outcome);
                finished?.Invoke(outcome);
            }
            // An assembly of base classes alone has none.
            Test[] suites = [.. assemblies.Select(Suite).Where(s => s.HasChildren)];
            foreach (TestFilter filter in selection.Filters())
            {
                var runner = new SuiteRunner(filter, Report, () => failed && selection.StopOnFail);
                foreach (Test suite in suites) runner.Run(suite, null);
            }
        }
        finally
        {
            Leave(mode);
            EngineState.IsEditor = wasEditor;
            outer?.EstablishExecutionEnvironment();
        }
        return new TestRunResult(outcomes, clock.Elapsed.TotalSeconds);
    }

    // Kept, as a player may run the tests of an assembly many times.
    static Test Suite(Assembly assembly)
    {
        if (!s_Suites.TryGetValue(assembly, out Test? suite))
            s_Suites.Add(assembly, suite = (Test)new DefaultTestAssemblyBuilder().Build(assembly, new Dictionary<string, object>()));
        return suite;
    }

    static void Enter(TestPlatform mode, IReadOnlyList<Assembly> assemblies)
    {
        if (mode == TestPlatform.PlayMode)
        {
            EngineState.IsEditor = false;
            Assembly[] scripts = [.. EngineState.ScriptAssemblies];
            PlaySession.Begin(null, scripts.Length > 0 ? scripts : [.. assemblies]);
            return;
        }
        EngineState.IsPlaying = false;
        EngineState.IsEditor = true;
        SceneTable.ActiveOrCreate();
    }

    static void Leave(TestPlatform mode)
    {
        PlaySession.End();
        if (mode == TestPlatform.EditMode) SceneTable.DestroyAll();
    }

    static void Print(TextWriter output, TestOutcome outcome)
    {
        string word = outcome.Status switch
        {
            TestStatus.Passed => "pass",
            TestStatus.Failed => "FAIL",
            TestStatus.Skipped => "skip",
            _ => "none",
        };
        output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"  {word}  {outcome.FullName} ({outcome.Seconds * 1000.0:0} ms)"));
        if (outcome.Output.Length > 0) output.WriteLine(Indent(outcome.Output));
        if (outcome.Status == TestStatus.Passed) return;
        if (outcome.Message.Length > 0) output.WriteLine(Indent(outcome.Message));
        if (outcome.Status == TestStatus.Failed && outcome.StackTrace.Length > 0) output.WriteLine(Indent(outcome.StackTrace));
        output.Flush();
    }

    static string Indent(string text) => "        " + text.TrimEnd().Replace("\n", "\n        ");
}
