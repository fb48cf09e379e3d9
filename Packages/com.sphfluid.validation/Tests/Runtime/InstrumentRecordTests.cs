using System.Collections;
using System.IO;
using System.Linq;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>The columns that the instruments of a scene have in a record.</summary>
    public sealed class InstrumentRecordTests
    {
        private SimulationRig rig;
        private string file;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(0.01f);
            file = Path.GetTempFileName();
        }

        [TearDown]
        public void TearDown()
        {
            rig.Dispose();
            File.Delete(file);
        }

        private T Add<T>(string name, Vector3 place) where T : FluidInstrument
        {
            GameObject holder = rig.NewObject(name);
            holder.transform.position = place;
            return holder.AddComponent<T>();
        }

        [UnityTest]
        public IEnumerator EachReadingIsAColumnOfItsOwnTime()
        {
            FluidSimulation simulation = rig.Create(), other = rig.Create("Other", position: 3f * Vector3.right);
            Add<FluidGauge>("Level", 0.2f * Vector3.down).Simulation = simulation;
            Add<FluidGauge>("Level", 0.2f * Vector3.down).Simulation = simulation;
            FluidProbe speed = Add<FluidProbe>("Fall, early", 0.05f * Vector3.down);
            (speed.Kind, speed.Simulation, speed.AveragingTime) = (FluidProbeKind.Velocity, simulation, 0f);
            Add<FluidFlux>("Elsewhere", 3f * Vector3.right).Simulation = other;
            while (!simulation.IsRunning || !other.IsRunning) yield return null;
            var record = new InstrumentRecord();
            var rows = new System.Collections.Generic.List<string> { "frame,time_s" };
            double expected = 0.0;
            for (int frame = 0; frame < 6; frame++)
            {
                yield return new WaitForEndOfFrame();
                record.AddRow(simulation);
                record.AddRow(other);
                rows.Add($"{2 * frame},0");
                rows.Add($"{2 * frame + 1},0");
                expected = 9.81 * simulation.SimulatedTime;
            }
            File.WriteAllLines(file, rows);
            record.AppendTo(file);
            string[][] table = File.ReadAllLines(file).Select(l => l.Split(',')).ToArray();
            Assert.That(table[0].Skip(2), Is.EqualTo(new[]
            {
                "Level.height_m", "Level 2.height_m", "Fall_ early.speed_m_s", "Fall_ early.velocity_x_m_s", "Fall_ early.velocity_y_m_s",
                "Fall_ early.velocity_z_m_s",
                "Elsewhere.flow_m3_s", "Elsewhere.volume_m3",
            }));
            Assert.That(table.Select(row => row.Length), Is.All.EqualTo(10));
            Assert.That(table[12].Take(8).Skip(2), Is.All.Empty, "the row of the other liquid");
            Assert.That(table[12].Skip(8), Is.All.Not.Empty);
            Assert.That(double.Parse(table[11][4], System.Globalization.CultureInfo.InvariantCulture),
                Is.EqualTo(expected).Within(4).Percent,
                "of the row's own time, half a step old; a frame before it was a sixth less");
        }
    }
}
