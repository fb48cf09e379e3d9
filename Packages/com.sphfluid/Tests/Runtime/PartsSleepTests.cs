using System;
using System.Collections;
using System.IO;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>
    /// A long pool that a box stirs at its left end: the rest of it sleeps and wakes where something happens.
    /// </summary>
    public sealed class PartsSleepTests
    {
        private const float Spacing = 0.05f;
        private static readonly Vector3Int Layers = new Vector3Int(63, 6, 6);

        // m/s, that gravity gives over a spacing.
        private static readonly float Unit = Mathf.Sqrt(9.81f * Spacing);

        private SimulationRig rig;
        private FluidSimulation simulation;
        private Transform stirrer;
        private Mesh mesh;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(1f / 60f);
            simulation = rig.Create(liquid: false);
            simulation.Spacing = Spacing;
            simulation.DomainSize = Spacing * (Vector3)(Layers + 6 * Vector3Int.up);
            simulation.PartsSleep = true;
            FluidVolume pool = rig.AddVolume(simulation, "Pool");
            pool.Size = Spacing * (Vector3)Layers;
            pool.transform.localPosition = 3f * Spacing * Vector3.down;
            GameObject box = rig.NewObject("Stirrer");
            box.AddComponent<BoxCollider>().size = 3f * Spacing * Vector3.one;
            stirrer = box.transform;
            Stir();
        }

        [TearDown]
        public void TearDown()
        {
            rig.Dispose();
            UnityEngine.Object.DestroyImmediate(mesh);
        }

        [UnityTest]
        public IEnumerator WhatRestsStaysAndWakesWhereSomethingHappens()
        {
            yield return UntilFarEndSleeps();
            FluidParticle[] before = SimulationRig.Read(simulation);
            long steps = simulation.StepCount;
            for (int frame = 0; frame < 5; frame++) yield return Frame();
            FluidParticle[] after = SimulationRig.Read(simulation);
            int stayed = before.Zip(after, (a, b) => a.Position == b.Position ? 1 : 0).Sum();
            Assert.That(simulation.IsAsleep, Is.False);
            Assert.That(simulation.StepCount, Is.GreaterThan(steps));
            Assert.That(simulation.AsleepShare, Is.EqualTo(stayed / (float)before.Length).Within(0.15f), "as of some frames ago");
            Assert.That(before.Length - stayed, Is.GreaterThan(before.Length / 10), "the stirred end goes on");
            Bounds[] asleep = simulation.Solver.State.ReadSleepers().ToArray();
            Assert.That(asleep.Any(b => b.Contains(FarEnd)) && !asleep.Any(b => b.Contains(stirrer.position)), "as gizmos show it");

            FluidQuery within = simulation.Queries.AddPoint(FarEnd);
            for (int frame = 0; frame < 3; frame++) yield return Frame();
            simulation.Queries.Complete();
            Assert.That(simulation.Queries.TryGet(within, out FluidPointResult asked) && asked.IsWet, "what sleeps answers");
            Assert.That(asked.Density, Is.EqualTo(1000f).Within(50f));
            Assert.That(asked.Velocity, Is.EqualTo(Vector3.zero));
            simulation.Queries.Remove(within);

            GameObject wader = rig.NewObject("Wader");
            wader.transform.localScale = 2f * Spacing * Vector3.one;
            wader.AddComponent<MeshCollider>().sharedMesh = mesh = TestMeshes.Cube();
            wader.transform.position = FarEnd + 6f * Spacing * Vector3.up;
            yield return UntilFarEndSleeps();
            foreach ((string what, int frames, Action happens) in Happenings(wader.transform))
            {
                float fastest = 0f;
                happens();
                for (int frame = 0; frame < frames; frame++)
                {
                    yield return Frame();
                    fastest = Mathf.Max(fastest, SimulationRig.Read(simulation).Where(IsFar).Max(p => p.VelT0.magnitude));
                }
                Assert.That(fastest, Is.GreaterThan(0f), what);
                yield return UntilFarEndSleeps();
            }
        }

        [UnityTest]
        public IEnumerator WakingJoltsNothingAndGivesNoEnergy()
        {
            yield return UntilFarEndSleeps();
            double energy = Energy();
            simulation.Wake();
            float fastest = 0f;
            double most = double.MinValue;
            for (int frame = 0; frame < 12; frame++)
            {
                yield return null; // the stirrer rests
                fastest = Mathf.Max(fastest, SimulationRig.Read(simulation).Where(IsFar).Max(p => p.VelT0.magnitude));
                most = Math.Max(most, Energy());
            }
            Assert.That(fastest, Is.GreaterThan(0f).And.LessThan(0.3f * Unit), "m/s");
            Assert.That(most - energy, Is.LessThan(5e-3 * 9.81 * Spacing), "J/kg: what its pressure held");
        }

        // A speed of sound that rises is for what moves: what slept would burst.
        [UnityTest]
        public IEnumerator WakingWhileTheSpeedOfSoundRisesJoltsNothing()
        {
            yield return UntilFarEndSleeps();
            float sound = simulation.Solver.Settings.SoundSpeed, fastest = 0f, highest = 0f;
            Transform fan = rig.NewObject("Fan").transform; // in the air at the other end
            fan.gameObject.AddComponent<BoxCollider>().size = Spacing * Vector3.one;
            for (int frame = 0; frame < 24; frame++)
            {
                fan.position = Spacing * new Vector3(-0.5f * Layers.x + 5f, 4f + 0.7f * Mathf.Sin(frame), 0f);
                if (frame == 12) simulation.AddImpulse(FarEnd, 0.1f, 1e-4f * Vector3.up);
                yield return Frame();
                fastest = Mathf.Max(fastest, SimulationRig.Read(simulation).Where(IsFar).Max(p => p.VelT0.magnitude));
                highest = Mathf.Max(highest, simulation.Solver.Settings.SoundSpeed);
            }
            Assert.That(highest, Is.GreaterThan(1.3f * sound), "m/s");
            Assert.That(fastest, Is.GreaterThan(0f).And.LessThan(0.4f * Unit), "m/s");
        }

        [UnityTest]
        public IEnumerator ASaveOfLiquidThatSleepsInPartsGoesOnAlike()
        {
            yield return UntilFarEndSleeps();
            using (var save = new MemoryStream())
            {
                simulation.Save(save);
                var ends = new FluidParticle[2][];
                for (int turn = 0; turn < 2; turn++)
                {
                    if (turn == 1)
                    {
                        save.Position = 0;
                        Assert.That(simulation.Restore(save), Is.True);
                    }
                    for (int frame = 0; frame < 75; frame++) yield return null; // it wakes with a save, and falls asleep again
                    ends[turn] = SimulationRig.Read(simulation);
                    Assert.That(simulation.AsleepShare, Is.GreaterThan(0.1f));
                }
                Assert.That(ends[1], Is.EqualTo(ends[0]), "bit by bit");
            }
        }

        [UnityTest]
        public IEnumerator WhatKeepsAllAwakeIsSaid()
        {
            simulation.Method = FluidMethodKind.Robust;
            while (!simulation.IsRunning) yield return null;
            Assert.That(simulation.Messages.Single(m => m.Issue == FluidIssue.PartsStayAwake).Text, Does.Contain("Robust"));
            simulation.Method = FluidMethodKind.Standard;
            rig.Profile.KinematicViscosity = 1f;
            simulation.StartSimulation();
            Assert.That(simulation.Messages.Single(m => m.Issue == FluidIssue.PartsStayAwake).Text, Does.Contain("viscosity"));
            rig.Profile.KinematicViscosity = 1e-6f;
            simulation.SleepsAtRest = false;
            simulation.StartSimulation();
            Assert.That(simulation.Messages.Single(m => m.Issue == FluidIssue.PartsStayAwake).Text, Does.Contain("Sleeps At Rest"));
            simulation.SleepsAtRest = true;
            simulation.StartSimulation();
            Assert.That(simulation.Messages.Where(m => m.Issue == FluidIssue.PartsStayAwake), Is.Empty);
        }

        private static Vector3 FarEnd => new Vector3(0.5f * Layers.x - 8f, -4f, 0f) * Spacing;

        private static bool IsFar(FluidParticle particle) => particle.Position.x > (0.5f * Layers.x - 12f) * Spacing;

        private (string, int, Action)[] Happenings(Transform wader) => new (string, int, Action)[]
        {
            ("an impulse", 1, () => simulation.AddImpulse(FarEnd, 0.2f, 0.2f * Vector3.up)),
            ("liquid goes", 4, () => simulation.RemoveLiquid(FarEnd, 0.1f)),
            ("liquid comes", 20, () =>
                simulation.AddLiquid(FarEnd + 5f * Spacing * Vector3.up, 2f * Spacing * Vector3.one, Quaternion.identity)),
            ("a collider comes", 4, () => wader.position = FarEnd),
            ("a collider deforms", 4, StretchUp),
            ("a collider goes", 4, () => wader.gameObject.SetActive(false)),
        };

        private void StretchUp()
        {
            mesh.vertices = mesh.vertices.Select(corner => corner.y > 0f ? corner + 0.2f * Vector3.up : corner).ToArray();
            mesh.RecalculateBounds();
        }

        private double Energy() =>
            SimulationRig.Read(simulation).Average(p => 0.5 * p.VelT0.sqrMagnitude + 9.81 * p.Position.y);

        private IEnumerator UntilFarEndSleeps()
        {
            for (double end = simulation.SimulatedTime + 12.0; simulation.SimulatedTime < end;)
            {
                for (int frame = 0; frame < 4; frame++) yield return Frame();
                if (simulation.AsleepShare < 0.25f) continue;
                if (SimulationRig.Read(simulation).Where(IsFar).All(p => p.VelT0 == Vector3.zero)) yield break;
            }
            Assert.Fail($"the far end is awake at {simulation.SimulatedTime} s");
        }

        private object Frame()
        {
            Stir();
            return null;
        }

        private void Stir() => stirrer.position = Spacing *
            new Vector3(-0.5f * Layers.x + 5f, -1f + 0.6f * Mathf.Sin(5f * (float)simulation.SimulatedTime), 0f);
    }
}
