using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Loads on a raft, and physics at 50 Hz among frames of 60.</summary>
    public sealed class FloatingStackTests
    {
        private const float Spacing = 0.06f;

        private static readonly Vector3 Deck = new Vector3(0.54f, 0.18f, 0.54f);

        private SimulationRig rig;
        private FluidSimulation simulation;
        private Rigidbody raft;

        [SetUp]
        public void Fill()
        {
            rig = new SimulationRig(1f / 60f);
            simulation = rig.Create(liquid: false);
            simulation.DomainSize = new Vector3(13f, 16f, 13f) * Spacing;
            simulation.Spacing = Spacing;
            FluidVolume water = rig.AddVolume(simulation);
            water.Size = new Vector3(13f, 6f, 13f) * Spacing;
            water.transform.localPosition = new Vector3(0f, -5f * Spacing, 0f);
        }

        // Where it floats with what it will bear, on the second of its colliders.
        private void AddRaft(float mass, float load)
        {
            Vector3 half = new Vector3(Deck.x, 0.5f * Deck.y, Deck.z), up = 0.25f * Deck.y * Vector3.up;
            raft = Add("Raft", half, mass, new Vector3(0f, -2f * Spacing + 0.5f * Deck.y - 1e-3f * (mass + load) / (Deck.x * Deck.z), 0f));
            raft.GetComponent<BoxCollider>().center = -up;
            BoxCollider deck = raft.gameObject.AddComponent<BoxCollider>();
            (deck.size, deck.center) = (half, up);
        }

        [TearDown]
        public void Empty() => rig.Dispose();

        private Rigidbody Add(string name, Vector3 size, float mass, Vector3 at)
        {
            GameObject part = rig.NewObject(name);
            part.transform.position = at;
            part.AddComponent<BoxCollider>().size = size;
            Rigidbody body = part.AddComponent<Rigidbody>();
            body.mass = mass;
            return body;
        }

        private Rigidbody AddLoad(float mass)
        {
            Vector3 size = 0.2f * Vector3.one;
            return Add("Load", size, mass, raft.position + new Vector3(0f, 0.5f * (Deck.y + size.y), 0f));
        }

        private IEnumerator Play(float seconds, Action afterFrame = null)
        {
            while (!simulation.IsRunning) yield return null;
            double end = simulation.SimulatedTime + seconds;
            while (simulation.SimulatedTime < end)
            {
                yield return null;
                afterFrame?.Invoke();
            }
        }

        // Of the raft's centre where it bears a mass in all, below the level that it raises itself.
        private float HeightWith(float mass)
        {
            float level = (SimulationRig.Read(simulation).Length * Mathf.Pow(Spacing, 3f) + 1e-3f * mass) /
                (simulation.DomainSize.x * simulation.DomainSize.z);
            return level - 0.5f * simulation.DomainSize.y - 1e-3f * mass / (Deck.x * Deck.z) + 0.5f * Deck.y;
        }

        // Mass of the load and age of the read-back. A light load by the newest strays least.
        private static readonly (float Mass, int Age)[] loads = { (8f, 4), (16f, 1), (16f, 4) };

        // The raft weighs 4 kg. It bobs in what its fall leaves of waves, as one body of the whole mass does: by up to 0.02 m.
        [UnityTest]
        public IEnumerator ALoadStaysOnItsRaft([ValueSource(nameof(loads))] (float Mass, int Age) of)
        {
            (float mass, int age) = of;
            AddRaft(4f, mass);
            Rigidbody load = AddLoad(mass);
            Vector3 placed = load.position - raft.position;
            float strayed = 0f;
            void See() =>
                strayed = Mathf.Max(strayed, (Quaternion.Inverse(raft.rotation) * (load.position - raft.position) - placed).magnitude);
            while (!simulation.IsRunning) yield return null;
            simulation.Solver.State.Bodies.Floating.Readback.Age = age;
            yield return Play(1f, See);
            float height = HeightWith(4f + mass), off = 0f;
            yield return Play(0.4f, () =>
            {
                See();
                off = Mathf.Max(off, Mathf.Abs(raft.position.y - height));
            });
            string figures = $"strayed by {strayed} m, {off} m off its height";
            TestContext.Out.WriteLine(figures);
            Assert.That(strayed, Is.LessThan(0.02f * Spacing), figures);
            Assert.That(off, Is.LessThan(0.8f * Spacing), figures);
        }

        // Physics steps five times in six frames: whichever of them the hoist begins in, the load goes up with 2 m/s².
        private sealed class Hoist : MonoBehaviour
        {
            private Rigidbody load;

            private void Awake() => load = GetComponent<Rigidbody>();

            private void FixedUpdate() => load.AddForce(load.mass * (-Physics.gravity + new Vector3(0f, 2f, 0f)));
        }

        [UnityTest]
        public IEnumerator ALoadThatIsLiftedLeavesItsRaft([Values(0, 3)] int frames)
        {
            AddRaft(4f, 8f);
            Rigidbody load = AddLoad(8f);
            yield return Play(0.3f);
            for (int i = 0; i < frames; i++) yield return null;
            load.gameObject.AddComponent<Hoist>();
            float fastest = 0f;
            yield return Play(0.9f, () =>
            {
                fastest = Mathf.Max(fastest, raft.GetPointVelocity(raft.worldCenterOfMass).magnitude);
            });
            string figures = $"raft at {raft.position.y} of {HeightWith(4f)}, fastest {fastest} m/s, load at {load.position.y}";
            TestContext.Out.WriteLine(figures);
            Assert.That(load.position.y - raft.position.y, Is.GreaterThan(0.4f), figures); // 0.19 m where it lies
            Assert.That(fastest, Is.LessThan(2.3f), figures); // twice what the freed raft rises with, √(ρ g A/m) of its way up
            Assert.That(raft.position.y, Is.EqualTo(HeightWith(4f)).Within(0.6f * Spacing), figures);
        }

        [UnityTest]
        public IEnumerator ARaftAndItsLoadSleepAndWakeTogether()
        {
            AddRaft(4f, 8f);
            Rigidbody load = AddLoad(8f);
            raft.sleepThreshold = load.sleepThreshold = 0.4f;
            for (int tenths = 0; tenths < 60 && !raft.IsSleeping(); tenths++)
            {
                yield return Play(0.1f);
                Assert.That(load.IsSleeping(), Is.EqualTo(raft.IsSleeping()));
            }

            Vector3 place = load.position;
            yield return Play(0.2f);
            Assert.That(raft.IsSleeping() && load.IsSleeping(), Is.True);
            Assert.That(load.position, Is.EqualTo(place));
            load.WakeUp();
            yield return Play(0.1f);
            Assert.That(raft.IsSleeping() || load.IsSleeping(), Is.False);
            yield return Play(0.2f);
            Assert.That((load.position - place).magnitude, Is.LessThan(0.1f * Spacing));
        }
    }
}
