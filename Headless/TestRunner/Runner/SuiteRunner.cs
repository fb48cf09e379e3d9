using System.Collections.Generic;
using System.Reflection;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace Headless.Engine;

/// <summary>Walks the tree that NUnit builds and runs what the filter lets through.</summary>
sealed class SuiteRunner(TestFilter filter, Action<TestOutcome> report, Func<bool>? stops = null)
{
    readonly TestCaseRunner m_Cases = new();

    public void Run(Test test, object? fixture)
    {
        if (stops?.Invoke() == true || !filter.Selects(test)) return;
        if (Reason(test) is { } reason)
        {
            Refuse(test, reason, test.RunState == RunState.NotRunnable ? TestStatus.Failed : TestStatus.Skipped);
            return;
        }
        if (test is TestMethod method)
        {
            report(TestOutcome.From(method, m_Cases.Run(method, fixture)));
            return;
        }
        RunSuite((TestSuite)test, fixture);
    }

    void RunSuite(TestSuite suite, object? fixture)
    {
        Type? type = suite.TypeInfo?.Type;
        if (type is null || suite is ParameterizedMethodSuite)
        {
            foreach (ITest child in suite.Tests) Run((Test)child, fixture);
            return;
        }
        FixtureMethods methods = FixtureMethods.Of(type);
        object? instance = null;
        var context = new TestExecutionContext { CurrentTest = suite, CurrentResult = suite.MakeTestResult() };
        context.EstablishExecutionEnvironment();
        try
        {
            if (suite is TestFixture or SetUpFixture && !suite.TypeInfo!.IsStaticClass) instance = suite.TypeInfo.Construct(suite.Arguments);
            suite.Fixture = instance;
            context.TestObject = instance;
            foreach (MethodInfo method in methods.OneTimeSetUp) FixtureMethods.Call(method, instance);
        }
        catch (Exception exception)
        {
            bool skip = exception is IgnoreException or InconclusiveException;
            Refuse(suite, (skip ? "" : "OneTimeSetUp: ") + $"{exception.GetType().Name}: {exception.Message}", skip ? TestStatus.Skipped : TestStatus.Failed);
            CleanUp(suite, methods, instance);
            return;
        }
        foreach (ITest child in suite.Tests) Run((Test)child, instance);
        CleanUp(suite, methods, instance);
    }

    void CleanUp(TestSuite suite, FixtureMethods methods, object? instance)
    {
        foreach (MethodInfo method in methods.OneTimeTearDown)
        {
            try
            {
                FixtureMethods.Call(method, instance);
            }
            catch (Exception exception)
            {
                report(new TestOutcome($"{suite.FullName}.{method.Name}", TestStatus.Failed, $"OneTimeTearDown: {exception.GetType().Name}: {exception.Message}", exception.StackTrace ?? "", "", 0.0));
            }
        }
        (instance as IDisposable)?.Dispose();
    }

    static string? Reason(Test test) => test.RunState switch
    {
        RunState.Runnable or RunState.Explicit => null,
        _ => test.Properties.Get(PropertyNames.SkipReason) as string ?? test.RunState.ToString(),
    };

    void Refuse(Test test, string reason, TestStatus status)
    {
        if (!filter.Selects(test)) return;
        if (test is TestMethod || !test.HasChildren)
        {
            report(new TestOutcome(test.FullName, status, reason, "", "", 0.0));
            return;
        }
        foreach (ITest child in ((TestSuite)test).Tests) Refuse((Test)child, reason, status);
    }
}
