using System;
using System.Collections;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Fixtures for <see cref="RunnerTests"/>; explicit, so that nothing else runs them.</summary>
public static class RunnerSamples
{
    [Explicit]
    public class SamplePasses
    {
        [Test] public void Plain() => Assert.That(Application.isPlaying, Is.True);

        [TestCase(2, ExpectedResult = 4)]
        [TestCase(3, ExpectedResult = 9)]
        public int Square(int x) => x * x;

        [Test, Category("SampleCategory")]
        public void Values([Values(1)] int x) => Assert.That(x, Is.Positive);

        [UnityTest]
        public IEnumerator Frames()
        {
            int first = Time.frameCount;
            yield return null;
            Assert.That(Time.frameCount, Is.EqualTo(first + 1));
            yield return new WaitForFixedUpdate();
            yield return new WaitForEndOfFrame();
        }

        [UnityTest]
        public IEnumerator FramesWithValues([Values(1, 2)] int count)
        {
            for (int i = 0; i < count; i++) yield return null;
        }

        [UnityTest]
        public IEnumerator ExpectedLogs()
        {
            LogAssert.Expect(LogType.Error, "expected");
            LogAssert.Expect(LogType.Exception, new Regex("Invalid.*boom"));
            Debug.LogError("expected");
            yield return null;
            Debug.LogException(new InvalidOperationException("boom"));
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator Behaviour()
        {
            var wait = new MonoBehaviourTest<CountingTest>();
            yield return wait;
            Assert.That(wait.component.Frames, Is.EqualTo(3));
            Object.Destroy(wait.gameObject);
        }
    }

    [Explicit]
    public class SampleFails
    {
        [Test] public void AssertFails() => Assert.That(1, Is.EqualTo(2));
        [Test] public void UnexpectedError() => Debug.LogError("surprise");
        [Test] public void MissingExpectedLog() => LogAssert.Expect(LogType.Warning, "never");

        [Test]
        public void UnexpectedInfo()
        {
            Debug.Log("chatty");
            LogAssert.NoUnexpectedReceived();
        }

        [UnityTest]
        public IEnumerator UnexpectedErrorInAFrame()
        {
            Debug.LogError("surprise");
            yield return null;
            yield return null;
        }

        [UnityTest]
        public IEnumerator ExceptionInUpdate()
        {
            ActionProbe probe = ActionProbe.Create();
            probe.onUpdate = () => throw new InvalidOperationException("in update");
            yield return null;
            yield return null;
        }

        [UnityTest]
        public IEnumerator NestedAssertFails()
        {
            yield return Inner();
        }

        static IEnumerator Inner()
        {
            yield return null;
            Assert.That(1, Is.EqualTo(2));
        }

        [UnityTest, Timeout(50)]
        public IEnumerator TooSlow()
        {
            while (true)
            {
                System.Threading.Thread.Sleep(5);
                yield return null;
            }
        }
    }

    [Explicit]
    public class SampleSkips
    {
        [Test, Ignore("not now")] public void IgnoredByAttribute() => Assert.Fail();
        [Test] public void IgnoredByCall() => Assert.Ignore("no device");
        [Test] public void Assumption() => Assume.That(false);
    }

    [Explicit]
    public class SampleOrder
    {
        public static string Log { get; private set; } = "";

        [OneTimeSetUp] public void Once() => Log = "once ";
        [OneTimeTearDown] public void OnceDown() => Log += "once-down ";
        [SetUp] public void SetUp() => Log += "setup ";
        [TearDown] public void TearDown() => Log += "teardown ";

        [UnitySetUp]
        public IEnumerator UnitySetUp()
        {
            yield return null;
            Log += "unity-setup ";
        }

        [UnityTearDown]
        public IEnumerator UnityTearDown()
        {
            yield return null;
            Log += "unity-teardown ";
        }

        [Test] public void Body() => Log += "test ";
    }

    [Explicit]
    public class SampleEditMode
    {
        [Test] public void IsEditor() => Assert.That(Application.isPlaying || !Application.isEditor, Is.False);

        [UnityTest]
        public IEnumerator Frames()
        {
            yield return null;
            yield return null;
        }
    }
}
