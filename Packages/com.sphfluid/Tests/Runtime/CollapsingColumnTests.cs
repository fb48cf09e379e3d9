using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>
    /// A column that falls on a floor: its foot is pressed out at four times gravity, faster than a speed of some frames ago tells.
    /// </summary>
    public sealed class CollapsingColumnTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(1f / 60f);

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator ListsAreMadeForTheSpeedThatTheLiquidHas()
        {
            FluidSimulation simulation = rig.Create(liquid: false);
            simulation.Spacing = 0.035f;
            simulation.DomainSize = new Vector3(1.8f, 1.2f, 0.4f);
            FluidVolume column = rig.AddVolume(simulation, "Column");
            column.Size = new Vector3(0.52f, 0.65f, 0.4f);
            column.transform.localPosition = new Vector3(-0.64f, -0.125f, 0f);
            while (!simulation.IsRunning) yield return null;
            float fastest = 0f;
            while (simulation.SimulatedTime < 0.4)
            {
                yield return null;
                float[] speeds = SimulationRig.Read(simulation).Select(p => p.VelT0.magnitude).OrderBy(v => v).ToArray();
                float bulk = speeds[speeds.Length * 99 / 100];
                Assert.That(simulation.Solver.FlowSpeed, Is.GreaterThanOrEqualTo(0.9f * bulk), $"m/s, at {simulation.SimulatedTime} s");
                fastest = Mathf.Max(fastest, bulk);
            }
            Assert.That(fastest, Is.GreaterThan(3f), "m/s: it was pressed out");
        }
    }
}
