using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Reflection;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Commands;
using UnityEngine.TestTools;

namespace Headless.Engine;

/// <summary>One test, in the order that Unity's test framework documents: outer actions, UnitySetUp, SetUp, actions, body, and back.</summary>
sealed class TestCaseRunner
{
    // Unity's own limit for a test that does not set one.
    const double DefaultTimeoutSeconds = 180.0;

    public TestResult Run(TestMethod test, object? fixture)
    {
        TestResult result = test.MakeTestResult();
        var clock = Stopwatch.StartNew();
        result.StartTime = DateTime.UtcNow;
        var context = new TestExecutionContext { CurrentTest = test, CurrentResult = result, TestObject = fixture };
        context.EstablishExecutionEnvironment();
        foreach (IApplyToContext attribute in Attributes<IApplyToContext>(test)) attribute.ApplyToContext(context);
        using (var log = new LogScope { MustExpectAll = MustExpectAll(test) }) Run(test, fixture, context, log);
        result = context.CurrentResult;
        result.EndTime = DateTime.UtcNow;
        result.Duration = clock.Elapsed.TotalSeconds;
        return result;
    }

    static void Run(TestMethod test, object? fixture, TestExecutionContext context, LogScope log)
    {
        Type type = test.TypeInfo!.Type;
        FixtureMethods methods = FixtureMethods.Of(type);
        object? limit = test.Properties.Get(PropertyNames.Timeout);
        var driver = new FrameDriver(limit is int milliseconds ? milliseconds / 1000.0 : DefaultTimeoutSeconds);
        IOuterUnityTestAction[] outer = Attributes<IOuterUnityTestAction>(test).ToArray();
        void Check() => log.Evaluate(atEnd: false);
        try
        {
            foreach (IOuterUnityTestAction action in outer) driver.Run(action.BeforeTest(test), Check);
            foreach (MethodInfo method in methods.UnitySetUp) driver.Run((IEnumerator)FixtureMethods.Call(method, fixture)!, Check);
            context.CurrentResult = BuildCommand(test, methods, driver, log).Execute(context);
        }
        catch (Exception exception)
        {
            context.CurrentResult.RecordException(exception);
        }
        foreach (MethodInfo method in methods.UnityTearDown) Guard(context, () => driver.Run((IEnumerator)FixtureMethods.Call(method, fixture)!, Check));
        foreach (IOuterUnityTestAction action in outer.Reverse()) Guard(context, () => driver.Run(action.AfterTest(test), Check));
        ReportOutOfBounds();
        CheckLog(context, log);
    }

    /// <summary>An access outside a buffer or array is an error of the test in which a shader made it.</summary>
    static void ReportOutOfBounds()
    {
        if (!GraphicsDevice.IsReady) return;
        foreach (string line in GraphicsDevice.Device.TakeOutOfBounds()) UnityEngine.Debug.LogError(line);
    }

    static void CheckLog(TestExecutionContext context, LogScope log)
    {
        if (context.CurrentResult.ResultState.Status != TestStatus.Passed) return;
        try
        {
            log.Evaluate(atEnd: true);
        }
        catch (AssertionException exception)
        {
            context.CurrentResult.SetResult(ResultState.Failure, exception.Message);
        }
    }

    static TestCommand BuildCommand(TestMethod test, FixtureMethods methods, FrameDriver driver, LogScope log)
    {
        TestCommand command = new TestBodyCommand(test, driver, log);
        foreach (IWrapTestMethod wrapper in test.Method!.GetCustomAttributes<IWrapTestMethod>(true)) command = wrapper.Wrap(command);
        command = new SetUpTearDownCommand(test, command, methods, Actions(test));
        foreach (IWrapSetUpTearDown wrapper in test.Method.GetCustomAttributes<IWrapSetUpTearDown>(true)) command = wrapper.Wrap(command);
        return command;
    }

    static IReadOnlyList<ITestAction> Actions(TestMethod test)
    {
        Type type = test.TypeInfo!.Type;
        var actions = new List<ITestAction>();
        IEnumerable<object> outer = type.Assembly.GetCustomAttributes(true).Concat(type.GetCustomAttributes(true));
        actions.AddRange(outer.OfType<ITestAction>().Where(a => (a.Targets & ActionTargets.Test) != 0));
        actions.AddRange(test.Method!.GetCustomAttributes<ITestAction>(true));
        return actions;
    }

    static IEnumerable<T> Attributes<T>(TestMethod test) where T : class =>
        test.TypeInfo!.Type.GetCustomAttributes(true).Concat(test.Method!.MethodInfo.GetCustomAttributes(true)).OfType<T>();

    static bool MustExpectAll(TestMethod test) =>
        (test.Method!.MethodInfo.GetCustomAttribute<TestMustExpectAllLogsAttribute>()
            ?? test.TypeInfo!.Type.GetCustomAttribute<TestMustExpectAllLogsAttribute>()
            ?? test.TypeInfo.Type.Assembly.GetCustomAttribute<TestMustExpectAllLogsAttribute>())?.MustExpect ?? false;

    static void Guard(TestExecutionContext context, Action action)
    {
        try
        {
            action();
        }
        catch (Exception exception)
        {
            context.CurrentResult.RecordTearDownException(exception);
        }
    }
}
