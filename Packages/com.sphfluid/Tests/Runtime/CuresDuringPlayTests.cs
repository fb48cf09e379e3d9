using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>
    /// Each cure that a message during play proposes is tried: a liquid that has it from the start is not told again, nor told anything
    /// else.
    /// </summary>
    public sealed class CuresDuringPlayTests
    {
        private const string Number = @"([0-9][0-9.,E-]*[0-9]|[0-9])";

        private SimulationRig rig;
        private FluidSimulation simulation;
        private FluidVolume volume;
        private GameObject other;
        private Action<int> each;
        private float said, saidStep, gap, height;
        private int wait;

        private static readonly (string name, int frames, string says, Action<CuresDuringPlayTests> cause,
            (string words, Action<CuresDuringPlayTests> apply)[] cures)[] Cases =
        {
            ("substeps by rule", 40, "needs .* steps",
                t => (Time.captureDeltaTime, t.simulation.MaxSubstepsPerFrame, t.rig.Profile.SoundSpeedMode) =
                    (0.02f, 3, FluidSoundSpeedMode.FixedByRule), Cures(
                ("Raise Max Substeps Per Frame", t => t.simulation.MaxSubstepsPerFrame = 1000),
                ("larger Particle Spacing", t => t.simulation.Spacing = 0.1f),
                ("half of it, by Sound Speed Ratio", t => t.rig.Profile.SoundSpeedRatio = 2.5f))),
            ("substeps of a fixed step", 60, "needs .* steps", t => { t.Fix(0.001f); t.simulation.MaxSubstepsPerFrame = 5; }, Cures(
                ("Raise Max Substeps Per Frame", t => t.simulation.MaxSubstepsPerFrame = 1000),
                ("or Fixed Time Step", t => t.simulation.FixedTimeStep = 0.002f))),
            ("substeps of Robust", 10, "needs .* steps",
                t => (t.simulation.Method, Time.captureDeltaTime, t.simulation.MaxSubstepsPerFrame) = (FluidMethodKind.Robust, 0.1f, 4),
                Cures(
                ("Raise Max Substeps Per Frame", t => t.simulation.MaxSubstepsPerFrame = 1000),
                ("lower the profile's Substeps", t => t.rig.Profile.Substeps = 1))),
            ("colliders that close", 30, "had no place between", t => t.Press(),
                Cures(("a spacing apart, and leave the liquid a way out", t => (t.gap, t.height) = (0.06f, 0.1f)))),
            ("a collider that jumps", 8, "moved too far within a frame", t => t.Jump(), Cures(
                ("over more frames", t => t.gap = 3f),
                ("reset the simulation after it was moved", t => t.wait = 1))),
            ("full", 30, "as many as it may have", t => t.Full(), Cures(
                ("Raise Capacity", t => t.simulation.Capacity = 1000),
                ("Max Particles in the profile", t => (t.simulation.Capacity, t.rig.Profile.MaxParticles) = (0, 1000)),
                ("add a Fluid Drain", t => t.Child<FluidDrain>(Vector3.zero).Size = 0.4f * Vector3.one),
                ("Recycle Oldest", t => t.simulation.CapacityPolicy = FluidCapacityPolicy.RecycleOldest))),
            ("a drowned nozzle", 20, "finds no place", t => t.Nozzle(Vector3.zero, 0.5f), Cures(
                ("Raise the nozzle out of the liquid", t => t.other.transform.localPosition = 0.15f * Vector3.up),
                ("switch Under Water on", t => t.other.GetComponent<FluidEmitter>().UnderWater = true))),
            ("a nozzle outside", 20, "finds no place", t => t.Nozzle(new Vector3(0.19f, 0.15f, 0f), 2f).Size = new Vector2(0.2f, 0.1f),
                Cures(("move it into the domain", t => t.other.transform.localPosition = 0.15f * Vector3.up))),
            ("a fast nozzle", 5, $"more than a quarter of the speed of sound.*Expected Speed to {Number} m/s", t => t.Gush(), Cures(
                ("use a larger Size", t => t.other.GetComponent<FluidEmitter>().Size = 0.3f * Vector2.one),
                ("less flow", t => t.gap = 0.01f),
                ("Expected Speed", t => t.simulation.ExpectedSpeed = t.said))),
            ("a fast zone", 10, $"can bring the liquid .*Expected Speed to {Number} m/s", t => t.Zone(60f), Cures(
                ("Expected Speed", t => t.simulation.ExpectedSpeed = t.said),
                ("less strength", t => t.other.GetComponent<FluidForceZone>().Strength = 1f),
                ("or size", t => t.other.GetComponent<FluidForceZone>().Size = 0.01f * Vector3.one))),
            ("a strong zone", 10, $"tears the liquid .*Expected Speed to {Number} m/s", t => t.Zone(5000f), Cures(
                ("use less strength", t => t.other.GetComponent<FluidForceZone>().Strength = 1f),
                ("Expected Speed", t => t.simulation.ExpectedSpeed = t.said))),
            ("a strong zone with a fixed step", 10, $"tears the liquid .*Expected Speed to {Number} m/s and Fixed Time Step to {Number} s",
                t => { t.Fix(0.0002f); t.Zone(9000f); }, Cures(
                ("Expected Speed", t => (t.simulation.ExpectedSpeed, t.simulation.FixedTimeStep) = (t.said, t.saidStep)))),
            ("a fast zone with a fixed step", 10,
                $"can bring the liquid .*Expected Speed to {Number} m/s and Fixed Time Step to {Number} s", t =>
                {
                    t.Fix(0.003f);
                    t.Zone(100f);
                }, Cures(
                ("Expected Speed", t => (t.simulation.ExpectedSpeed, t.simulation.FixedTimeStep) = (t.said, t.saidStep)))),
            ("negative time", 3, "Time Scale is", t => t.simulation.TimeScale = -1f,
                Cures(("Time Scale to 0 or more", t => t.simulation.TimeScale = 1f))),
            ("relaxed Robust", 3, "Start Relaxation needs", t => t.Relax(), Cures(
                ("Start Relaxation to None", t => t.simulation.StartRelaxation = FluidStartRelaxation.None),
                ("use the method Standard", t => t.simulation.Method = FluidMethodKind.Standard))),
            ("pressed by a load", 30, $"compressed by .*Expected Speed to {Number} m/s", t => t.Piston(),
                Cures(("Expected Speed", t => t.simulation.ExpectedSpeed = t.said))),
            ("squeezed", 30, "leave it the room that it fills", t => t.Squeeze(),
                Cures(("leave it the room that it fills", t => t.gap = 0.2f))),
            ("diagnosed: fast", 16, $"spacings a step.*Expected Speed to {Number} m/s", t => t.Shoot(), Cures(
                ("Expected Speed", t => t.simulation.ExpectedSpeed = t.said),
                ("Time Step Mode to Adaptive", t => t.simulation.TimeStepMode = FluidTimeStepMode.Adaptive),
                ("lower the profile's Time Step Fraction", t => t.rig.Profile.TimeStepFraction = 0.2f))),
            ("diagnosed: fast with a fixed step", 12, "spacings a step", t =>
            {
                t.Shoot();
                t.Fix(0.004f);
            }, Cures(("shorten Fixed Time Step", t => t.simulation.FixedTimeStep = 0.001f))),
        };

        private static IEnumerable<string> All => Cases.SelectMany(c => c.cures.Select(cure => $"{c.name}: {cure.words}"));

        [SetUp]
        public void SetUp() => LogAssert.ignoreFailingMessages = true;

        [TearDown]
        public void TearDown()
        {
            LogAssert.ignoreFailingMessages = false;
            rig?.Dispose();
        }

        [UnityTest]
        public IEnumerator TheCureCures([ValueSource(nameof(All))] string which)
        {
            var (name, frames, says, cause, cures) = Cases.Single(c => c.cures.Any(cure => $"{c.name}: {cure.words}" == which));
            (string words, Action<CuresDuringPlayTests> apply) = cures.Single(cure => $"{name}: {cure.words}" == which);
            string message = null;
            foreach (bool cured in new[] { false, true })
            {
                rig = new SimulationRig();
                simulation = rig.Create(liquid: false);
                volume = rig.AddVolume(simulation);
                (each, gap, height, wait) = (null, 0f, 0.5f, 0);
                cause(this);
                if (cured) apply(this);
                yield return null;
                for (int frame = 0; frame < frames; frame++)
                {
                    each?.Invoke(frame);
                    yield return null;
                }
                string[] all = simulation.Messages.Where(m => m.Severity != FluidSeverity.Info).Select(m => m.ToString()).ToArray();
                TestContext.WriteLine(string.Join(" | ", all));
                // The pipe of a pump takes the place of liquid in a tank this small.
                if (cured) Assert.That(all.Where(m => !m.Contains("the last one 'FluidEmitter'")), Is.Empty, message);
                else
                {
                    message = all.FirstOrDefault(m => Regex.IsMatch(m, says));
                    Assert.That(message, Is.Not.Null, $"'{says}'");
                    Assert.That(message, Does.Contain(words));
                    GroupCollection numbers = Regex.Match(message, says).Groups;
                    if (numbers.Count > 1) said = float.Parse(numbers[1].Value, CultureInfo.InvariantCulture);
                    if (numbers.Count > 2) saidStep = float.Parse(numbers[2].Value, CultureInfo.InvariantCulture);
                }
                rig.Dispose();
            }
        }

        private static (string, Action<CuresDuringPlayTests>)[] Cures(params (string, Action<CuresDuringPlayTests>)[] cures) => cures;

        private void Fix(float step) => (simulation.TimeStepMode, simulation.FixedTimeStep) = (FluidTimeStepMode.Fixed, step);

        private GameObject Box(string name, Vector3 place, Vector3 size)
        {
            other = rig.NewObject(name);
            other.transform.position = place;
            other.AddComponent<BoxCollider>().size = size;
            return other;
        }

        private void Press()
        {
            Transform press = Box("Press", new Vector3(-0.14f, 0f, 0f), Vector3.one).transform,
                anvil = Box("Anvil", new Vector3(0.12f, 0f, 0f), Vector3.one).transform;
            each = _ =>
            {
                press.localScale = anvil.localScale = new Vector3(0.04f, height, height);
                if (anvil.position.x - press.position.x > 0.04f + gap) press.position += 0.012f * Vector3.right;
            };
            each(0);
        }

        // Gap: how far it goes in a frame.
        private void Jump()
        {
            simulation.DomainSize = new Vector3(20f, 0.4f, 0.4f);
            gap = 18f;
            Transform block = Box("Block", new Vector3(-9f, 0.1f, 0f), 0.05f * Vector3.one).transform;
            each = frame =>
            {
                if (frame == 1) block.position += 0.1f * Vector3.right;
                if (frame < 2 || block.position.x > 8f) return;
                block.position += Mathf.Min(gap, 9f - block.position.x) * Vector3.right;
                if (wait > 0) simulation.ResetSimulation();
            };
        }

        private T Child<T>(Vector3 place) where T : Component
        {
            other = rig.NewObject(typeof(T).Name);
            other.layer = 0;
            other.transform.SetParent(simulation.transform, false);
            other.transform.localPosition = place;
            return other.AddComponent<T>();
        }

        private FluidEmitter Nozzle(Vector3 place, float speed)
        {
            FluidEmitter emitter = Child<FluidEmitter>(place);
            other.transform.rotation = Quaternion.LookRotation(Vector3.down);
            (emitter.Size, emitter.Speed) = (0.1f * Vector2.one, speed);
            return emitter;
        }

        // More than it started with; gap: how much, m³/s.
        private void Gush()
        {
            FluidEmitter emitter = Nozzle(0.15f * Vector3.up, 1f);
            (emitter.Flow, emitter.VolumeRate, gap) = (FluidEmitterFlow.VolumeRate, 0.01f, 0.08f);
            each = frame => emitter.VolumeRate = frame < 3 ? 0.01f : gap;
        }

        private void Relax()
        {
            (simulation.Method, simulation.StartRelaxation) = (FluidMethodKind.Robust, FluidStartRelaxation.Hydrostatic);
            volume.Size = new Vector3(0.4f, 0.2f, 0.4f);
            volume.transform.localPosition = -0.1f * Vector3.up;
        }

        private void Full()
        {
            Nozzle(0.15f * Vector3.up, 1f);
            (simulation.CapacityPolicy, simulation.Capacity, volume.Size) = (FluidCapacityPolicy.Fixed, 20, 0.1f * Vector3.one);
            volume.transform.localPosition = new Vector3(0.1f, -0.15f, 0.1f);
        }

        private void Zone(float strength)
        {
            FluidForceZone zone = Child<FluidForceZone>(Vector3.zero);
            (zone.Kind, zone.Size, zone.Strength) = (FluidForceKind.Directional, 0.4f * Vector3.one, strength);
        }

        // A Rigidbody that fits into the domain and stands on the liquid.
        private void Piston()
        {
            simulation.DomainSize = new Vector3(0.2f, 0.5f, 0.2f);
            volume.transform.localPosition = -0.15f * Vector3.up;
            Box("Piston", 0.03f * Vector3.up, new Vector3(0.19f, 0.15f, 0.19f));
            Rigidbody body = other.AddComponent<Rigidbody>();
            body.mass = 150f;
            body.constraints = RigidbodyConstraints.FreezeRotation | RigidbodyConstraints.FreezePositionX |
                RigidbodyConstraints.FreezePositionZ;
        }

        // Gap: the room that is left of a domain which is full.
        private void Squeeze()
        {
            simulation.DomainSize = 0.2f * Vector3.one;
            Transform lid = Box("Lid", 0.2f * Vector3.up, new Vector3(0.3f, 0.2f, 0.3f)).transform;
            if (gap == 0f) gap = 0.16f;
            each = _ => lid.position = Vector3.MoveTowards(lid.position, gap * Vector3.up, 0.002f);
        }

        private void Shoot()
        {
            rig.Profile.SoundSpeedMode = FluidSoundSpeedMode.FixedByRule;
            (simulation.UseSceneGravity, simulation.Gravity) = (false, 100f * Vector3.right);
            simulation.Boundaries = new FluidBoundaries { Periodic = FluidAxes.X };
            simulation.gameObject.AddComponent<FluidDiagnostics>().Interval = 1;
            each = _ => AsyncGPUReadback.WaitAllRequests();
        }
    }
}
