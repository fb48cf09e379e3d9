using System.Collections;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Bodies that are tied to each other, stacked and loaded, and one too small: none gets faster than a fall makes it.</summary>
    public sealed class TiedBodiesTests
    {
        private const float Spacing = 0.06f, Edge = 3.1f * Spacing, Floor = -8f * Spacing, Level = -3f * Spacing;

        private readonly float fixedDelta = Time.fixedDeltaTime;
        private readonly List<Rigidbody> bodies = new List<Rigidbody>();
        private SimulationRig rig;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(1f / 60f);
            Time.fixedDeltaTime = Time.captureDeltaTime;
        }

        [TearDown]
        public void TearDown()
        {
            Time.fixedDeltaTime = fixedDelta;
            rig.Dispose();
            bodies.Clear();
        }

        [UnityTest]
        public IEnumerator AChainOfTenALoadedRaftAndAPebbleAreNotThrown()
        {
            FluidSimulation simulation = rig.Create(liquid: false);
            simulation.Spacing = Spacing;
            simulation.DomainSize = new Vector3(38f, 16f, 14f) * Spacing;
            FluidVolume water = rig.AddVolume(simulation);
            water.Size = new Vector3(38f, 5f, 14f) * Spacing;
            water.transform.localPosition = new Vector3(0f, Floor + 2.5f * Spacing, 0f);
            while (!simulation.IsRunning) yield return null;
            for (int i = 0; i < 10; i++)
            {
                Add($"Link {i}", Edge * Vector3.one, 0.5f, new Vector3((3.6f * i - 16.2f) * Spacing, Level + Edge, -4f * Spacing));
            }
            float top = Level + 2f * Spacing;
            Add("Raft", new Vector3(7f, 2f, 6f) * Spacing, 0.3f, new Vector3(0f, top, 3f * Spacing));
            for (int i = 0; i < 3; i++)
            {
                Add($"Load {i}", Edge * Vector3.one, 0.4f, new Vector3(0f, top + Spacing + (i + 0.5f) * Edge, 3f * Spacing));
            }
            Add("Pebble", 0.5f * Spacing * Vector3.one, 0.5f, new Vector3(12f * Spacing, Level + Edge, 3f * Spacing));
            float[] heights = bodies.Select(b => b.position.y - Floor).ToArray(), fastest = new float[bodies.Count];
            LogAssert.Expect(LogType.Warning,
                new Regex(
                    "'Pebble': The body measures 0\\.03 x 0\\.03 x 0\\.03 m.*Particle Spacing of 0\\.06 m.*Use a Particle Spacing of " +
                    "0\\.0"));
            for (int frame = 0; frame < 18; frame++)
            {
                for (int i = 0; i < 9; i++) Tie(bodies[i], bodies[i + 1]);
                yield return null;
                for (int i = 0; i < bodies.Count; i++)
                    if (!(bodies[i].GetPointVelocity(bodies[i].worldCenterOfMass).magnitude <= fastest[i]))
                    {
                        fastest[i] = bodies[i].GetPointVelocity(bodies[i].worldCenterOfMass).magnitude;
                    }
            }
            string figures = string.Join(", ",
                bodies.Select((b, i) => $"{b.name} {fastest[i] / Mathf.Sqrt(2f * 9.81f * heights[i]):f2} at {b.position}"));
            TestContext.Out.WriteLine(figures);
            for (int i = 0; i < bodies.Count; i++)
            {
                Assert.That(fastest[i], Is.LessThan(1.5f * Mathf.Sqrt(2f * 9.81f * heights[i])), figures);
            }
            Assert.That(simulation.Messages.Count(m => m.Issue == FluidIssue.BodyTooSmall), Is.EqualTo(1));
            Assert.That(simulation.Solver.Counters.NonFinite, Is.Zero);
        }

        private void Add(string name, Vector3 size, float ratio, Vector3 at)
        {
            GameObject part = rig.NewObject(name);
            part.transform.position = at;
            part.AddComponent<BoxCollider>().size = size;
            Rigidbody body = part.AddComponent<Rigidbody>();
            body.mass = ratio * 1000f * size.x * size.y * size.z;
            bodies.Add(body);
        }

        // A joint with some give: as stiff as steps of 1/60 s take.
        private static void Tie(Rigidbody a, Rigidbody b)
        {
            Vector3 between = b.position - a.position, approach = b.GetPointVelocity(b.worldCenterOfMass) -
                a.GetPointVelocity(a.worldCenterOfMass);
            Vector3 force =
                a.mass * (330f * (between.magnitude - 3.6f * Spacing) * between.normalized + 10f * Vector3.Project(approach, between));
            a.AddForce(force);
            b.AddForce(-force);
        }
    }
}
