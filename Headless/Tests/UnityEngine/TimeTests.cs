using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

public class TimeTests : EngineFixture
{
    [Test]
    public void CaptureStepSetsEveryFrame()
    {
        Frame();
        Assert.That(Time.time, Is.Zero);
        Assert.That(Time.deltaTime, Is.EqualTo(0.1f));
        Frame(10);
        Assert.That(Time.time, Is.EqualTo(1f).Within(1e-5f));
        Assert.That(Time.frameCount, Is.EqualTo(11));
        Time.captureFramerate = 50;
        Assert.That(Time.captureDeltaTime, Is.EqualTo(0.02f));
    }

    [Test]
    public void FixedUpdateCatchesUpWithTime()
    {
        int steps = 0;
        ActionProbe probe = ActionProbe.Create();
        probe.onFixedUpdate = () =>
        {
            steps++;
            Assert.That(Time.deltaTime, Is.EqualTo(0.02f));
            Assert.That(Time.inFixedTimeStep, Is.True);
            Assert.That(Time.time, Is.EqualTo(Time.fixedTime));
        };
        Frame();
        Assert.That(steps, Is.EqualTo(1));
        Frame();
        Assert.That(steps, Is.EqualTo(6));
        Frame(9);
        Assert.That(steps, Is.EqualTo(51));
        Assert.That(Time.fixedTime, Is.EqualTo(Time.time).Within(0.02f));
        Assert.That(Console, Is.Empty);
    }

    [Test]
    public void TimeScaleSlowsScaledTimeOnly()
    {
        Frame();
        Time.timeScale = 0.5f;
        Frame(10);
        Assert.That(Time.time, Is.EqualTo(0.5f).Within(1e-5f));
        Assert.That(Time.unscaledTime, Is.EqualTo(1f).Within(1e-5f));
        Assert.That(Time.deltaTime, Is.EqualTo(0.05f).Within(1e-6f));
        int steps = 0;
        ActionProbe.Create().onFixedUpdate = () => steps++;
        Time.timeScale = 0f;
        Frame(5);
        Assert.That(steps, Is.Zero);
        Assert.That(Time.deltaTime, Is.Zero);
    }

    [Test]
    public void ALongRealFrameIsCutToMaximumDeltaTime()
    {
        Time.captureDeltaTime = 0f;
        Frame();
        Time.maximumDeltaTime = 0.03f;
        System.Threading.Thread.Sleep(60);
        Frame();
        Assert.That(Time.deltaTime, Is.EqualTo(0.03f));
        Assert.That(Time.unscaledDeltaTime, Is.GreaterThanOrEqualTo(0.055f));
    }
}
