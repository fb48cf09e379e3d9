using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Sensors of a running liquid: what they read and when they raise events.</summary>
    public sealed class FluidSensorTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(0.01f);

        [TearDown]
        public void TearDown() => rig.Dispose();

        private FluidSensor Sensor(FluidSensorKind kind, Vector3 place)
        {
            GameObject holder = rig.NewObject("Sensor");
            holder.transform.position = place;
            FluidSensor sensor = holder.AddComponent<FluidSensor>();
            sensor.Kind = kind;
            return sensor;
        }

        private static IEnumerator Play(FluidSimulation simulation, int frames)
        {
            while (!simulation.IsRunning) yield return null;
            for (int i = 0; i < frames; i++) yield return null;
        }

        [UnityTest]
        public IEnumerator ABlockThatFallsPastRisesAndFallsOnce()
        {
            FluidSimulation simulation = rig.Create();
            FluidSensor sensor = Sensor(FluidSensorKind.Wetness, new Vector3(0f, 0.02f, 0f));
            int rose = 0, fell = 0;
            float atFall = 1f;
            sensor.RoseAbove.AddListener(_ => rose++);
            sensor.FellBelow.AddListener(value =>
            {
                fell++;
                atFall = value;
            });
            Assert.That(sensor.HasValue, Is.False);
            yield return Play(simulation, 10);
            Assert.That(sensor.HasValue);
            Assert.That(sensor.Value, Is.InRange(0.7f, 1.2f));
            Assert.That(sensor.IsAbove);
            yield return Play(simulation, 34);
            Assert.That((rose, fell), Is.EqualTo((0, 1)), "it starts within the liquid, which falls 0.1 m");
            Assert.That(atFall, Is.LessThan(0.4f));
            Assert.That(sensor.IsAbove, Is.False);
            sensor.transform.position = new Vector3(0f, -0.19f, 0f); // the pool is 0.05 m deep
            yield return Play(simulation, 80); // it splashes, on some devices once more past the sensor
            Assert.That(sensor.IsAbove);
            Assert.That(rose, Is.EqualTo(fell).And.InRange(1, 3),
                "each fall but the last is followed by a rise, and the first came from above");
        }

        [UnityTest]
        public IEnumerator TheLevelIsThatOfTheSurface()
        {
            FluidSimulation simulation = rig.Create(liquid: false, position: new Vector3(3f, 1f, 0f));
            FluidVolume volume = rig.AddVolume(simulation);
            volume.Size = new Vector3(0.4f, 0.2f, 0.4f);
            volume.transform.localPosition = new Vector3(0f, -0.1f, 0f);
            FluidSensor sensor = Sensor(FluidSensorKind.Level, new Vector3(3.03f, 0.75f, 0.02f)); // 0.05 m below the domain
            sensor.Threshold = 0.1f;
            yield return Play(simulation, 20);
            Assert.That(sensor.Value, Is.EqualTo(0.25f).Within(0.25f * SimulationRig.Spacing));
            Assert.That(sensor.IsAbove);
            sensor.Length = 0.12f;
            yield return Play(simulation, 10);
            Assert.That(sensor.Value, Is.EqualTo(0.12f).Within(1e-4f));
        }

        [UnityTest]
        public IEnumerator TheFillLevelIsThatOfABoxAboutTheSensor()
        {
            FluidSimulation simulation = rig.Create(liquid: false, position: new Vector3(3f, 1f, 0f));
            FluidVolume volume = rig.AddVolume(simulation);
            volume.Size = new Vector3(0.4f, 0.2f, 0.4f);
            volume.transform.localPosition = new Vector3(0f, -0.1f, 0f); // up to the height 1
            FluidSensor sensor = Sensor(FluidSensorKind.FillLevel, new Vector3(3f, 0.95f, 0f));
            sensor.Size = new Vector3(0.3f, 0.2f, 0.3f);
            sensor.Threshold = 0.5f;
            yield return Play(simulation, 5);
            Assert.That(sensor.Value, Is.EqualTo(0.75f).Within(0.03f));
            Assert.That(sensor.IsAbove);
            int fell = 0;
            sensor.FellBelow.AddListener(_ => fell++);
            sensor.transform.SetPositionAndRotation(new Vector3(3f, 1.05f, 0f), Quaternion.Euler(0f, 90f, 0f));
            yield return Play(simulation, 5);
            Assert.That(sensor.Value, Is.EqualTo(0.25f).Within(0.03f));
            Assert.That(fell, Is.EqualTo(1));
            sensor.Size = new Vector3(0.3f, 0f, 0.3f);
            yield return Play(simulation, 2);
            Assert.That(sensor.HasValue, Is.False);
            sensor.Kind = FluidSensorKind.Wetness;
            yield return Play(simulation, 5);
            Assert.That(sensor.HasValue);
            Assert.That(simulation.Queries.Count, Is.EqualTo(1));
        }

        [UnityTest]
        public IEnumerator TheFlowIsTheVolumeASecondThroughARectangle()
        {
            FluidSimulation simulation = rig.Create();
            FluidSensor sensor = Sensor(FluidSensorKind.Flow, 0.13f * Vector3.down);
            sensor.transform.rotation = Quaternion.LookRotation(Vector3.down, Vector3.forward);
            sensor.Size = new Vector3(0.4f, 0.4f, 0f);
            sensor.Threshold = 0.01f;
            sensor.Hysteresis = 0.01f;
            int rose = 0;
            sensor.RoseAbove.AddListener(_ => rose++);
            yield return Play(simulation, 7);
            Assert.That((sensor.HasValue, sensor.Value), Is.EqualTo((true, 0f)), "nothing has come so far");
            double volume = 0.0, before = sensor.AnsweredTime;
            for (int frame = 0; frame < 18; frame++)
            {
                yield return null;
                if (sensor.AnsweredTime > before) volume += sensor.Value * (sensor.AnsweredTime - before);
                before = sensor.AnsweredTime;
            }
            Assert.That(volume, Is.EqualTo(0.008).Within(0.002), "the block fell through, and has not splashed up yet");
            Assert.That(rose, Is.Positive);
            sensor.Size = Vector3.zero;
            yield return Play(simulation, 2);
            Assert.That(sensor.HasValue, Is.False);
        }

        [UnityTest]
        public IEnumerator SpeedIsThatOfTheFallAndIsAveraged()
        {
            FluidSimulation simulation = rig.Create();
            FluidSensor sensor = Sensor(FluidSensorKind.Speed, Vector3.zero), slow = Sensor(FluidSensorKind.Speed, Vector3.zero);
            slow.AveragingTime = 10f;
            yield return Play(simulation, 10);
            Assert.That(sensor.Value, Is.EqualTo(9.81f * (float)sensor.AnsweredTime).Within(0.1f));
            Assert.That(slow.Value, Is.LessThan(0.5f * sensor.Value));
        }

        [UnityTest]
        public IEnumerator AStoppedLiquidHasNoReading()
        {
            FluidSimulation simulation = rig.Create();
            FluidSensor sensor = Sensor(FluidSensorKind.Wetness, Vector3.zero);
            yield return Play(simulation, 10);
            Assert.That(sensor.IsAbove);
            int events = 0;
            sensor.FellBelow.AddListener(_ => events++);
            simulation.StopSimulation();
            yield return null;
            Assert.That(sensor.HasValue, Is.False);
            Assert.That(sensor.AnsweredTime, Is.EqualTo(-1.0));
            simulation.StartSimulation();
            yield return Play(simulation, 10);
            Assert.That(sensor.HasValue);
            Assert.That(events, Is.Zero);
            sensor.enabled = false;
            Assert.That(simulation.Queries.Count, Is.Zero);
        }

        [UnityTest]
        public IEnumerator OneOfSeveralLiquidsIsReadByPlaceOrName()
        {
            FluidSimulation left = rig.Create("Left"), right = rig.Create("Right", position: new Vector3(5f, 0f, 0f));
            FluidSensor sensor = Sensor(FluidSensorKind.Wetness, new Vector3(5f, 0f, 0f));
            yield return Play(left, 10);
            Assert.That(sensor.Value, Is.GreaterThan(0.8f));
            Assert.That((left.Queries.Count, right.Queries.Count), Is.EqualTo((0, 1)));
            sensor.Simulation = left;
            yield return Play(left, 10);
            Assert.That((left.Queries.Count, right.Queries.Count), Is.EqualTo((1, 0)));
            Assert.That(sensor.Value, Is.Zero);
            Object.Destroy(left.gameObject);
            yield return null;
            yield return null;
            Assert.That(right.Queries.Count, Is.EqualTo(1));
        }
    }
}
