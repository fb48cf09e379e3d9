using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>The first lines of code that a newcomer reads, as the repository's README prints them.</summary>
    public sealed class FirstLinesTests
    {
        [UnityTest]
        public IEnumerator TheLinesOfTheReadmeMakeWaterThatFallsAndIsDrawn()
        {
            var water = TestAssets.Load<FluidProfile>("Packages/com.sphfluid/Runtime/Assets/WaterProfile.asset");

            var liquid = new GameObject("Tank").AddComponent<FluidSimulation>();       // a box of one cubic metre
            liquid.Profile = water;                                                    // the package's WaterProfile
            liquid.gameObject.AddComponent<FluidSurfaceRenderer>();                    // drawn as water
            var block = new GameObject("Water").AddComponent<FluidVolume>();           // a block of liquid
            block.transform.SetParent(liquid.transform, false);                        // in the tank's middle

            try
            {
                Time.captureDeltaTime = 1f / 30f;
                for (int frame = 0; frame < 5; frame++) yield return null;
                Assert.That(liquid.IsRunning, liquid.StatusMessage);
                Assert.That(liquid.Messages, Is.Empty);
                Assert.That(liquid.ParticleCount, Is.EqualTo(8000), "half a metre cubed at 25 mm");
                float lowest = LowestParticle(liquid);
                Assert.That(lowest, Is.LessThan(-0.26f), "it began at 0.25 m below the middle");
            }
            finally
            {
                Time.captureDeltaTime = 0f;
                Object.Destroy(liquid.gameObject);
            }
        }

        private static float LowestParticle(FluidSimulation liquid)
        {
            var particles = new List<FluidParticle>();
            Assert.That(liquid.TryReadParticles(particles));
            float lowest = float.MaxValue;
            foreach (FluidParticle particle in particles) lowest = Mathf.Min(lowest, particle.Position.y);
            return lowest;
        }
    }
}
