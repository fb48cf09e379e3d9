using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>
    /// A cup that is accelerated holds its liquid as one at rest does under the sum of gravity and acceleration, or a message says which
    /// Expected Speed does.
    /// </summary>
    public sealed class AcceleratedCupTests
    {
        private const float Width = 0.2f, Wall = 0.05f, Spacing = 0.04f, Earth = 9.81f;
        private const int Frames = 20;

        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        // Each pair of the values 0 and 1 of gravity, 1 and 9 of acceleration, with both modes of both methods.
        private static readonly (FluidMethodKind Method, FluidTimeStepMode Mode, float Gravity, float Acceleration)[] Cups =
        {
            (FluidMethodKind.Standard, FluidTimeStepMode.Automatic, 0f, 1f),
            (FluidMethodKind.Standard, FluidTimeStepMode.Automatic, 1f, 9f),
            (FluidMethodKind.Standard, FluidTimeStepMode.Adaptive, 0f, 9f),
            (FluidMethodKind.Robust, FluidTimeStepMode.Automatic, 0f, 9f),
            (FluidMethodKind.Robust, FluidTimeStepMode.Adaptive, 1f, 1f),
        };

        [UnityTest]
        public IEnumerator ItIsAsStiffAsOneAtRest(
            [ValueSource(nameof(Cups))] (FluidMethodKind Method, FluidTimeStepMode Mode, float Gravity, float Acceleration) given)
        {
            (FluidMethodKind method, FluidTimeStepMode mode, float gravity, float acceleration) = given;
            var found = new List<(float height, float compression)>();
            foreach (bool moves in new[] { true, false })
            {
                FluidSimulation simulation = Cup(moves ? gravity : gravity + acceleration, out Transform cup);
                simulation.Method = method;
                simulation.TimeStepMode = mode;
                yield return null;
                for (int frame = 0; frame < Frames; frame++)
                {
                    if (moves) Place(cup, acceleration, frame + 1);
                    yield return null;
                }
                Assert.That(simulation.Messages, Is.Empty);
                found.Add((SimulationRig.MeanHeight(simulation) - cup.localPosition.y, Compression(simulation)));
                Object.DestroyImmediate(simulation.gameObject);
                Object.DestroyImmediate(cup.gameObject);
            }
            TestContext.WriteLine(
                $"accelerated {found[0].height:f4} m, {found[0].compression:f4}; at rest {found[1].height:f4} m, " +
                $"{found[1].compression:f4}");
            Assert.That(found[0].height, Is.EqualTo(found[1].height).Within(0.2 * Width));
            Assert.That(found[0].compression, Is.LessThan(0.06), "Max Compression is 4 % at the bottom, and it swings");
        }

        [UnityTest]
        public IEnumerator WhereNothingFollowsAMessageNamesTheExpectedSpeedThatDoes([Values] Stiff stiff)
        {
            float[] speeds = new float[2];
            for (int turn = 0; turn < 2; turn++)
            {
                FluidSimulation simulation = Cup(0f, out Transform cup);
                Make(simulation, stiff);
                if (turn > 0) simulation.ExpectedSpeed = speeds[0];
                yield return null;
                for (int frame = 0; frame < Frames; frame++)
                {
                    Place(cup, 1f, frame + 1);
                    yield return null;
                }
                string[] said = simulation.Messages.Where(m => m.Issue == FluidIssue.LiquidTooSoft).Select(m => m.ToString()).ToArray();
                float compression = Compression(simulation);
                TestContext.WriteLine($"{compression:f4}; {string.Join(" | ", said)}");
                if (turn == 0)
                {
                    Assert.That(said.Length, Is.Positive, "within 0.2 s");
                    Match named = Regex.Match(said[0], @"'(Floor|Side)' drives .*Set the simulation's Expected Speed to ([0-9.]+) m/s");
                    Assert.That(named.Success, said[0]);
                    speeds[0] = float.Parse(named.Groups[2].Value, CultureInfo.InvariantCulture);
                    Match step = Regex.Match(said[0], @"Fixed Time Step to ([0-9.E-]+) s");
                    Assert.That(step.Success, Is.EqualTo(stiff == Stiff.FixedStep || stiff == Stiff.ThesisFixed));
                    if (step.Success) speeds[1] = float.Parse(step.Groups[1].Value, CultureInfo.InvariantCulture);
                }
                else
                {
                    Assert.That(said, Is.Empty);
                    Assert.That(simulation.Messages.Where(m => m.Severity != FluidSeverity.Info), Is.Empty);
                    if (stiff != Stiff.Thesis && stiff != Stiff.ThesisFixed) Assert.That(compression, Is.LessThan(0.06));
                }
                Object.DestroyImmediate(simulation.gameObject);
                Object.DestroyImmediate(cup.gameObject);
            }

            void Make(FluidSimulation simulation, Stiff how)
            {
                if (how == Stiff.ByRule) rig.Profile.SoundSpeedMode = FluidSoundSpeedMode.FixedByRule;
                if (how == Stiff.FixedStep || how == Stiff.ThesisFixed) simulation.TimeStepMode = FluidTimeStepMode.Fixed;
                simulation.FixedTimeStep = speeds[1] > 0f ? speeds[1] : 0.005f;
                if (how != Stiff.Thesis && how != Stiff.ThesisFixed) return;
                simulation.Method = FluidMethodKind.Thesis;
                rig.Profile.SupportRatio = 2f;
            }
        }

        public enum Stiff { ByRule, FixedStep, Thesis, ThesisFixed }

        private static float Compression(FluidSimulation simulation)
        {
            FluidParticle[] particles = GpuTest.Read<FluidParticle>(simulation.Solver.Particles, simulation.Solver.ParticleCount);
            float[] density = GpuTest.Read<float>(simulation.Solver.Density, particles.Length);
            return Enumerable.Range(0, particles.Length).Where(i => !particles[i].IsRemoved)
                .Average(i => Mathf.Max(0f, density[i] / simulation.Solver.Settings.RestDensity - 1f));
        }

        private static void Place(Transform cup, float acceleration, int frame)
        {
            float time = frame * Time.captureDeltaTime;
            cup.localPosition = new Vector3(0f, -0.9f + 0.5f * acceleration * Earth * time * time, 0f);
        }

        // Of five boxes, with a cube of liquid in it.
        private FluidSimulation Cup(float gravity, out Transform cup)
        {
            FluidSimulation simulation = rig.Create(liquid: false);
            simulation.DomainSize = new Vector3(0.4f, 2.4f, 0.4f);
            simulation.Spacing = Spacing;
            simulation.UseSceneGravity = false;
            simulation.Gravity = new Vector3(0f, -gravity * Earth, 0f);
            Transform holder = cup = rig.NewObject("Cup").transform;
            Place(cup, 0f, 0);
            Side("Floor", new Vector3(0f, -0.5f * (Width + Wall), 0f), new Vector3(Width + 2f * Wall, Wall, Width + 2f * Wall));
            for (int side = 0; side < 4; side++)
            {
                var towards = new Vector3(side < 2 ? 1f - 2f * side : 0f, 0f, side < 2 ? 0f : 5f - 2f * side);
                Side("Side", 0.5f * (Width + Wall) * towards + 0.05f * Vector3.up,
                    new Vector3(side < 2 ? Wall : Width, Width + 0.1f, side < 2 ? Width : Wall));
            }
            rig.AddVolume(simulation).transform.localPosition = cup.localPosition;
            return simulation;

            void Side(string name, Vector3 place, Vector3 size)
            {
                GameObject side = rig.NewObject(name);
                side.transform.SetParent(holder, false);
                side.transform.localPosition = place;
                side.AddComponent<BoxCollider>().size = size;
            }
        }
    }
}
