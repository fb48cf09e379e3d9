using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What colliders and the simulation's settings ask of each other is said once, with the cure.</summary>
    public sealed class ColliderChecksTests
    {
        private ColliderRig rig;
        private FluidSimulation simulation;

        [SetUp]
        public void SetUp()
        {
            rig = new ColliderRig();
            var holder = new GameObject("Fluid");
            holder.SetActive(false); // so that it does not start
            simulation = rig.Simulation = holder.AddComponent<FluidSimulation>();
        }

        [TearDown]
        public void TearDown()
        {
            Object.DestroyImmediate(simulation.gameObject);
            rig.Dispose();
        }

        private FluidMessage[] Messages()
        {
            rig.Gather();
            Assert.That(rig.Scene.Solids.Count, Is.EqualTo(1));
            return rig.Scene.Messages.ToArray();
        }

        // The domain is 4 m, the spacing 0.1 m, R = 0.225 m.
        [TestCase(0f, 1f, false)]
        [TestCase(1.25f, 1f, false)]
        [TestCase(1.35f, 1f, true)]
        [TestCase(-1.9f, 1f, true)]
        [TestCase(0f, 4f, true)]
        [TestCase(0f, 4.5f, false)]
        [TestCase(1f, 4.5f, true)]
        public void AColliderThatEndsAtAPeriodicFaceIsNamed(float x, float length, bool reported)
        {
            simulation.Boundaries = new FluidBoundaries { Periodic = FluidAxes.X };
            BoxCollider box = rig.Add<BoxCollider>("Weir");
            box.transform.position = new Vector3(x, 1.6f, 0f); // its end at the y face does not count
            box.size = new Vector3(length, 1f, 1f);
            FluidMessage[] messages = Messages();
            Assert.That(messages.Length, Is.EqualTo(reported ? 1 : 0));
            if (!reported) return;
            Assert.That(messages[0].Issue, Is.EqualTo(FluidIssue.ColliderAtPeriodicFace));
            Assert.That(messages[0].ToString(),
                Does.StartWith("[SPH Fluid] 'Weir': The BoxCollider ends at a periodic face of 'Fluid' along X").And
                    .Contain("Keep it 0.225 m or more inside"));
            box.transform.position += 0.01f * Vector3.right;
            Assert.That(Messages()[0], Is.EqualTo(messages[0]), "a moving collider says it once");
        }

        [Test]
        public void AFrictionThatTheMethodDoesNotKnowIsNamed()
        {
            var own = rig.Add<BoxCollider>("Weir").gameObject.AddComponent<FluidCollider>();
            simulation.Method = FluidMethodKind.Standard;
            Assert.That(Messages(), Is.Empty);
            simulation.Method = FluidMethodKind.Thesis;
            rig.Scene.Invalidate();
            FluidMessage message = Messages().Single();
            Assert.That(message.Issue, Is.EqualTo(FluidIssue.ColliderFrictionUnused));
            Assert.That(message.ToString(),
                Does.StartWith("[SPH Fluid] 'Weir': Its Fluid Collider").And.Contain("Set the simulation's Method to Standard"));
            own.OwnFriction = false;
            Assert.That(Messages(), Is.Empty);
        }
    }
}
