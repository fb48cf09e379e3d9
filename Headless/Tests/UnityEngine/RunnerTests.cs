using System.IO;
using System.Linq;
using Headless.Engine;
using NUnit.Framework;
using NUnit.Framework.Interfaces;
using UnityEngine.TestTools;

namespace Headless.Tests.UnityEngineApi;

/// <summary>The Unity test runner against fixtures that pass, fail and skip on purpose.</summary>
public class RunnerTests : EngineFixture
{
    readonly StringWriter m_Output = new();

    TestRunResult Run(string filter, TestPlatform mode = TestPlatform.PlayMode)
    {
        PlaySession.End();
        return UnityTestRunner.Run(new[] { typeof(RunnerTests).Assembly }, mode, filter, m_Output);
    }

    static TestStatus Status(TestRunResult result, string name) => result.Outcomes.Single(o => o.FullName.EndsWith("." + name, System.StringComparison.Ordinal)).Status;

    [Test]
    public void PlainAndFrameTestsRun()
    {
        TestRunResult result = Run(nameof(RunnerSamples.SamplePasses));
        Assert.That(result.Succeeded, Is.True, result.ToString() + m_Output);
        Assert.That(result.Passed, Is.EqualTo(9));
        Assert.That(m_Output.ToString(), Does.Contain("pass").And.Contain(" ms)"));
    }

    [Test]
    public void SetUpsRunInTheDocumentedOrder()
    {
        TestRunResult result = Run(nameof(RunnerSamples.SampleOrder));
        Assert.That(result.Succeeded, Is.True, m_Output.ToString());
        Assert.That(RunnerSamples.SampleOrder.Log, Is.EqualTo("once unity-setup setup test teardown unity-teardown once-down "));
    }

    [TestCase("AssertFails", "Expected: 2")]
    [TestCase("UnexpectedError", "Unhandled log message: '[Error] surprise'")]
    [TestCase("UnexpectedErrorInAFrame", "Unhandled log message: '[Error] surprise'")]
    [TestCase("ExceptionInUpdate", "InvalidOperationException: in update")]
    [TestCase("MissingExpectedLog", "Expected log did not appear: [Warning] never")]
    [TestCase("NestedAssertFails", "Expected: 2")]
    [TestCase("TooSlow", "exceeded Timeout")]
    [TestCase("UnexpectedInfo", "Unhandled log message: '[Log] chatty'")]
    public void FailuresAreFound(string test, string message)
    {
        TestRunResult result = Run("SampleFails." + test + "$");
        Assert.That(result.Failed, Is.EqualTo(1), m_Output.ToString());
        Assert.That(result.Outcomes[0].Message, Does.Contain(message));
        Assert.That(result.Succeeded, Is.False);
    }

    [Test]
    public void SkipsAreCounted()
    {
        TestRunResult result = Run(nameof(RunnerSamples.SampleSkips));
        Assert.That(Status(result, "IgnoredByAttribute"), Is.EqualTo(TestStatus.Skipped));
        Assert.That(Status(result, "IgnoredByCall"), Is.EqualTo(TestStatus.Skipped));
        Assert.That(Status(result, "Assumption"), Is.EqualTo(TestStatus.Inconclusive));
        Assert.That(result.Succeeded, Is.False);
    }

    [Test]
    public void ARunWithoutTestsFails()
    {
        TestRunResult result = Run("NoSuchTestAnywhere");
        Assert.That(result.Outcomes, Is.Empty);
        Assert.That(result.Succeeded, Is.False);
    }

    [Test]
    public void EditModeIsNotPlaying()
    {
        TestRunResult result = Run(nameof(RunnerSamples.SampleEditMode), TestPlatform.EditMode);
        Assert.That(result.Passed, Is.EqualTo(2), m_Output.ToString());
    }

    [Test]
    public void CategoriesSelect()
    {
        TestRunResult result = Run("category:SampleCategory");
        Assert.That(result.Passed, Is.EqualTo(1), m_Output.ToString());
    }
}
