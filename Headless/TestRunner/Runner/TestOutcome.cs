using NUnit.Framework.Interfaces;
using NUnit.Framework.Internal;

namespace Headless.Engine;

/// <summary>How one test ended.</summary>
sealed record TestOutcome(string FullName, TestStatus Status, string Message, string StackTrace, string Output, double Seconds)
{
    public static TestOutcome From(TestMethod test, TestResult result) =>
        new(test.FullName, result.ResultState.Status, result.Message ?? "", result.StackTrace ?? "", result.Output ?? "", result.Duration);
}
