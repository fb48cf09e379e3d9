using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace Headless.Tests.UnityEngineApi;

/// <summary>When physics steps, by Physics.simulationMode.</summary>
public class PhysicsSimulationTests : EngineFixture
{
    Rigidbody m_Body = null!;

    [SetUp]
    public void AddBody()
    {
        (Time.fixedDeltaTime, Time.captureDeltaTime) = (0.25f, 0.0625f);
        m_Body = new GameObject("Body").AddComponent<Rigidbody>();
        (m_Body.useGravity, m_Body.velocity) = (false, Vector3.right);
    }

    sealed class Follower : MonoBehaviour
    {
        public Rigidbody Body = null!;
        public float InUpdate, InLateUpdate;

        void Update() => InUpdate = Body.position.x;
        void LateUpdate() => InLateUpdate = Body.position.x;
    }

    [TestCase(SimulationMode.FixedUpdate, 0.5f)]
    [TestCase(SimulationMode.Update, 0.3125f)]
    [TestCase(SimulationMode.Script, 0f)]
    public void StepsComeByItsMode(SimulationMode mode, float expected)
    {
        Physics.simulationMode = mode;
        Frame(5);
        Assert.That(m_Body.position.x, Is.EqualTo(expected));
    }

    [Test]
    public void InModeUpdateTheStepComesAfterUpdateAndTakesTheFrame()
    {
        Physics.simulationMode = SimulationMode.Update;
        Follower follower = new GameObject("Follower").AddComponent<Follower>();
        follower.Body = m_Body;
        Frame(2);
        Assert.That((follower.InUpdate, follower.InLateUpdate), Is.EqualTo((0.0625f, 0.125f)));
    }

    [Test]
    public void InModeScriptSimulateTakesAnyStep([Values] bool ofTheScene)
    {
        Physics.simulationMode = SimulationMode.Script;
        for (int i = 0; i < 3; i++)
            if (ofTheScene) Physics.defaultPhysicsScene.Simulate(0.5f);
            else Physics.Simulate(0.5f);
        Assert.That(m_Body.position.x, Is.EqualTo(1.5f));
    }

    [Test]
    public void InOtherModesSimulateDoesNothingAndSaysSo([Values] bool ofTheScene)
    {
        if (ofTheScene) Physics.defaultPhysicsScene.Simulate(0.5f);
        else Physics.Simulate(0.5f);
        Assert.That(m_Body.position.x, Is.EqualTo(0f));
        Assert.That(Console.Single(), Does.Contain("Simulate(...) was called but simulation mode is not set to Script."));
    }
}
