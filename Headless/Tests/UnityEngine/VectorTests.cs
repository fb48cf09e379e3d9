using NUnit.Framework;
using UnityEngine;
using Random = UnityEngine.Random;

namespace Headless.Tests.UnityEngineApi;

public class VectorTests
{
    [Test]
    public void CrossOfRightAndUpIsForward() => Assert.That(Vector3.Cross(Vector3.right, Vector3.up), Is.EqualTo(Vector3.forward));

    [Test]
    public void EqualityOperatorIsApproximateEqualsIsNot()
    {
        var a = new Vector3(1f, 1f, 1f);
        var b = new Vector3(1f, 1f, 1.000001f);
        Assert.That(a == b, Is.True);
        Assert.That(a.Equals(b), Is.False);
    }

    [Test]
    public void TextForms()
    {
        Assert.That(new Vector3(1f, 2.345f, -3f).ToString(), Is.EqualTo("(1.00, 2.35, -3.00)").Or.EqualTo("(1.00, 2.34, -3.00)"));
        Assert.That(new Vector2Int(3, -4).ToString(), Is.EqualTo("(3, -4)"));
        Assert.That(new Bounds(Vector3.one, Vector3.one * 2f).ToString(), Is.EqualTo("Center: (1.00, 1.00, 1.00), Extents: (1.00, 1.00, 1.00)"));
        Assert.That(Color.red.ToString(), Is.EqualTo("RGBA(1.000, 0.000, 0.000, 1.000)"));
        Assert.That(((Color32)Color.red).ToString(), Is.EqualTo("RGBA(255, 0, 0, 255)"));
    }

    [Test]
    public void NormalizedOfNearlyNothingIsZero() => Assert.That(new Vector3(1e-6f, 0f, 0f).normalized, Is.EqualTo(Vector3.zero));

    [Test]
    public void SignedAngleFollowsTheLeftHand()
    {
        Assert.That(Vector3.SignedAngle(Vector3.forward, Vector3.right, Vector3.up), Is.EqualTo(90f).Within(1e-3f));
        Assert.That(Vector3.SignedAngle(Vector3.right, Vector3.forward, Vector3.up), Is.EqualTo(-90f).Within(1e-3f));
    }

    [Test]
    public void RoundingIsToEven()
    {
        Assert.That(Mathf.RoundToInt(0.5f), Is.Zero);
        Assert.That(Mathf.RoundToInt(1.5f), Is.EqualTo(2));
        Assert.That(Mathf.NextPowerOfTwo(1025), Is.EqualTo(2048));
        Assert.That(Mathf.ClosestPowerOfTwo(1025), Is.EqualTo(1024));
        Assert.That(Mathf.Sign(0f), Is.EqualTo(1f));
        Assert.That(Mathf.Repeat(-0.25f, 1f), Is.EqualTo(0.75f));
        Assert.That(Mathf.DeltaAngle(350f, 10f), Is.EqualTo(20f));
    }

    [Test]
    public void BoundsEncapsulateAndIntersect()
    {
        var b = new Bounds(Vector3.zero, Vector3.one);
        b.Encapsulate(new Vector3(2f, 0f, 0f));
        Assert.That(b.min, Is.EqualTo(new Vector3(-0.5f, -0.5f, -0.5f)));
        Assert.That(b.max, Is.EqualTo(new Vector3(2f, 0.5f, 0.5f)));
        Assert.That(b.Intersects(new Bounds(new Vector3(2.5f, 0f, 0f), Vector3.one)), Is.True);
        Assert.That(b.Intersects(new Bounds(new Vector3(3f, 0f, 0f), Vector3.one)), Is.False);
        Assert.That(b.IntersectRay(new Ray(new Vector3(-5f, 0f, 0f), Vector3.right), out float distance), Is.True);
        Assert.That(distance, Is.EqualTo(4.5f).Within(1e-5f));
    }

    [Test]
    public void APlaneThroughClockwisePointsFacesTheViewer()
    {
        var plane = new Plane(Vector3.zero, Vector3.forward, Vector3.right);
        Assert.That(plane.normal, Is.EqualTo(Vector3.up));
        Assert.That(plane.GetDistanceToPoint(new Vector3(7f, 3f, 1f)), Is.EqualTo(3f));
        Assert.That(plane.Raycast(new Ray(Vector3.up * 2f, Vector3.down), out float enter), Is.True);
        Assert.That(enter, Is.EqualTo(2f));
    }

    [Test]
    public void RandomRepeatsFromItsSeed()
    {
        Random.InitState(42);
        float a = Random.value;
        int b = Random.Range(0, 10);
        Random.State state = Random.state;
        float c = Random.value;
        Random.state = state;
        Assert.That(Random.value, Is.EqualTo(c));
        Random.InitState(42);
        Assert.That(Random.value, Is.EqualTo(a));
        Assert.That(Random.Range(0, 10), Is.EqualTo(b));
        for (int i = 0; i < 1000; i++) Assert.That(Random.Range(-3, 4), Is.InRange(-3, 3));
    }
}
