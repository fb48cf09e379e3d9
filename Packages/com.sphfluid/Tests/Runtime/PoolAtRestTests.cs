using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A relaxed pool starts at rest, whether it ends at its walls or less than a spacing from them.</summary>
    public sealed class PoolAtRestTests
    {
        private const float Spacing = SimulationRig.Spacing, Calm = 0.1f;

        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(1f / 30f);

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator NothingIsFastInItsFirstHalfSecond([Values(0f, 0.3f, 0.9f)] float gap)
        {
            FluidSimulation simulation = rig.Create(liquid: false);
            simulation.DomainSize = new Vector3(8f, 7f, 8f) * Spacing;
            simulation.StartRelaxation = FluidStartRelaxation.Hydrostatic;
            FluidVolume pool = rig.AddVolume(simulation);
            pool.Size = new Vector3(8f - 2f * gap, 4f - gap, 8f - 2f * gap) * Spacing;
            pool.transform.localPosition = new Vector3(0f, 0.5f * (gap - 3f) * Spacing, 0f);
            while (!simulation.IsRunning) yield return null;
            Assert.That(simulation.ParticleCount, Is.EqualTo(256));
            float fastest = 0f;
            while (simulation.SimulatedTime < 0.5)
            {
                yield return null;
                fastest = Mathf.Max(fastest, SimulationRig.Read(simulation).Max(p => p.VelT0.magnitude));
            }
            Assert.That(fastest, Is.InRange(1e-5f, Calm), "m/s");
        }
    }
}
