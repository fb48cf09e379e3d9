using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>Rigidbodies move in physics steps as PhysX moves them where nothing but forces, gravity and what stands still acts.</summary>
public class RigidbodyTests : EngineFixture
{
    const float Step = 0.02f;

    static Rigidbody Make<T>(Vector3 position = default, Vector3? scale = null) where T : Collider
    {
        var owner = new GameObject("Body");
        owner.transform.position = position;
        owner.transform.localScale = scale ?? Vector3.one;
        owner.AddComponent<T>();
        return owner.AddComponent<Rigidbody>();
    }

    static void Simulate(int steps)
    {
        Physics.simulationMode = SimulationMode.Script;
        for (int i = 0; i < steps; i++) Physics.Simulate(Step);
    }

    [Test]
    public void GravityActsOnTheVelocityFirst()
    {
        Rigidbody body = Make<BoxCollider>();
        Simulate(3);
        Assert.That(body.velocity.y, Is.EqualTo(-9.81f * 3 * Step).Within(1e-5f));
        Assert.That(body.position.y, Is.EqualTo(-9.81f * Step * Step * (1 + 2 + 3)).Within(1e-5f));
    }

    [TestCase(ForceMode.Force, 6f * Step / 2f)]
    [TestCase(ForceMode.Acceleration, 6f * Step)]
    [TestCase(ForceMode.Impulse, 3f)]
    [TestCase(ForceMode.VelocityChange, 6f)]
    public void AForceActsInTheNextStepAndOnce(ForceMode mode, float expected)
    {
        Rigidbody body = Make<BoxCollider>();
        body.mass = 2f;
        body.useGravity = false;
        body.AddForce(new Vector3(6f, 0f, 0f), mode);
        Assert.That(body.velocity, Is.EqualTo(Vector3.zero));
        Assert.That(body.GetAccumulatedForce(Step).x, Is.EqualTo(expected * body.mass / Step).Within(1e-3f));
        Simulate(2);
        Assert.That(body.velocity.x, Is.EqualTo(expected).Within(1e-5f));
        Assert.That(body.GetAccumulatedForce(Step), Is.EqualTo(Vector3.zero));
    }

    [Test]
    public void DampingFollowsForces()
    {
        Rigidbody body = Make<BoxCollider>();
        body.drag = 5f;
        Simulate(1);
        Assert.That(body.velocity.y, Is.EqualTo(-9.81f * Step * 0.9f).Within(1e-5f));
    }

    [Test]
    public void AKinematicBodyStays()
    {
        Rigidbody body = Make<BoxCollider>();
        body.isKinematic = true;
        Simulate(5);
        Assert.That(body.position, Is.EqualTo(Vector3.zero));
    }

    [Test]
    public void FrozenAxesOfTheWorldAndTurnsOfTheBodyAreLeftOut()
    {
        Rigidbody body = Make<BoxCollider>();
        body.constraints = RigidbodyConstraints.FreezePositionY | RigidbodyConstraints.FreezeRotationX;
        body.AddForce(new Vector3(1f, 0f, 0f), ForceMode.VelocityChange);
        body.AddTorque(new Vector3(1f, 0f, 2f), ForceMode.VelocityChange);
        Simulate(1);
        Assert.That((body.velocity - new Vector3(1f, 0f, 0f)).magnitude, Is.LessThan(1e-5f));
        Assert.That(body.angularVelocity.x, Is.EqualTo(0f).Within(1e-5f));
        Assert.That(body.angularVelocity.z, Is.EqualTo(2f * (1f - 0.05f * Step)).Within(1e-5f));
    }

    [Test]
    public void MassIsSpreadEvenlyOverABox()
    {
        Rigidbody body = Make<BoxCollider>(new Vector3(3f, 1f, 2f), new Vector3(1f, 2f, 3f));
        body.mass = 12f;
        Assert.That((body.inertiaTensor - new Vector3(13f, 10f, 5f)).magnitude, Is.LessThan(1e-4f));
        Assert.That(body.centerOfMass.magnitude, Is.LessThan(1e-6f));
    }

    [Test]
    public void BallsAndCapsulesHaveTheirMoments()
    {
        Rigidbody ball = Make<SphereCollider>();
        Assert.That(ball.inertiaTensor.y, Is.EqualTo(0.4f * 0.25f).Within(1e-5f));
        Rigidbody capsule = Make<CapsuleCollider>();
        capsule.GetComponent<CapsuleCollider>().height = 1f; // no cylinder is left of it
        Assert.That((capsule.inertiaTensor - 0.1f * Vector3.one).magnitude, Is.LessThan(1e-5f));
    }

    [Test]
    public void AMeshIsAsTheBoxThatItIs()
    {
        var corners = new Vector3[8];
        for (int i = 0; i < 8; i++) corners[i] = new Vector3(i & 1, i >> 1 & 1, i >> 2 & 1);
        var mesh = new Mesh
        {
            vertices = corners,
            triangles = [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4, 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5],
        };
        Rigidbody body = Make<MeshCollider>(scale: new Vector3(1f, 2f, 3f));
        body.GetComponent<MeshCollider>().sharedMesh = mesh;
        body.mass = 12f;
        Assert.That((body.centerOfMass - new Vector3(0.5f, 1f, 1.5f)).magnitude, Is.LessThan(1e-5f));
        Assert.That((body.inertiaTensor - new Vector3(13f, 10f, 5f)).magnitude, Is.LessThan(1e-3f));
    }

    [Test]
    public void TwoCollidersOfABodyAreOne()
    {
        Rigidbody body = Make<BoxCollider>();
        body.mass = 2f;
        body.GetComponent<BoxCollider>().center = new Vector3(-1f, 0f, 0f);
        body.gameObject.AddComponent<BoxCollider>().center = new Vector3(1f, 0f, 0f);
        Assert.That(body.centerOfMass.magnitude, Is.LessThan(1e-6f));
        Assert.That(body.inertiaTensor.x, Is.EqualTo(2f / 6f).Within(1e-5f));
        Assert.That(body.inertiaTensor.y, Is.EqualTo(2f / 6f + 2f).Within(1e-4f));
    }

    [Test]
    public void ABoxThatFallsOnTheFloorRests()
    {
        new GameObject("Floor").AddComponent<BoxCollider>().size = new Vector3(10f, 1f, 10f);
        Rigidbody body = Make<BoxCollider>(new Vector3(0f, 1.5f, 0f));
        body.rotation = Quaternion.Euler(0f, 30f, 8f);
        Simulate(150);
        Assert.That(body.position.y, Is.EqualTo(1f).Within(0.02f));
        Assert.That(body.velocity.magnitude, Is.LessThan(0.05f));
        Assert.That(Vector3.Angle(body.transform.up, Vector3.up), Is.LessThan(2f));
    }

    [Test]
    public void TwoBodiesThatRunIntoEachOtherKeepTheirMomentum()
    {
        Rigidbody a = Make<BoxCollider>(), b = Make<SphereCollider>(new Vector3(1.5f, 0.1f, 0f));
        (a.useGravity, b.useGravity, a.mass, b.mass) = (false, false, 3f, 1f);
        (a.angularDrag, b.angularDrag) = (0f, 0f);
        a.velocity = new Vector3(2f, 0f, 0f);
        Simulate(60);
        Assert.That(b.velocity.x, Is.GreaterThan(1f));
        Assert.That(3f * a.velocity.x + b.velocity.x, Is.EqualTo(6f).Within(1e-3f));
    }

    [TestCase("velocity")]
    [TestCase("angularVelocity")]
    [TestCase("position")]
    [TestCase("rotation")]
    [TestCase("force")]
    [TestCase("torque")]
    public void WhatIsNotFiniteIsRefusedInUnitysWords(string name)
    {
        Rigidbody body = Make<BoxCollider>(new Vector3(0f, 1f, 0f));
        body.useGravity = false;
        foreach (float bad in new[] { float.NaN, float.PositiveInfinity })
        {
            var vector = new Vector3(bad, 0f, 2f);
            if (name == "velocity") body.velocity = vector;
            if (name == "angularVelocity") body.angularVelocity = vector;
            if (name == "position") body.position = vector;
            if (name == "rotation") body.rotation = new Quaternion(bad, 0f, 2f, 0f);
            if (name == "force") body.AddForce(vector);
            if (name == "torque") body.AddTorque(vector);
            string numbers = $"{(float.IsNaN(bad) ? "NaN" : "Infinity")}, 0.000000, 2.000000{(name == "rotation" ? ", 0.000000" : "")}";
            Assert.That(Console[^1], Does.Contain($"rigidbody.{name} assign attempt for 'Body' is not valid. Input {name} is {{ {numbers} }}."));
        }
        Simulate(1);
        Assert.That((body.position, body.rotation, body.velocity, body.angularVelocity),
            Is.EqualTo((new Vector3(0f, 1f, 0f), Quaternion.identity, Vector3.zero, Vector3.zero)));
    }

    [TestCase(0f, 1e-7f)]
    [TestCase(-3f, 1e-7f)]
    [TestCase(2f, 2f)]
    [TestCase(float.NaN, 5f)]
    public void AMassIsNeverBelowTheLeast(float given, float expected)
    {
        Rigidbody body = Make<BoxCollider>();
        body.mass = 5f;
        body.mass = given;
        Assert.That(body.mass, Is.EqualTo(expected));
    }
}
