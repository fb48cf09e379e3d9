using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Settings of single colliders: friction, and the simulations they are for.</summary>
    public sealed class FluidColliderTests
    {
        private ColliderRig rig;

        [SetUp]
        public void SetUp() => rig = new ColliderRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        private float[] Frictions()
        {
            rig.Gather();
            return rig.Scene.Solids.Select(s => s.State.Friction).ToArray();
        }

        [Test]
        public void TheNearestEnabledSettingsCount()
        {
            GameObject box = rig.Add<BoxCollider>("box").gameObject;
            Assert.That(Frictions(), Is.EqualTo(new[] { ColliderSettings.DomainFriction }), "without settings the domain's");
            var own = box.AddComponent<FluidCollider>();
            own.Friction = 0.25f;
            Assert.That(Frictions(), Is.EqualTo(new[] { 0.25f }));
            own.OwnFriction = false;
            Assert.That(Frictions(), Is.EqualTo(new[] { ColliderSettings.DomainFriction }));
            own.OwnFriction = true;
            own.enabled = false;
            Assert.That(Frictions(), Is.EqualTo(new[] { ColliderSettings.DomainFriction }));
            own.enabled = true;
            GameObject sphere = rig.Add<SphereCollider>("sphere").gameObject;
            sphere.transform.SetParent(box.transform);
            Assert.That(Frictions(), Is.EqualTo(new[] { 0.25f, 0.25f }), "a child's colliders too");
        }

        [TestCase(-1f, 0f)]
        [TestCase(3f, 1f)]
        [TestCase(0.5f, 0.5f)]
        public void FrictionStaysInItsRange(float given, float expected)
        {
            var own = rig.Add<BoxCollider>().gameObject.AddComponent<FluidCollider>();
            own.Friction = given;
            Assert.That(own.Friction, Is.EqualTo(expected));
        }

        [Test]
        public void OnlyTheNamedSimulationsCollide()
        {
            FluidSimulation NewSimulation()
            {
                var holder = new GameObject("Fluid");
                holder.SetActive(false); // so that it does not start
                return holder.AddComponent<FluidSimulation>();
            }
            FluidSimulation first = NewSimulation(), second = NewSimulation();
            try
            {
                var own = rig.Add<BoxCollider>().gameObject.AddComponent<FluidCollider>();
                Assert.That(((IColliderSettings)own).AppliesTo(first) && ((IColliderSettings)own).AppliesTo(second), "none named: all");
                own.Simulations.Add(first);
                rig.Simulation = second;
                Assert.That(Frictions(), Is.Empty);
                rig.Simulation = first;
                Assert.That(Frictions().Length, Is.EqualTo(1));
            }
            finally
            {
                Object.DestroyImmediate(first.gameObject);
                Object.DestroyImmediate(second.gameObject);
            }
        }

        [Test]
        public void AChangeOfFrictionIsSeenAndMakesNoMover()
        {
            GpuTest.Require();
            using (var bodies = new CollisionBodies(BodyRig.Water(rig.DomainSize, rig.Spacing, 1f)))
            {
                BoxCollider slippery = rig.Add<BoxCollider>("slippery"), rough = rig.Add<BoxCollider>("rough");
                rough.transform.position = new Vector3(1.5f, 0f, 0f);
                rig.Gather();
                bodies.Update(rig.Scene.Solids);
                Assert.That(bodies.Count, Is.EqualTo(1));
                Assert.That(bodies.HoldLiquid, Is.False);
                var own = rough.gameObject.AddComponent<FluidCollider>();
                Assert.That(rig.Gather());
                bodies.Update(rig.Scene.Solids);
                Assert.That(bodies.Count, Is.EqualTo(2), "what has the same friction is one body");
                Assert.That(bodies.HoldLiquid);
                rough.transform.position += Vector3.up;
                rig.Gather();
                bodies.Update(rig.Scene.Solids);
                Assert.That(bodies.Count, Is.EqualTo(2), "one rests, one moves");
                int version = bodies.Version;
                own.Friction = 0f;
                Assert.That(rig.Gather());
                bodies.Update(rig.Scene.Solids);
                Assert.That(bodies.HoldLiquid, Is.False);
                Assert.That(bodies.Version, Is.EqualTo(version), "no lists were made");
                Object.DestroyImmediate(slippery.gameObject);
            }
        }
    }
}
