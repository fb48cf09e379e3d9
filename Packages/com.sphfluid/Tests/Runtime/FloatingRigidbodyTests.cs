using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Rigidbodies in a pool: the liquid moves them, the scene's physics follows.</summary>
    public sealed class FloatingRigidbodyTests
    {
        private const float Spacing = 0.06f;

        private static readonly Vector3 Crate = new Vector3(0.45f, 0.3f, 0.45f);

        private readonly float fixedDelta = Time.fixedDeltaTime;
        private SimulationRig rig;
        private FluidSimulation simulation;
        private FluidVolume water;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(1f / 60f);
            Time.fixedDeltaTime = Time.captureDeltaTime; // a physics step a frame: places are of the same time
            simulation = rig.Create(liquid: false);
            simulation.Spacing = Spacing;
            water = rig.AddVolume(simulation);
            water.transform.localPosition = new Vector3(0f, -4f * Spacing, 0f);
            Fill(13f);
        }

        private void Fill(float across)
        {
            simulation.DomainSize = new Vector3(across, 16f, across) * Spacing;
            water.Size = new Vector3(across, 8f, across) * Spacing;
        }

        [TearDown]
        public void Empty()
        {
            Time.fixedDeltaTime = fixedDelta;
            rig.Dispose();
        }

        private Rigidbody AddCrate(float ratio, float height, float turn = 5f)
        {
            GameObject crate = rig.NewObject("Crate");
            crate.transform.SetPositionAndRotation(new Vector3(0f, height, 0f), Quaternion.Euler(turn, 0f, 0f));
            crate.AddComponent<BoxCollider>().size = Crate;
            Rigidbody body = crate.AddComponent<Rigidbody>();
            body.mass = ratio * 1000f * Crate.x * Crate.y * Crate.z;
            return body;
        }

        private IEnumerator Play(float seconds)
        {
            while (!simulation.IsRunning) yield return null;
            double end = simulation.SimulatedTime + seconds;
            while (simulation.SimulatedTime < end) yield return null;
        }

        private FloatingState OnTheGpu()
        {
            FloatingBodies bodies = simulation.Solver.State.Bodies.Floating;
            return bodies.ReadNow(bodies.Bodies.Single());
        }

        [UnityTest]
        public IEnumerator ACrateFloatsAndTheRigidbodyIsWhereTheLiquidHasIt([Values(0.5f)] float ratio)
        {
            Rigidbody crate = AddCrate(ratio, (0.5f - ratio + 0.05f) * Crate.y);
            yield return Play(1f);
            var gaps = new List<float>();
            var heights = new List<float>();
            for (int frame = 0; frame < 20; frame++)
            {
                gaps.Add((OnTheGpu().Centre - crate.worldCenterOfMass).magnitude);
                heights.Add(crate.position.y);
                yield return null;
            }

            // The crate lifts the water by what it displaces of it.
            float volume = SimulationRig.Read(simulation).Length * Mathf.Pow(Spacing, 3f) + ratio * Crate.x * Crate.y * Crate.z;
            float level = volume / (simulation.DomainSize.x * simulation.DomainSize.z) - 0.5f * simulation.DomainSize.y;
            float draught = (level - heights.Average() + 0.5f * Crate.y) / Crate.y;
            string figures =
                $"draught {draught}, largest gap {gaps.Max()} m, at {crate.position}, tilt {Vector3.Angle(crate.transform.up, Vector3.up)}";
            Assert.That(draught, Is.EqualTo(ratio).Within(0.3f * Spacing / Crate.y), figures);
            Assert.That(gaps.Max(), Is.LessThan(0.02f * Crate.y), figures);
            Assert.That(Vector3.Angle(crate.transform.up, Vector3.up), Is.LessThan(8f), figures);
            FluidCounters counters = simulation.Solver.Counters;
            Assert.That(counters.Squeezed + counters.NonFinite + counters.ImpulseLimits + counters.DomainClamps, Is.Zero);
        }

        // The forces that PhysX gets are late by that much more; the liquid and its body do not know.
        [UnityTest]
        public IEnumerator TheAgeOfTheReadBackDoesNotChangeTheLiquidsBody()
        {
            var found = new List<FloatingState>();
            foreach (int age in new[] { 1, 4 })
            {
                Rigidbody crate = AddCrate(0.25f, 0.1f);
                crate.isKinematic = true;
                simulation.StopSimulation();
                simulation.StartSimulation();
                yield return null;
                while (!simulation.IsRunning || simulation.Solver.StepCount < 8) yield return null;
                simulation.Solver.State.Bodies.Floating.Readback.Age = age;
                crate.isKinematic = false;
                yield return Play(0.3f);
                found.Add(OnTheGpu());
                Object.DestroyImmediate(crate.gameObject);
            }

            Assert.That(found[0].Velocity.magnitude, Is.GreaterThan(0.01f));
            foreach (FloatingState later in found)
            {
                Assert.That((later.Centre - found[0].Centre).magnitude, Is.LessThan(1e-6f));
                Assert.That((later.Velocity - found[0].Velocity).magnitude, Is.LessThan(1e-4f));
            }
        }

        [UnityTest]
        public IEnumerator AHeavyCrateSinksToTheFloorOfTheScene()
        {
            GameObject floor = rig.NewObject("Floor");
            floor.AddComponent<BoxCollider>().size = new Vector3(2f, 0.2f, 2f);
            floor.transform.position = new Vector3(0f, -0.5f * simulation.DomainSize.y - 0.06f, 0f); // its top 4 cm above the domain's
            Fill(16f); // what it displaces gets away
            Rigidbody crate = AddCrate(2f, 0f, 0f);
            yield return Play(0.9f);
            float top = floor.transform.position.y + 0.1f;
            var gaps = new List<float>();
            for (int frame = 0; frame < 20; frame++)
            {
                yield return null;
                gaps.Add((OnTheGpu().Centre - crate.worldCenterOfMass).magnitude);
                Assert.That(crate.position.y - 0.5f * Crate.y, Is.InRange(top - 0.003f, top + 0.5f * Spacing),
                    "on the floor, or on a film of water that cannot get away");
            }
            // The floor is PhysX's: the liquid's body is held by what PhysX refuses, some frames late, in which half of
            // its weight moves it: 0.5 (g / 2) (4 / 60 s)^2 = 11 mm at most.
            Assert.That(gaps.Average(), Is.LessThan(0.1f * Spacing));
            Assert.That(gaps.Max(), Is.LessThan(0.2f * Spacing));
        }

        [UnityTest]
        public IEnumerator WhatIsKinematicOrOptsOutGoesWhereTheSceneHasIt([Values] bool kinematic)
        {
            Rigidbody crate = AddCrate(0.3f, 0f);
            crate.useGravity = false;
            if (kinematic) crate.isKinematic = true;
            else crate.gameObject.AddComponent<FluidCollider>().MovedByLiquid = false;
            yield return Play(0.2f);
            Assert.That(crate.position, Is.EqualTo(Vector3.zero));
            Assert.That(simulation.Solver.State.HasFloatingBodies, Is.False);
            crate.isKinematic = false;
            if (!kinematic) crate.GetComponent<FluidCollider>().MovedByLiquid = true;
            yield return Play(0.3f);
            Assert.That(crate.position.y, Is.GreaterThan(0.02f), "it comes up");
        }

        [UnityTest]
        public IEnumerator AScriptsForceReachesTheBodyInTheLiquid()
        {
            Rigidbody crate = AddCrate(0.5f, 0f, 0f);
            crate.constraints = RigidbodyConstraints.FreezeRotation | RigidbodyConstraints.FreezePositionY |
                RigidbodyConstraints.FreezePositionZ;
            yield return Play(0.2f);
            for (int frame = 0; frame < 12; frame++)
            {
                crate.AddForce(new Vector3(2f * crate.mass, 0f, 0f)); // 2 m/s^2
                yield return null;
            }

            FloatingState state = OnTheGpu();
            Assert.That(state.Centre.x, Is.GreaterThan(0.005f));
            Assert.That(state.Centre.y, Is.EqualTo(0f).Within(1e-4f));
            Assert.That((state.Centre - crate.worldCenterOfMass).magnitude, Is.LessThan(0.01f));
        }

        [UnityTest]
        public IEnumerator ABodyThatIsPutElsewhereOrLeavesIsFollowed()
        {
            Rigidbody crate = AddCrate(0.5f, 0.3f);
            yield return Play(0.2f);
            crate.position = new Vector3(0.1f, 0.35f, 0f);
            yield return Play(0.1f);
            Assert.That((OnTheGpu().Centre - crate.worldCenterOfMass).magnitude, Is.LessThan(0.04f), "it falls into the water");
            crate.position = new Vector3(0f, 50f, 0f);
            yield return Play(0.1f);
            Assert.That(simulation.Solver.State.HasFloatingBodies, Is.False);
            Object.DestroyImmediate(crate.gameObject);
            yield return Play(0.05f);
            Assert.That(simulation.IsRunning, Is.True);
        }
    }
}
