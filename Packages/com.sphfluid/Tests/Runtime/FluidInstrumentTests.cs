using System.Collections;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Probes, gauges and fluxes of a running liquid: what they read, and what they say when they cannot.</summary>
    public sealed class FluidInstrumentTests
    {
        private const float Volume = 64 * SimulationRig.Spacing * SimulationRig.Spacing * SimulationRig.Spacing;

        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(0.01f);

        [TearDown]
        public void TearDown() => rig.Dispose();

        private T Instrument<T>(Vector3 place, float averagingTime = 0f) where T : FluidInstrument
        {
            GameObject holder = rig.NewObject(typeof(T).Name);
            holder.transform.position = place;
            T instrument = holder.AddComponent<T>();
            instrument.AveragingTime = averagingTime;
            return instrument;
        }

        // A pool 0.2 m deep, at a place in the world.
        private FluidSimulation Pool(Vector3 position = default)
        {
            FluidSimulation simulation = rig.Create(liquid: false, position: position);
            FluidVolume volume = rig.AddVolume(simulation);
            volume.Size = new Vector3(0.4f, 0.2f, 0.4f);
            volume.transform.localPosition = new Vector3(0f, -0.1f, 0f);
            return simulation;
        }

        private static IEnumerator Play(FluidSimulation simulation, int frames)
        {
            while (!simulation.IsRunning) yield return null;
            for (int i = 0; i < frames; i++) yield return null;
        }

        // The whole floor bears the whole weight; the probe snaps to it and turns its patch by itself.
        [UnityTest]
        public IEnumerator AProbeAtTheFloorReadsTheWeightOfTheWater()
        {
            FluidSimulation simulation = Pool(new Vector3(3f, 1f, 0f));
            FluidProbe probe = Instrument<FluidProbe>(new Vector3(3f, 0.84f, 0f), 0.3f);
            probe.PatchSize = new Vector2(0.5f, 0.5f);
            Assert.That((probe.HasValue, probe.Value, probe.Patch), Is.EqualTo((false, 0f, (WallPatch)null)));
            Assert.That(probe.Readings[0].Value, Is.NaN);
            int received = 0;
            probe.Received += _ => received++;
            yield return Play(simulation, 60);
            probe.ReadNow();
            Assert.That(probe.Problem, Is.Null);
            float weight = simulation.ParticleCount * simulation.Solver.Settings.ParticleMass * 9.81f;
            Assert.That(probe.Force, Is.EqualTo(weight).Within(5).Percent);
            Assert.That(probe.Value, Is.EqualTo(probe.Force / 0.16f).Within(0.01f).Percent, "the floor is smaller");
            Assert.That(probe.Peak, Is.GreaterThanOrEqualTo(probe.Value));
            Assert.That((probe.WallPoint - new Vector3(3f, 0.8f, 0f)).magnitude, Is.LessThan(1e-5f));
            Assert.That((probe.WallRotation * Vector3.forward - Vector3.up).magnitude, Is.LessThan(1e-5f));
            Assert.That(received, Is.GreaterThan(5));
            Assert.That(probe.Readings.Select(r => r.Column), Is.EqualTo(new[] { "pressure_pa", "peak_pressure_pa", "force_n" }));
            Assert.That(probe.ReadTime, Is.EqualTo(simulation.SimulatedTime).Within(1e-6), "ReadNow waits for the newest");
            probe.transform.position += 0.16f * Vector3.up; // in the middle of the air
            LogAssert.Expect(LogType.Warning, new Regex("No wall of 'Fluid' is within .* Move this object"));
            yield return null;
            Assert.That((probe.Problem.Value.Issue, probe.Patch), Is.EqualTo((FluidIssue.InstrumentInvalid, (WallPatch)null)));
            Assert.That(simulation.Solver.WallForces.Patches, Is.Empty);
        }

        [UnityTest]
        public IEnumerator AProbeGoesWithTheColliderThatItIsOn()
        {
            FluidSimulation simulation = Pool();
            GameObject plate = rig.NewObject("Plate");
            plate.AddComponent<BoxCollider>().size = new Vector3(0.1f, 0.3f, 0.3f);
            plate.transform.position = new Vector3(-0.1f, 0f, 0f);
            FluidProbe probe = Instrument<FluidProbe>(new Vector3(-0.03f, -0.05f, 0.02f));
            probe.transform.SetParent(plate.transform, true);
            yield return Play(simulation, 3);
            plate.transform.SetPositionAndRotation(new Vector3(-0.09f, 0.01f, 0f), Quaternion.Euler(0f, 0f, 5f));
            yield return null;
            Vector3 expected = plate.transform.position + plate.transform.rotation * new Vector3(0.05f, -0.05f, 0.02f);
            Assert.That((probe.WallPoint - expected).magnitude, Is.LessThan(1e-5f));
            Assert.That((probe.Patch.Centre - expected).magnitude, Is.LessThan(1e-5f), "simulation space is the world here");
            Assert.That(probe.Patch.Carrier, Is.EqualTo(plate.GetComponent<BoxCollider>()));
            Assert.That(probe.Problem, Is.Null);
        }

        [UnityTest]
        public IEnumerator APatchNarrowerThanASpacingIsDoubted()
        {
            FluidSimulation simulation = Pool();
            FluidProbe probe = Instrument<FluidProbe>(new Vector3(0.19f, -0.1f, 0f));
            probe.PatchSize = new Vector2(0.2f, 0.02f);
            LogAssert.Expect(LogType.Warning, new Regex("0.02 m wide, less than a particle spacing of 0.05 m.* Raise Patch Size"));
            yield return Play(simulation, 4);
            Assert.That(probe.HasValue, "it reads all the same");
            probe.PatchSize = Vector2.zero;
            LogAssert.Expect(LogType.Warning, new Regex("no area"));
            yield return null;
            Assert.That(probe.Patch, Is.Null);
        }

        [UnityTest]
        public IEnumerator AMethodWithoutWallForcesIsNamedWithTheCure()
        {
            FluidSimulation simulation = Pool();
            simulation.Method = FluidMethodKind.Thesis;
            FluidProbe probe = Instrument<FluidProbe>(new Vector3(0.19f, -0.1f, 0f));
            LogAssert.Expect(LogType.Warning,
                new Regex("The method Thesis does not sum the force on walls.* Set the simulation's Method to Standard"));
            yield return Play(simulation, 5);
            Assert.That(probe.HasValue, Is.False);
            probe.Kind = FluidProbeKind.LiquidPressure;
            yield return Play(simulation, 5);
            Assert.That((probe.HasValue, probe.Problem.HasValue), Is.EqualTo((true, false)));
        }

        [UnityTest]
        public IEnumerator WithoutASimulationItSaysSo()
        {
            FluidGauge gauge = Instrument<FluidGauge>(Vector3.zero);
            LogAssert.Expect(LogType.Warning, new Regex("There is no Fluid Simulation to read. Assign Simulation"));
            for (int i = 0; i < 5; i++) yield return null;
            Assert.That((gauge.HasValue, gauge.Liquid), Is.EqualTo((false, (FluidSimulation)null)));
            gauge.ReadNow();
            FluidSimulation simulation = Pool();
            gauge.transform.position = 0.2f * Vector3.down;
            yield return Play(simulation, 6);
            Assert.That((gauge.HasValue, gauge.Problem.HasValue, gauge.Liquid), Is.EqualTo((true, false, simulation)));
            simulation.StopSimulation();
            yield return null;
            Assert.That(gauge.HasValue, Is.False, "what is gone is not read");
        }

        [UnityTest]
        public IEnumerator AGaugeReadsTheHeightOfThePool()
        {
            FluidSimulation simulation = Pool(new Vector3(3f, 1f, 0f));
            FluidGauge gauge = Instrument<FluidGauge>(new Vector3(3.03f, 0.75f, 0.02f), 0.05f); // 0.05 m below the domain
            yield return Play(simulation, 20);
            gauge.ReadNow();
            Assert.That(gauge.Height, Is.EqualTo(0.25f).Within(0.25f * SimulationRig.Spacing));
            Assert.That((gauge.Surface - new Vector3(3.03f, 0.75f + gauge.Height, 0.02f)).magnitude, Is.LessThan(1e-5f));
            gauge.transform.position += 2f * Vector3.right;
            LogAssert.Expect(LogType.Warning, new Regex("line does not go through the domain"));
            yield return null;
        }

        // A cube of 64 particles falls through.
        [UnityTest]
        public IEnumerator AFluxCountsAllThatGoesThrough()
        {
            FluidSimulation simulation = rig.Create();
            FluidFlux flux = Instrument<FluidFlux>(0.12f * Vector3.down, 0.05f);
            flux.transform.rotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
            flux.Size = new Vector2(0.4f, 0.4f);
            FluidProbe speed = Instrument<FluidProbe>(0.05f * Vector3.down);
            speed.Kind = FluidProbeKind.Velocity;
            yield return Play(simulation, 10);
            flux.ReadNow();
            speed.ReadNow();
            Assert.That(flux.Total, Is.InRange(0.0, 0.4 * Volume));
            // Velocities are half a step old.
            Assert.That(speed.Velocity.y, Is.EqualTo(-9.81f * (float)simulation.SimulatedTime).Within(3).Percent);
            Assert.That(speed.Value, Is.EqualTo(speed.Velocity.magnitude).Within(0.01f).Percent);
            float largest = 0f;
            for (int frame = 0; frame < 10; frame++)
            {
                yield return null;
                flux.ReadNow();
                largest = Mathf.Max(largest, flux.Rate);
            }
            float area = 0.2f * 0.2f; // of the cube
            Assert.That(largest, Is.InRange(0.6f * area * 1.2f, 1.5f * area * 2f), "at 1.2 to 2 m/s");
            yield return Play(simulation, 25);
            Assert.That(flux.Total, Is.InRange(0.55 * Volume, 1.01 * Volume), "a part splashes back");
            flux.Clear();
            Assert.That((flux.Total, flux.HasValue), Is.EqualTo((0.0, false)));
            flux.Size = new Vector2(0f, 1f);
            LogAssert.Expect(LogType.Warning, new Regex("Give Size two positive edge lengths"));
            yield return null;
        }

        [UnityTest]
        public IEnumerator ADensityProbeReadsTheRestDensityAndNothingInAir()
        {
            FluidSimulation simulation = Pool();
            FluidProbe wet = Instrument<FluidProbe>(0.1f * Vector3.down, 0.05f), dry = Instrument<FluidProbe>(0.15f * Vector3.up);
            wet.Kind = dry.Kind = FluidProbeKind.Density;
            yield return Play(simulation, 10);
            Assert.That(wet.Value, Is.EqualTo(1000f).Within(8).Percent);
            Assert.That((dry.HasValue, dry.Value), Is.EqualTo((true, 0f)));
            wet.enabled = false;
            Assert.That(FluidInstrument.Active, Is.EquivalentTo(new FluidInstrument[] { dry }));
            Assert.That(simulation.Queries.Count, Is.EqualTo(1), "a disabled one asks nothing");
        }
    }
}
