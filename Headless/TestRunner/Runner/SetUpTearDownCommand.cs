using System.Collections.Generic;
using System.Reflection;
using NUnit.Framework;
using NUnit.Framework.Internal;
using NUnit.Framework.Internal.Commands;

namespace Headless.Engine;

/// <summary>SetUp and the actions around the body, then TearDown, whatever happened before.</summary>
sealed class SetUpTearDownCommand(TestMethod test, TestCommand body, FixtureMethods methods, IReadOnlyList<ITestAction> actions) : TestCommand(test)
{
    public override TestResult Execute(TestExecutionContext context)
    {
        int begun = 0;
        try
        {
            foreach (MethodInfo method in methods.SetUp) FixtureMethods.Call(method, context.TestObject);
            foreach (ITestAction action in actions)
            {
                begun++;
                action.BeforeTest(Test);
            }
            context.CurrentResult = body.Execute(context);
        }
        catch (Exception exception)
        {
            context.CurrentResult.RecordException(exception);
        }
        for (int i = begun - 1; i >= 0; i--)
        {
            ITestAction action = actions[i];
            Guard(context, () => action.AfterTest(Test));
        }
        foreach (MethodInfo method in methods.TearDown) Guard(context, () => FixtureMethods.Call(method, context.TestObject));
        return context.CurrentResult;
    }

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
