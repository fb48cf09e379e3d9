using System.Collections;
using System.Reflection;
using System.Threading.Tasks;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Commands;

namespace Headless.Engine;

/// <summary>The test method itself: plain, coroutine or task.</summary>
sealed class TestBodyCommand(TestMethod test, FrameDriver driver, LogScope log) : TestCommand(test)
{
    public override TestResult Execute(TestExecutionContext context)
    {
        MethodInfo method = test.Method!.MethodInfo;
        object? result = method.Invoke(method.IsStatic ? null : context.TestObject, BindingFlags.DoNotWrapExceptions, null, TestCaseValues.Arguments(test), null);
        if (result is IEnumerator routine)
        {
            driver.Run(routine, () => log.Evaluate(atEnd: false));
        }
        else if (result is Task task)
        {
            driver.Run(Wait(task), () => log.Evaluate(atEnd: false));
            task.GetAwaiter().GetResult();
        }
        else if (TestCaseValues.TryGetExpected(test, out object? expected))
        {
            Assert.AreEqual(expected, result);
        }
        if (context.CurrentResult.AssertionResults.Count > 0) context.CurrentResult.RecordTestCompletion();
        else context.CurrentResult.SetResult(ResultState.Success);
        return context.CurrentResult;
    }

    static IEnumerator Wait(Task task)
    {
        while (!task.IsCompleted) yield return null;
    }
}
