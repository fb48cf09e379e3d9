using System.Collections;
using NUnit.Framework;
using SphFluid.Validation;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A small dam break over closed colliders: what must hold once the liquid has come to rest.</summary>
    public sealed class SettlingTests
    {
        private const float FrameTime = 1f / 30f;
        private const float Seconds = 1.8f; // at 1.4 s it still splashes

        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(FrameTime);

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator LiquidSettlesFlatOverColliders()
        {
            FluidSimulation simulation = rig.Create(liquid: false);
            simulation.DomainSize = new Vector3(0.8f, 0.8f, 0.28f);
            simulation.Spacing = 0.04f;
            FluidVolume volume = rig.AddVolume(simulation);
            volume.Size = new Vector3(0.39f, 0.66f, 0.27f);
            volume.transform.localPosition = new Vector3(-0.2f, -0.05f, 0f);
            AddCollider<SphereCollider>(new Vector3(0.12f, -0.3f, -0.03f), Quaternion.identity, 0.2f);
            AddCollider<BoxCollider>(new Vector3(0.3f, -0.33f, 0.04f), Quaternion.Euler(0f, 30f, 0f), 0.14f);

            for (int frame = 0; frame <= Mathf.RoundToInt(Seconds / FrameTime); frame++) yield return null;

            Assert.That(simulation.SimulatedTime, Is.EqualTo(Seconds).Within(2f * FrameTime));
            FluidSnapshot snapshot = FluidSnapshot.Read(simulation);
            SnapshotStatistics statistics = SnapshotStatistics.Of(snapshot, simulation.Solver.Settings);
            Assert.That(statistics.NonFiniteCount, Is.Zero, "particles that are not finite");
            Assert.That(statistics.EscapedCount, Is.Zero, "particles outside the domain");
            Assert.That(ColliderPenetration.Of(simulation, snapshot).Deep, Is.Zero, "particles deeper in a collider than one spacing");
            LiquidVolume liquid = LiquidVolume.Of(simulation, snapshot);
            Assert.That(liquid.Measured, Is.EqualTo(liquid.Expected).Within(8).Percent, "volume");
            Assert.That(statistics.DensityErrorMean, Is.LessThan(0.04), "mean compression");
            // A tenth of the speed of the fall.
            Assert.That(statistics.RmsSpeed, Is.LessThan(0.1 * Mathf.Sqrt(2f * 9.81f * 0.7f)), "speed at rest [m/s]");
            Assert.That(simulation.CapHits, Is.Zero, "substep cap");
        }

        private void AddCollider<T>(Vector3 position, Quaternion rotation, float scale) where T : Collider
        {
            GameObject holder = rig.NewObject(typeof(T).Name);
            holder.transform.SetPositionAndRotation(position, rotation);
            holder.transform.localScale = Vector3.one * scale;
            holder.AddComponent<T>();
            Physics.SyncTransforms();
        }
    }
}
