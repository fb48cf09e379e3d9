using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>
    /// Floating Rigidbodies beside what games do with Rigidbodies: interpolation, sleep, scripts, and physics at other times.
    /// </summary>
    public sealed class FloatingScriptsTests
    {
        private const float Spacing = 0.06f;

        private static readonly Vector3 Crate = new Vector3(0.3f, 0.24f, 0.3f);

        private readonly float fixedDelta = Time.fixedDeltaTime;
        private SimulationRig rig;
        private FluidSimulation simulation;
        private Rigidbody crate;

        [SetUp]
        public void Fill()
        {
            rig = new SimulationRig(1f / 60f);
            simulation = rig.Create(liquid: false);
            simulation.DomainSize = new Vector3(10f, 16f, 10f) * Spacing;
            simulation.Spacing = Spacing;
            FluidVolume water = rig.AddVolume(simulation);
            water.Size = new Vector3(10f, 8f, 10f) * Spacing;
            water.transform.localPosition = new Vector3(0f, -4f * Spacing, 0f);
            GameObject box = rig.NewObject("Crate");
            box.AddComponent<BoxCollider>().size = Crate;
            crate = box.AddComponent<Rigidbody>();
            crate.mass = 0.5f * 1000f * Crate.x * Crate.y * Crate.z;
        }

        [TearDown]
        public void Empty()
        {
            Time.fixedDeltaTime = fixedDelta;
            Physics.simulationMode = SimulationMode.FixedUpdate;
            rig.Dispose();
        }

        private sealed class Script : MonoBehaviour
        {
            public Action Act;
            public int Count;

            private void FixedUpdate()
            {
                Count++;
                Act();
            }
        }

        private Script Fixed(Action act)
        {
            Script script = rig.NewObject("Script").AddComponent<Script>();
            script.Act = act;
            return script;
        }

        private IEnumerator Play(float seconds, Action afterFrame = null)
        {
            while (!simulation.IsRunning) yield return null;
            double end = simulation.SimulatedTime + seconds;
            while (simulation.SimulatedTime < end)
            {
                afterFrame?.Invoke();
                yield return null;
            }
        }

        private FloatingState OnTheGpu()
        {
            FloatingBodies bodies = simulation.Solver.State.Bodies.Floating;
            return bodies.ReadNow(bodies.Bodies.Single());
        }

        // Pulled out a little and let go, the crate bobs and rocks; the liquid's own body has second differences of 0.9 and 0.25 mm then.
        [UnityTest]
        public IEnumerator AnInterpolatedBodyIsDrawnWithoutJudder([Values(60, 144)] int rate)
        {
            Time.captureDeltaTime = 1f / rate;
            crate.interpolation = RigidbodyInterpolation.Interpolate;
            crate.transform.SetPositionAndRotation(new Vector3(0f, 0.08f, 0f), Quaternion.Euler(0f, 0f, 6f));
            yield return Play(0.4f);
            var places = new List<Vector3>();
            var turns = new List<Quaternion>();
            yield return Play(0.5f, () =>
            {
                places.Add(crate.transform.position);
                turns.Add(crate.transform.rotation);
            });
            float jerk = 0f, twist = 0f, way = 0f;
            for (int i = 2; i < places.Count; i++)
            {
                jerk = Mathf.Max(jerk, (places[i] - 2f * places[i - 1] + places[i - 2]).magnitude);
                twist = Mathf.Max(twist, (Turn(turns, i) - Turn(turns, i - 1)).magnitude);
                way += (places[i] - places[i - 1]).magnitude;
            }

            string figures = $"{rate} Hz: second difference {1000f * jerk} mm, {1000f * twist} mrad, over {way} m";
            Assert.That(way, Is.GreaterThan(0.01f), "it bobs");
            // The water stops it by up to 1.5 g, which is 4 mm at 60 Hz; a correction that is drawn as a jump is a centimetre.
            Assert.That(jerk, Is.LessThan(rate == 60 ? 0.006f : 0.0015f), figures);
            Assert.That(twist, Is.LessThan(rate == 60 ? 0.012f : 0.006f), figures);
        }

        private static Vector3 Turn(List<Quaternion> turns, int i) => FloatingPose.Turn(turns[i] * Quaternion.Inverse(turns[i - 1]));

        [UnityTest]
        public IEnumerator AScriptThatSetsTheVelocityIsObeyed()
        {
            crate.useGravity = false;
            crate.transform.position = new Vector3(-0.05f, 0.3f, 0f);
            yield return Play(0.1f);
            Script script = Fixed(() =>
            {
#pragma warning disable 618 // linearVelocity in Unity 6
                crate.velocity = new Vector3(0.2f, 0f, 0f);
#pragma warning restore 618
            });
            yield return Play(0.2f); // the liquid's body has it two frames later
            (float from, int count) = (crate.position.x, script.Count);
            yield return Play(0.3f);
            float speed = (crate.position.x - from) / ((script.Count - count) * Time.fixedDeltaTime);
            float gap = (OnTheGpu().Centre - crate.worldCenterOfMass).magnitude;
            Assert.That(speed, Is.EqualTo(0.2f).Within(0.004f));
            Assert.That(gap, Is.LessThan(0.006f));
        }

        // As an engine pushes a boat; above the liquid nothing else acts. Physics steps five times in six frames, whichever it begins with.
        [UnityTest]
        public IEnumerator AForceOfAScriptIsObeyed([Values(0, 1, 2)] int frames)
        {
            crate.transform.position = new Vector3(-0.1f, 0.3f, 0f);
            crate.useGravity = false;
            for (int i = 0; i < frames; i++) yield return null;
            crate.useGravity = true;
            Vector3 push = new Vector3(0.6f, 0.2f, 0f), spin = new Vector3(0f, 1f, 0f);
            Fixed(() =>
            {
                crate.AddForce(push - Physics.gravity, ForceMode.Acceleration);
                crate.AddTorque(spin, ForceMode.Acceleration);
            });
            yield return Play(0.1f);
            Vector3 velocity = crate.GetPointVelocity(crate.worldCenterOfMass), turning = crate.angularVelocity;
            yield return Play(0.4f);
            velocity = crate.GetPointVelocity(crate.worldCenterOfMass) - velocity;
            turning = crate.angularVelocity - turning;
            string figures = $"{velocity} m/s, {turning} rad/s";
            Assert.That((velocity - 0.4f * push).magnitude, Is.LessThan(0.05f), figures);
            Assert.That((turning - 0.4f * spin).magnitude, Is.LessThan(0.02f), figures);
        }

        [UnityTest]
        public IEnumerator APositionThatIsSetOnceIsTakenUp()
        {
            crate.useGravity = false;
            crate.transform.position = new Vector3(-0.05f, 0.3f, 0f);
            yield return Play(0.1f);
            var place = new Vector3(0.05f, 0.25f, 0f);
            bool done = false;
            Fixed(() =>
            {
                if (!done) crate.position = place;
                done = true;
            });
            yield return Play(0.2f);
            Assert.That((crate.position - place).magnitude, Is.LessThan(0.003f));
            Assert.That((OnTheGpu().Centre - crate.worldCenterOfMass).magnitude, Is.LessThan(0.003f));
        }

        // In calm water it sleeps at last, in PhysX and on the GPU; water of another weight against its own wakes it.
        [UnityTest]
        public IEnumerator InCalmWaterABodySleepsUntilTheBalanceChanges()
        {
            yield return Play(0.1f);
            crate.sleepThreshold = 0.1f;
            float waited = 0f;
            while (!crate.IsSleeping() && waited < 8f)
            {
                yield return Play(0.1f);
                waited += 0.1f;
            }

            Vector3 place = crate.position;
            int awake = 0;
            yield return Play(0.3f, () => awake += crate.IsSleeping() ? 0 : 1);
            Assert.That(waited, Is.LessThan(8f));
            Assert.That(awake, Is.Zero, "frames awake");
            Assert.That((crate.position - place).magnitude + OnTheGpu().Velocity.magnitude, Is.Zero);
            Assert.That((OnTheGpu().Centre - crate.worldCenterOfMass).magnitude, Is.LessThan(0.002f));
            crate.mass *= 1.3f;
            yield return Play(0.3f);
            Assert.That(crate.IsSleeping(), Is.False);
            Assert.That(place.y - crate.position.y, Is.GreaterThan(0.008f), "it sinks in");
        }

        [UnityTest]
        public IEnumerator PhysicsMayBeSteppedAtAnyTime([Values("once", "update", "thrice", "seldom", "in pairs")] string how)
        {
            crate.transform.position = new Vector3(0f, 0.02f, 0f);
            Physics.simulationMode = how == "update" ? SimulationMode.Update : SimulationMode.Script;
            Time.captureDeltaTime = how == "seldom" ? 1f / 144f : how == "in pairs" ? 0.03f : 1f / 60f;
            float left = 0f;
            var gaps = new List<float>();
            void Step()
            {
                if (how == "once") Physics.Simulate(Time.deltaTime);
                for (int i = 0; how == "thrice" && i < 3; i++) Physics.Simulate(Time.deltaTime / 3f);
                if (how != "seldom" && how != "in pairs") return;
                for (left += Time.deltaTime; left >= 0.02f; left -= 0.02f) Physics.Simulate(0.02f);
            }

            yield return Play(0.4f, Step);
            yield return Play(0.3f, () =>
            {
                gaps.Add((OnTheGpu().Centre - crate.worldCenterOfMass).magnitude);
                Step();
            });
            Assert.That(gaps.Average(), Is.LessThan(0.02f));
            Assert.That(gaps.Max(), Is.LessThan(0.035f));
        }
    }
}
