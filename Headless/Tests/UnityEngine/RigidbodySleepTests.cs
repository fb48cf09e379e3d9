using System;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Bodies that are slow for long sleep as PhysX has them sleep, and wake by what wakes them there.</summary>
public class RigidbodySleepTests : EngineFixture
{
    const float Step = 0.02f;

    [SetUp]
    public void ByScript() => Physics.simulationMode = SimulationMode.Script;

    static Rigidbody Make(Vector3 position = default)
    {
        var body = new GameObject("Body", typeof(BoxCollider)).AddComponent<Rigidbody>();
        body.transform.position = position;
        body.useGravity = false;
        return body;
    }

    static void Simulate(int steps)
    {
        for (int i = 0; i < steps; i++) Physics.Simulate(Step);
    }

    static Rigidbody Asleep(Vector3 position = default)
    {
        Rigidbody body = Make(position);
        Simulate(25);
        Assert.That(body.IsSleeping(), Is.True);
        return body;
    }

    [TestCase(0.09f, true)]
    [TestCase(0.11f, false)]
    public void ABodySleepsOnceItsEnergyIsBelowTheThresholdForLong(float speed, bool sleeps)
    {
        Rigidbody body = Make();
        body.velocity = new Vector3(speed, 0f, 0f);
        Simulate(15);
        Assert.That(body.IsSleeping(), Is.False, "not at once");
        Simulate(10);
        Assert.That(body.IsSleeping(), Is.EqualTo(sleeps));
        Assert.That(body.velocity.x, Is.EqualTo(sleeps ? 0f : speed).Within(1e-6f));
    }

    [Test]
    public void TheThresholdIsTheBodysOwn()
    {
        Rigidbody body = Make();
        Assert.That(body.sleepThreshold, Is.EqualTo(0.005f));
        body.sleepThreshold = 0f;
        Simulate(50);
        Assert.That(body.IsSleeping(), Is.False);
    }

    static readonly (string Name, bool Wakes, Action<Rigidbody> Act)[] s_Acts =
    [
        ("AddForce", true, b => b.AddForce(Vector3.up)),
        ("AddForce of nothing", false, b => b.AddForce(Vector3.zero)),
        ("AddTorque", true, b => b.AddTorque(Vector3.up)),
        ("velocity", true, b => b.velocity = 0.01f * Vector3.up),
        ("no velocity", false, b => b.velocity = Vector3.zero),
        ("position", true, b => b.position = Vector3.up),
        ("rotation", true, b => b.rotation = Quaternion.Euler(0f, 90f, 0f)),
        ("the Transform", true, b => { b.transform.position = Vector3.up; Physics.SyncTransforms(); }),
        ("WakeUp", true, b => b.WakeUp()),
        ("mass", false, b => b.mass = 3f),
    ];

    [Test]
    public void ItIsWokenByWhatActsOnIt()
    {
        foreach ((string name, bool wakes, Action<Rigidbody> act) in s_Acts)
        {
            Rigidbody body = Asleep();
            act(body);
            Assert.That(body.IsSleeping(), Is.EqualTo(!wakes), name);
            UnityEngine.Object.DestroyImmediate(body.gameObject);
        }
    }

    [Test]
    public void SleepStopsABodyUntilSomethingWakesIt()
    {
        Rigidbody body = Make();
        body.useGravity = true;
        body.velocity = Vector3.right;
        body.AddForce(Vector3.right);
        body.Sleep();
        Simulate(5);
        Assert.That((body.IsSleeping(), body.position, body.velocity), Is.EqualTo((true, Vector3.zero, Vector3.zero)));
        body.WakeUp();
        Simulate(1);
        Assert.That(body.velocity, Is.EqualTo(-9.81f * Step * Vector3.up));
    }

    [Test]
    public void AMovingBodyThatTouchesItWakesIt([Values] bool kinematic)
    {
        Rigidbody body = Asleep(), mover = Make(new Vector3(1.5f, 0.1f, 0f));
        mover.isKinematic = kinematic;
        if (!kinematic) mover.velocity = new Vector3(-2f, 0f, 0f);
        for (int i = 1; i <= 25; i++)
        {
            if (kinematic) mover.MovePosition(new Vector3(1.5f - 0.03f * i, 0.1f, 0f));
            Simulate(1);
            if (i == 5) Assert.That(body.IsSleeping(), Is.True, "it is not there yet");
        }
        Assert.That(body.IsSleeping(), Is.False);
    }
}
