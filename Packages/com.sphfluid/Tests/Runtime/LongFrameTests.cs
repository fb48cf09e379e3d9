using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Liquid that speeds up and hits the floor within one long frame is thrown no higher than it fell from.</summary>
    public sealed class LongFrameTests
    {
        private const float Spacing = SimulationRig.Spacing;

        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(1f / 3f);

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator NothingIsFasterThanItsFall()
        {
            var domain = new Vector3(8f, 24f, 8f) * Spacing;
            FluidSimulation simulation = rig.Create(liquid: false);
            simulation.DomainSize = domain;
            FluidVolume block = rig.AddVolume(simulation);
            block.Size = new Vector3(4f, 6f, 4f) * Spacing;
            block.transform.localPosition = new Vector3(-2f, 9f, -2f) * Spacing;
            FluidVolume pool = rig.AddVolume(simulation, "Pool");
            pool.Size = new Vector3(8f, 4f, 8f) * Spacing;
            pool.transform.localPosition = new Vector3(0f, -10f, 0f) * Spacing;
            while (!simulation.IsRunning) yield return null;
            float fall = Mathf.Sqrt(2f * 9.81f * domain.y), fastest = 0f;
            while (simulation.SimulatedTime < 1.3)
            {
                yield return null;
                fastest = Mathf.Max(fastest, SimulationRig.Read(simulation).Max(p => p.VelT0.magnitude));
            }
            Assert.That(fastest, Is.InRange(0.5f, fall), "m/s");
        }
    }
}
