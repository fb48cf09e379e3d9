using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Left-handed: a positive turn about an axis is clockwise seen from its tip; Euler angles turn about z, x, y.</summary>
public class QuaternionTests
{
    static void Near(Vector3 actual, Vector3 expected, float tolerance = 1e-5f) =>
        Assert.That((actual - expected).magnitude, Is.LessThan(tolerance), $"{actual.ToString("F6")} is not {expected.ToString("F6")}");

    [Test]
    public void QuarterTurnsFollowTheLeftHand()
    {
        Near(Quaternion.Euler(0f, 90f, 0f) * Vector3.forward, Vector3.right);
        Near(Quaternion.Euler(90f, 0f, 0f) * Vector3.forward, Vector3.down);
        Near(Quaternion.Euler(0f, 0f, 90f) * Vector3.right, Vector3.up);
    }

    [Test]
    public void EulerIsZThenXThenY()
    {
        Quaternion q = Quaternion.Euler(30f, 40f, 50f);
        Quaternion product = Quaternion.AngleAxis(40f, Vector3.up) * Quaternion.AngleAxis(30f, Vector3.right) * Quaternion.AngleAxis(50f, Vector3.forward);
        Assert.That(q == product, Is.True);
        Near(q.eulerAngles, new Vector3(30f, 40f, 50f), 1e-3f);
    }

    [TestCase(0f, 0f, 0f)]
    [TestCase(10f, 200f, 300f)]
    [TestCase(-80f, 10f, 20f)]
    [TestCase(90f, 30f, 0f)]
    [TestCase(-90f, 30f, 0f)]
    public void EulerAnglesRoundTripAsARotation(float x, float y, float z)
    {
        Quaternion q = Quaternion.Euler(x, y, z);
        Assert.That(Quaternion.Angle(q, Quaternion.Euler(q.eulerAngles)), Is.LessThan(0.1f));
    }

    [Test]
    public void KnownComponents()
    {
        Quaternion q = Quaternion.Euler(0f, 90f, 0f);
        Assert.That(q.y, Is.EqualTo(0.70710678f).Within(1e-6f));
        Assert.That(q.w, Is.EqualTo(0.70710678f).Within(1e-6f));
        Assert.That(Quaternion.identity.ToString(), Is.EqualTo("(0.00000, 0.00000, 0.00000, 1.00000)"));
    }

    [Test]
    public void LookRotationTurnsForwardToTheDirectionAndKeepsUp()
    {
        Quaternion q = Quaternion.LookRotation(new Vector3(1f, 1f, 0f));
        Near(q * Vector3.forward, new Vector3(1f, 1f, 0f).normalized);
        Assert.That((q * Vector3.up).y, Is.GreaterThan(0f));
        Near(q * Vector3.right, Vector3.back);
    }

    [Test]
    public void FromToRotationAlsoForOppositeDirections()
    {
        Near(Quaternion.FromToRotation(Vector3.right, Vector3.up) * Vector3.right, Vector3.up);
        Near(Quaternion.FromToRotation(Vector3.up, Vector3.down) * Vector3.up, Vector3.down);
    }

    [Test]
    public void SlerpGoesHalfWayOnTheShortArc()
    {
        Quaternion half = Quaternion.Slerp(Quaternion.identity, Quaternion.Euler(0f, 90f, 0f), 0.5f);
        Near(half.eulerAngles, new Vector3(0f, 45f, 0f), 1e-3f);
        Quaternion far = Quaternion.Slerp(Quaternion.identity, new Quaternion(0f, -0.70710678f, 0f, -0.70710678f), 0.5f);
        Near(far.eulerAngles, new Vector3(0f, 45f, 0f), 1e-3f);
    }

    [Test]
    public void ToAngleAxisUndoesAngleAxis()
    {
        Quaternion.AngleAxis(70f, new Vector3(1f, 2f, 3f)).ToAngleAxis(out float angle, out Vector3 axis);
        Assert.That(angle, Is.EqualTo(70f).Within(1e-3f));
        Near(axis, new Vector3(1f, 2f, 3f).normalized);
    }
}
