using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Physics has a pose of its own; the Transform shows it, between steps where a body is interpolated.</summary>
public class RigidbodyInterpolationTests : EngineFixture
{
    [SetUp]
    public void Times() => (Time.fixedDeltaTime, Time.captureDeltaTime) = (0.25f, 0.0625f); // four frames a step, exact

    static Rigidbody Moving(RigidbodyInterpolation interpolation, bool kinematic = false)
    {
        var body = new GameObject("Body").AddComponent<Rigidbody>();
        (body.useGravity, body.interpolation, body.isKinematic) = (false, interpolation, kinematic);
        if (!kinematic) body.velocity = new Vector3(1f, 0f, 0f);
        return body;
    }

    // Of the frames after the step that ends at a time.
    static List<float> Shown(Rigidbody body, int frames)
    {
        var shown = new List<float>();
        for (int i = 0; i < frames; i++)
        {
            Frame();
            shown.Add(body.transform.position.x);
        }
        return shown;
    }

    [TestCase(RigidbodyInterpolation.None, 0.5f, 0.5f, 0.5f, 0.5f)]
    [TestCase(RigidbodyInterpolation.Interpolate, 0.25f, 0.3125f, 0.375f, 0.4375f)]
    [TestCase(RigidbodyInterpolation.Extrapolate, 0.5f, 0.5625f, 0.625f, 0.6875f)]
    public void TheTransformShowsTheBodyBetweenItsSteps(RigidbodyInterpolation interpolation, params float[] expected)
    {
        Rigidbody body = Moving(interpolation);
        Frame(4); // the first step, at time 0, and the frames before the next
        Assert.That(Shown(body, 4), Is.EqualTo(expected).Within(1e-6f));
        Assert.That(body.position.x, Is.EqualTo(0.5f), "where physics has it");
    }

    sealed class Probe : MonoBehaviour
    {
        public readonly List<float> Seen = new();

        void FixedUpdate() => Seen.Add(transform.position.x - GetComponent<Rigidbody>().position.x);
    }

    [Test]
    public void InFixedUpdateTheTransformIsWhereTheBodyIs()
    {
        Rigidbody body = Moving(RigidbodyInterpolation.Interpolate);
        Probe probe = body.gameObject.AddComponent<Probe>();
        Frame(9);
        Assert.That(probe.Seen, Is.EqualTo(new[] { 0f, 0f, 0f }));
    }

    [Test]
    public void APositionThatIsSetIsNotReachedBySteps()
    {
        Rigidbody body = Moving(RigidbodyInterpolation.Interpolate);
        Frame(5);
        body.position = new Vector3(10f, 0f, 0f);
        Assert.That(body.position.x, Is.EqualTo(10f));
        Assert.That(body.transform.position.x, Is.LessThan(1f), "until the next step");
        Frame(3);
        Assert.That(Shown(body, 2), Is.EqualTo(new[] { 10f, 10.0625f }).Within(1e-5f), "nothing between the places");
    }

    [Test]
    public void AKinematicBodyIsShownOnItsWayToMovePosition()
    {
        Rigidbody body = Moving(RigidbodyInterpolation.Interpolate, true);
        Frame(4);
        body.MovePosition(new Vector3(1f, 0f, 0f));
        body.MoveRotation(Quaternion.Euler(0f, 80f, 0f));
        Assert.That(body.position.x, Is.EqualTo(0f));
        Assert.That(Shown(body, 4), Is.EqualTo(new[] { 0f, 0.25f, 0.5f, 0.75f }).Within(1e-6f));
        Assert.That(body.transform.eulerAngles.y, Is.EqualTo(60f).Within(1e-3f));
        Assert.That(body.velocity.x, Is.EqualTo(4f).Within(1e-5f));
        Frame(1);
        Assert.That((body.velocity, body.transform.position.x), Is.EqualTo((Vector3.zero, 1f)));
    }

    [Test]
    public void MovePositionPutsABodyThatIsNotKinematicThereAtOnce()
    {
        Rigidbody body = Moving(RigidbodyInterpolation.None);
        body.MovePosition(new Vector3(7f, 0f, 0f));
        Assert.That(body.position.x, Is.EqualTo(7f));
    }

    [TestCase(false, 0.25f)]
    [TestCase(true, 5f)]
    public void ATransformThatAScriptMovesCountsOnceItIsSynchronised(bool sync, float expected)
    {
        Rigidbody body = Moving(RigidbodyInterpolation.Interpolate);
        Frame(1);
        body.transform.position = new Vector3(5f, 0f, 0f);
        if (sync) Physics.SyncTransforms();
        Assert.That(body.position.x, Is.EqualTo(expected));
        Frame(1);
        Assert.That(body.position.x, Is.EqualTo(expected), "physics has the Transform of a body that is interpolated");
    }

    [Test]
    public void WithAutoSyncTransformsItCountsAtOnce()
    {
        Rigidbody body = Moving(RigidbodyInterpolation.None);
        Physics.autoSyncTransforms = true;
        body.transform.position = new Vector3(5f, 0f, 0f);
        Assert.That(body.position.x, Is.EqualTo(5f));
    }

    [Test]
    public void WithoutItTheNextStepTakesItOver()
    {
        Rigidbody body = Moving(RigidbodyInterpolation.None);
        Frame(1);
        body.transform.position = new Vector3(5f, 0f, 0f);
        Assert.That(body.position.x, Is.EqualTo(0.25f));
        Frame(4);
        Assert.That(body.position.x, Is.EqualTo(5.25f));
    }

    [Test]
    public void QueriesFindABodyWherePhysicsHasIt()
    {
        Rigidbody body = Moving(RigidbodyInterpolation.Interpolate);
        body.gameObject.AddComponent<BoxCollider>().size = 0.1f * Vector3.one;
        Frame(5);
        Physics.SyncTransforms();
        var found = new Collider[1];
        Assert.That(body.transform.position.x, Is.EqualTo(0.25f));
        Assert.That(Physics.defaultPhysicsScene.OverlapSphere(new Vector3(0.5f, 0f, 0f), 0.01f, found, ~0, QueryTriggerInteraction.Ignore), Is.EqualTo(1));
        body.position = new Vector3(3f, 0f, 0f);
        Assert.That(Physics.defaultPhysicsScene.OverlapSphere(new Vector3(3f, 0f, 0f), 0.01f, found, ~0, QueryTriggerInteraction.Ignore), Is.EqualTo(1));
    }
}
