using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Force zones as components.</summary>
    public sealed class ForceZoneTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        private FluidSimulation Liquid()
        {
            FluidSimulation simulation = rig.Create();
            simulation.DomainSize = new Vector3(0.8f, 0.8f, 0.8f);
            simulation.UseSceneGravity = false;
            simulation.Gravity = Vector3.zero;
            simulation.ExpectedSpeed = 2f;
            return simulation;
        }

        private FluidForceZone Zone(FluidForceKind kind, Vector3 direction, float strength = 4f)
        {
            FluidForceZone zone = rig.NewObject("Zone").AddComponent<FluidForceZone>();
            zone.transform.rotation = Quaternion.LookRotation(direction, Vector3.right);
            zone.Kind = kind;
            zone.Size = 2f * Vector3.one;
            zone.Strength = strength;
            return zone;
        }

        private static Vector3 Velocity(FluidSimulation simulation)
        {
            FluidParticle[] particles = SimulationRig.Read(simulation);
            return particles.Aggregate(Vector3.zero, (sum, p) => sum + p.VelT0) / particles.Length;
        }

        private IEnumerator Play(FluidSimulation simulation, double time)
        {
            while (!simulation.IsRunning || simulation.SimulatedTime < time) yield return null;
        }

        [UnityTest]
        public IEnumerator AnImpulseGivesItsVelocityOnce([Values(0f, 40f)] float turn)
        {
            FluidSimulation simulation = Liquid();
            simulation.transform.rotation = Quaternion.Euler(0f, turn, 0f);
            yield return Play(simulation, 0.02);
            Assert.That(Velocity(simulation).magnitude, Is.LessThan(1e-3f));
            simulation.AddImpulse(Vector3.zero, 2f, new Vector3(0f, 0.1f, 0.2f));
            simulation.AddImpulse(Vector3.zero, 2f, new Vector3(0f, 0.1f, 0f));
            Vector3 expected = Quaternion.Inverse(simulation.transform.rotation) * new Vector3(0f, 0.2f, 0.2f);
            for (int look = 0; look < 2; look++)
            {
                yield return Play(simulation, simulation.SimulatedTime + 0.03);
                Assert.That((Velocity(simulation) - expected).magnitude, Is.LessThan(0.02f), $"{Velocity(simulation)}, not {expected}");
            }
        }

        [UnityTest]
        public IEnumerator AnExplosionDrivesTheLiquidApart()
        {
            FluidSimulation simulation = Liquid();
            yield return Play(simulation, 0.02);
            simulation.AddExplosion(Vector3.zero, 1f, 0.3f);
            yield return Play(simulation, simulation.SimulatedTime + 0.02);
            float outward = SimulationRig.Read(simulation).Average(p => Vector3.Dot(p.VelT0, p.Position.normalized));
            Assert.That(outward, Is.InRange(0.1f, 0.35f));
            Assert.That(Velocity(simulation).magnitude, Is.LessThan(0.02f));
        }

        [UnityTest]
        public IEnumerator ImpulsesThatCannotActAreRefused()
        {
            FluidSimulation simulation = Liquid();
            Assert.That(() => simulation.AddImpulse(Vector3.zero, 1f, Vector3.up),
                Throws.InvalidOperationException.With.Message.Contains("does not run"));
            yield return Play(simulation, 0.01);
            Assert.That(() => simulation.AddImpulse(Vector3.zero, 0f, Vector3.up),
                Throws.ArgumentException.With.Message.Contains("radius"));
            Assert.That(() => simulation.AddImpulse(Vector3.zero, 1f, new Vector3(float.NaN, 0f, 0f)),
                Throws.ArgumentException.With.Message.Contains("finite"));
            Assert.That(() => simulation.AddExplosion(Vector3.zero, 1f, -1e3f),
                Throws.ArgumentException.With.Message.Contains("Expected Speed"));
            for (int i = 0; i < 16; i++) simulation.AddImpulse(Vector3.zero, 1f, Vector3.zero);
            Assert.That(() => simulation.AddImpulse(Vector3.zero, 1f, Vector3.zero), Throws.ArgumentException.With.Message.Contains("16"));
            simulation.Method = FluidMethodKind.Thesis;
            Assert.That(() => simulation.AddImpulse(Vector3.zero, 1f, Vector3.zero),
                Throws.InvalidOperationException.With.Message.Contains("Standard"));
        }

        [UnityTest]
        public IEnumerator APushAcceleratesTheLiquidAndEndsWithTheZone([Values(0f, 40f)] float turn)
        {
            FluidSimulation simulation = Liquid();
            simulation.transform.rotation = Quaternion.Euler(0f, turn, 0f);
            FluidForceZone zone = Zone(FluidForceKind.Directional, Vector3.forward);
            yield return Play(simulation, 0.1);
            Vector3 expected = Quaternion.Inverse(simulation.transform.rotation) *
                (4f * (float)(simulation.SimulatedTime - 0.5 * simulation.TimeStep) * Vector3.forward);
            Assert.That((Velocity(simulation) - expected).magnitude, Is.LessThan(0.02f), $"{Velocity(simulation)}, not {expected}");
            zone.enabled = false;
            yield return null;
            Vector3 after = Velocity(simulation);
            for (int frame = 0; frame < 5; frame++) yield return null;
            Assert.That((Velocity(simulation) - after).magnitude, Is.LessThan(1e-3f));
        }

        [UnityTest]
        public IEnumerator WindCarriesAndDampingHolds()
        {
            FluidSimulation simulation = Liquid();
            FluidForceZone zone = Zone(FluidForceKind.Wind, Vector3.up);
            zone.WindSpeed = 0.5f;
            zone.DragRate = 30f;
            yield return Play(simulation, 0.15);
            Assert.That(Velocity(simulation).y, Is.EqualTo(0.5f * (1f - Mathf.Exp(-30f * (float)simulation.SimulatedTime))).Within(0.02f));
            zone.Kind = FluidForceKind.Damping;
            yield return Play(simulation, 0.35);
            Assert.That(Velocity(simulation).magnitude, Is.LessThan(0.01f));
        }

        [UnityTest]
        public IEnumerator AVortexTurnsAndAPointDraws()
        {
            FluidSimulation simulation = Liquid();
            FluidForceZone zone = Zone(FluidForceKind.Vortex, Vector3.forward);
            zone.transform.rotation = Quaternion.identity;
            yield return Play(simulation, 0.06);
            FluidParticle[] particles = SimulationRig.Read(simulation);
            Assert.That(particles.Average(p => Vector3.Cross(p.Position, p.VelT0).y), Is.GreaterThan(0.002));
            Assert.That(Velocity(simulation).magnitude, Is.LessThan(0.01f), "round the middle");
            zone.Kind = FluidForceKind.Point;
            zone.Strength = -6f;
            double before = particles.Average(p => p.Position.magnitude);
            yield return Play(simulation, 0.2);
            Assert.That(SimulationRig.Read(simulation).Average(p => p.Position.magnitude), Is.GreaterThan(1.1 * before),
                "and away from it");
        }

        [UnityTest]
        public IEnumerator TurbulenceStirsWithoutAWind()
        {
            FluidSimulation simulation = Liquid();
            FluidForceZone zone = Zone(FluidForceKind.Turbulence, Vector3.forward);
            zone.EddySize = 0.1f;
            yield return Play(simulation, 0.1);
            FluidParticle[] particles = SimulationRig.Read(simulation);
            double rms = System.Math.Sqrt(particles.Average(p => (double)p.VelT0.sqrMagnitude));
            Assert.That(rms, Is.GreaterThan(0.05));
            Assert.That(Velocity(simulation).magnitude, Is.LessThan(0.6 * rms));
        }

        [UnityTest]
        public IEnumerator ABurstGivesItsVelocityOnceAndWakes()
        {
            FluidSimulation simulation = Liquid();
            FluidForceZone zone = Zone(FluidForceKind.Directional, Vector3.forward, 0f);
            yield return Play(simulation, 0.02);
            zone.Burst(new Vector3(0.3f, 0f, 0f));
            zone.Burst(new Vector3(0.1f, 0f, 0f));
            for (int frame = 0; frame < 6; frame++) yield return null;
            Assert.That((Velocity(simulation) - new Vector3(0.4f, 0f, 0f)).magnitude, Is.LessThan(0.01f), $"{Velocity(simulation)}");
            Assert.That(() => zone.Burst(new Vector3(1000f, 0f, 0f)), Throws.ArgumentException.With.Message.Contains("Expected Speed"));
            Assert.That(() => zone.Burst(new Vector3(float.NaN, 0f, 0f)), Throws.ArgumentException);
        }

        [UnityTest]
        public IEnumerator BlowsThatOverlapAreWeakenedToTheirLimitAndOthersAreNot()
        {
            FluidSimulation simulation = Liquid();
            rig.Profile.SoundSpeedMode = FluidSoundSpeedMode.FixedByRule;
            FluidForceZone zone = Zone(FluidForceKind.Directional, Vector3.forward, 0f);
            yield return Play(simulation, 0.02);
            float most = 0.2f * simulation.Solver.Settings.SoundSpeed;
            simulation.AddImpulse(new Vector3(5f, 0f, 0f), 1f, most * Vector3.up); // not where the liquid is: 5 m > 1 m + the zone's reach
            zone.Burst(0.1f * most * Vector3.right);
            yield return Play(simulation, simulation.SimulatedTime + 0.015);
            Assert.That((Velocity(simulation) - 0.1f * most * Vector3.right).magnitude, Is.LessThan(0.02f * most),
                "one that is elsewhere weakens nothing");
            Assert.That(simulation.Messages.Any(m => m.Text.Contains("add up")), Is.False);
            Vector3 before = Velocity(simulation);
            for (int i = 0; i < 4; i++) simulation.AddImpulse(Vector3.zero, 2f, 0.4f * most * Vector3.up);
            zone.Burst(-0.4f * most * Vector3.up);
            LogAssert.Expect(LogType.Warning, new Regex("add up to.*weakened"));
            yield return Play(simulation, simulation.SimulatedTime + 0.015);
            Assert.That((Velocity(simulation) - before - (4f - 1f) / 5f * most * Vector3.up).magnitude, Is.LessThan(0.05f * most),
                $"{Velocity(simulation)}, {most}");
        }

        // The liquid's cube is 0.2 m wide; the collider holds its right half.
        [UnityTest]
        public IEnumerator TheShapeOfAColliderIsItsPlaceSizeAndAxis([Values("box", "sphere", "capsule")] string shape)
        {
            FluidSimulation simulation = Liquid();
            FluidForceZone zone = Zone(FluidForceKind.Directional, Vector3.up);
            zone.transform.rotation = Quaternion.Euler(-90f, 0f, 0f); // forward is up
            zone.transform.localScale = new Vector3(2f, 2f, 2f);
            zone.Shape = FluidZoneShape.Collider;
            AddTrigger(zone, shape);
            yield return Play(simulation, 0.05);
            FluidParticle[] particles = SimulationRig.Read(simulation);
            float right = particles.Where(p => p.Position.x > 0.05f).Average(p => p.VelT0.y),
                left = particles.Where(p => p.Position.x < -0.02f).Average(p => p.VelT0.y);
            float rear = particles.Where(p => p.Position.x > 0.05f && p.Position.z > 0.05f).Average(p => p.VelT0.y);
            Assert.That(right, Is.GreaterThan(0.02f), "inside");
            Assert.That(rear, Is.GreaterThan(0.02f), "all along z");
            Assert.That(left, Is.LessThan(0.3f * right), "outside");
            Vector3 reach = zone.Spec.Size;
            Assert.That(zone.Spec.Position,
                Is.EqualTo(new Vector3(0.2f, 0f, 0f)).Using<Vector3>((a, b) => (a - b).magnitude < 1e-4f ? 0 : 1));
            Assert.That(reach.x, Is.EqualTo(0.4f).Within(1e-4f));
        }

        // At x = 0.2 m in the world, 0.4 m across x; a capsule lies along the world's z, which is the object's y.
        private static void AddTrigger(FluidForceZone zone, string shape)
        {
            var centre = new Vector3(0.1f, 0f, 0f);
            if (shape == "box")
            {
                BoxCollider box = zone.gameObject.AddComponent<BoxCollider>();
                (box.center, box.size, box.isTrigger) = (centre, new Vector3(0.2f, 0.5f, 0.5f), true);
            }
            else if (shape == "sphere")
            {
                SphereCollider sphere = zone.gameObject.AddComponent<SphereCollider>();
                (sphere.center, sphere.radius, sphere.isTrigger) = (centre, 0.1f, true);
            }
            else
            {
                CapsuleCollider capsule = zone.gameObject.AddComponent<CapsuleCollider>();
                (capsule.center, capsule.radius, capsule.height, capsule.direction, capsule.isTrigger) = (centre, 0.1f, 0.6f, 1, true);
            }
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(2)]
        public void ACapsuleColliderLiesAlongItsAxisAndTheForceStaysForward(int direction)
        {
            FluidForceZone zone = Zone(FluidForceKind.Directional, new Vector3(1f, 2f, 3f));
            zone.transform.localScale = new Vector3(1f, 2f, 3f);
            zone.Shape = FluidZoneShape.Collider;
            CapsuleCollider capsule = zone.gameObject.AddComponent<CapsuleCollider>();
            (capsule.radius, capsule.height, capsule.direction) = (0.1f, 1f, direction);
            ZoneSpec spec = zone.Spec;
            Vector3 axis = zone.transform.rotation * new Vector3(direction == 0 ? 1f : 0f, direction == 1 ? 1f : 0f,
                direction == 2 ? 1f : 0f);
            Assert.That(Mathf.Abs(Vector3.Dot(spec.Rotation * spec.ShapeTurn * Vector3.up, axis)), Is.EqualTo(1f).Within(1e-5f));
            Assert.That(spec.Rotation, Is.EqualTo(zone.transform.rotation));
            Assert.That(spec.Size.x, Is.EqualTo(direction == 2 ? 0.4f : 0.6f).Within(1e-5f));
            Assert.That(spec.Size.y, Is.EqualTo(direction + 1f).Within(1e-5f));
        }

        [UnityTest]
        public IEnumerator AShapeWithoutAColliderThatServesIsNamed()
        {
            FluidSimulation simulation = Liquid();
            FluidForceZone zone = Zone(FluidForceKind.Directional, Vector3.up);
            yield return Play(simulation, 0.01);
            zone.Shape = FluidZoneShape.Collider;
            zone.gameObject.AddComponent<MeshCollider>().isTrigger = true;
            LogAssert.Expect(LogType.Error, new Regex("Zone.*no Box, Sphere or Capsule Collider.*does nothing"));
            Vector3 before = Velocity(simulation);
            yield return Play(simulation, simulation.SimulatedTime + 0.03);
            Assert.That((Velocity(simulation) - before).magnitude, Is.LessThan(1e-3f));
        }

        [UnityTest]
        public IEnumerator AZoneThatMakesLiquidTooFastIsNamedOnce()
        {
            FluidSimulation simulation = Liquid(); // expected to reach 2 m/s, 0.8 m long
            FluidForceZone zone = Zone(FluidForceKind.Directional, Vector3.forward, 1f);
            yield return Play(simulation, 0.01);
            Assert.That(simulation.Messages.Any(m => m.Text.Contains("made for")), Is.False, "1.27 m/s are less than 2.5");
            zone.Strength = 20f;
            // √(0.1² + 2 · 20 · 0.8), as it falls 0.1 m/s at most
            LogAssert.Expect(LogType.Warning, new Regex("Zone.*to 5.66 m/s.*made for 2 m/s.*Expected Speed to 5.7 m/s"));
            yield return Play(simulation, simulation.SimulatedTime + 0.03);
            Assert.That(simulation.Messages.Count(m => m.Text.Contains("made for")), Is.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator OnlyTheLiquidThatIsNamedIsPushed()
        {
            FluidSimulation one = Liquid(), two = Liquid();
            Zone(FluidForceKind.Directional, Vector3.up).Simulation = two;
            yield return Play(two, 0.05);
            Assert.That(Velocity(one).magnitude, Is.LessThan(1e-3f));
            Assert.That(Velocity(two).y, Is.GreaterThan(0.1f));
        }

        [UnityTest]
        public IEnumerator WhatCannotBeIsReported()
        {
            FluidSimulation simulation = Liquid();
            FluidForceZone zone = Zone(FluidForceKind.Directional, Vector3.up);
            yield return Play(simulation, 0.01);
            zone.Strength = 1e7f;
            LogAssert.Expect(LogType.Error, new Regex("Zone.*strength is.*m/s².*Expected Speed"));
            yield return null;
            zone.Strength = float.NaN;
            LogAssert.Expect(LogType.Error, new Regex("Zone.*no number"));
            yield return null;
            zone.Strength = 0f;
            for (int i = 0; i < 16; i++) Zone(FluidForceKind.Directional, Vector3.up, 0f);
            LogAssert.Expect(LogType.Warning, new Regex("Zone.*16 force zones"));
            yield return null;
            yield return null;
        }

        [UnityTest]
        public IEnumerator TheThesisMethodSaysThatItHasNoZones()
        {
            FluidSimulation simulation = Liquid();
            simulation.Method = FluidMethodKind.Thesis;
            Zone(FluidForceKind.Directional, Vector3.up);
            LogAssert.Expect(LogType.Warning, new Regex("has no force zones"));
            yield return Play(simulation, 0.03);
        }
    }
}
