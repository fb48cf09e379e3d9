using System.Collections;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>A tank without a floor, as a component: what left is reported, measured by nobody and drawn by nobody.</summary>
    public sealed class OpenDomainTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator LiquidThatLeavesIsReportedAndForgotten()
        {
            FluidSimulation simulation = OpenTank();
            var diagnostics = simulation.gameObject.AddComponent<FluidDiagnostics>();
            diagnostics.Interval = 1;
            bool some = false;
            for (int frame = 0; frame < 45; frame++)
            {
                yield return null;
                if (!simulation.IsRunning) continue;
                long removed = simulation.Solver.ReadCountersNow().Removed;
                Assert.That(SimulationRig.Read(simulation).Length, Is.EqualTo(64 - removed));
                Assert.That(diagnostics.Statistics.ParticleCount + diagnostics.Statistics.Removed, Is.EqualTo(64).Or.Zero);
                some |= removed > 0 && removed < 64;
            }
            Assert.That(some, "it leaves little by little");
            Assert.That(simulation.RemovedParticles, Is.EqualTo(64));
            Assert.That(simulation.ParticleCount, Is.Zero);
            Assert.That(simulation.Messages.Select(m => m.ToString()), Is.Empty);
            Assert.That(simulation.ResetSimulation());
            Assert.That(simulation.RemovedParticles, Is.Zero);
        }

        [UnityTest]
        public IEnumerator WhatLeftIsNotDrawn()
        {
            var target = new RenderTexture(64, 64, 24);
            Camera camera = rig.NewObject("Camera").AddComponent<Camera>();
            camera.transform.position = new Vector3(0f, 0f, -2f);
            camera.orthographic = true;
            camera.orthographicSize = 0.4f; // sees what is below the tank
            camera.clearFlags = CameraClearFlags.SolidColor;
            camera.backgroundColor = Color.black;
            camera.targetTexture = target;
            FluidSimulation simulation = OpenTank();
            var drawing = simulation.gameObject.AddComponent<FluidParticleRenderer>();
            drawing.Color = Color.white;
            for (int frame = 0; frame < 4; frame++) yield return null;
            int before = Bright(target);
            for (int frame = 0; frame < 45; frame++) yield return null;
            Assert.That(before, Is.GreaterThan(50));
            Assert.That(simulation.Solver.ReadCountersNow().Removed, Is.EqualTo(64));
            Assert.That(Bright(target), Is.Zero);
            camera.targetTexture = null;
            target.Release();
            Object.DestroyImmediate(target);
        }

        private FluidSimulation OpenTank()
        {
            FluidSimulation simulation = rig.Create();
            simulation.Method = FluidMethodKind.Standard;
            simulation.Boundaries = new FluidBoundaries { Open = FluidFaces.LowY };
            return simulation;
        }

        private static int Bright(RenderTexture target)
        {
            RenderTexture active = RenderTexture.active;
            RenderTexture.active = target;
            var copy = new Texture2D(target.width, target.height, TextureFormat.RGBA32, false);
            copy.ReadPixels(new Rect(0, 0, target.width, target.height), 0, 0);
            copy.Apply();
            RenderTexture.active = active;
            int bright = copy.GetPixels().Count(p => p.maxColorComponent > 0.02f);
            Object.DestroyImmediate(copy);
            return bright;
        }
    }
}
