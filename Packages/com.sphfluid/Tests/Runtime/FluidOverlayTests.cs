using System;
using System.Collections;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>The overlay in a running scene.</summary>
    public sealed class FluidOverlayTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator ShowsTheLiquidsThatAreEnabled()
        {
            FluidSimulation tank = rig.Create("Tank");
            FluidOverlay overlay = Overlay();
            yield return Frames(30);
            Assert.That(overlay.Text, Does.Contain("\nTank   running\n  64 particles, 64 slots\n"));
            Assert.That(overlay.Text,
                Does.Contain(" steps a frame of ").And.Contain("real time x 1.00").And.Contain("limited by speed of sound; "));
            Assert.That(overlay.Text, Does.Contain(" ms a frame"));
            tank.Paused = true;
            yield return Frames(60); // two texts: the first is also of frames before
            Assert.That(overlay.Text, Does.Contain("\nTank   paused\n").And.Contain("\n  0.0 steps a frame of "));
            tank.StopSimulation();
            yield return Frames(30);
            Assert.That(overlay.Text, Does.Contain("\nTank   stopped"));
            Assert.That(overlay.Text, Does.Not.Contain("particles"));
        }

        [UnityTest]
        public IEnumerator ShowsOneLiquidWhereOneIsNamed()
        {
            rig.Create("Tank");
            FluidOverlay overlay = Overlay();
            overlay.Simulation = rig.Create("Cup", true, new Vector3(2f, 0f, 0f));
            yield return Frames(10);
            Assert.That(overlay.Text, Does.Contain("\nCup   running").And.Not.Contain("Tank"));
        }

        [UnityTest]
        public IEnumerator ALiquidThatIsDestroyedIsForgotten()
        {
            FluidSimulation tank = rig.Create("Tank");
            FluidOverlay overlay = Overlay();
            yield return Frames(10);
            UnityEngine.Object.DestroyImmediate(tank.gameObject);
            yield return Frames(30);
            Assert.That(overlay.Text, Does.Contain("no Fluid Simulation is enabled"));
        }

        [UnityTest]
        public IEnumerator StageTimesAreOfWhatTheGpuDoes()
        {
            rig.Create("Tank");
            FluidOverlay overlay = Overlay();
            yield return Frames(40);
            if (overlay.Text.Contains("no stage times") || overlay.Text.Contains("none yet"))
            {
                Assert.Ignore("Unity measures no markers here.");
            }
            Assert.That(overlay.Text,
                Does.Contain("  neighbours").And.Contain("  density").And.Contain("  forces").And.Contain("  together"));
            overlay.ShowsStageTimes = false;
            yield return Frames(30);
            Assert.That(overlay.Text, Does.Not.Contain("neighbours").And.Contain("Tank"));
        }

        [UnityTest]
        public IEnumerator HiddenItMeasuresAndSaysNothing()
        {
            rig.Create("Tank");
            FluidOverlay overlay = Overlay();
            yield return Frames(10);
            overlay.Visible = false;
            yield return Frames(2);
            Assert.That(overlay.Text, Is.Empty);
            overlay.Visible = true;
            yield return Frames(2);
            Assert.That(overlay.Text, Does.Contain("Tank"), "the first text comes at once");
        }

        [UnityTest]
        public IEnumerator TheTextChangesAsOftenAsIsAsked()
        {
            rig.Create("Tank");
            FluidOverlay overlay = Overlay();
            overlay.RefreshRate = 5f;
            yield return Frames(3);
            int changes = 0;
            string before = overlay.Text;
            for (int i = 0; i < 100; i++)
            {
                yield return null;
                if (!ReferenceEquals(before, overlay.Text)) changes++;
                before = overlay.Text;
            }
            Assert.That(changes, Is.InRange(4, 6), "100 frames of 10 ms, five times a second");
        }

        [UnityTest]
        public IEnumerator BetweenTwoTextsNothingIsAllocated()
        {
            FluidSimulation tank = rig.Create("Tank");
            yield return Frames(3);
            using (var meter = new OverlayMeter(StageTimes.Best))
            {
                meter.Update(null, 0.01, 10.0, true);
                long before = GC.GetAllocatedBytesForCurrentThread();
                for (int i = 0; i < 100; i++) meter.Update(null, 0.01, 10.0, true);
                Assert.That(GC.GetAllocatedBytesForCurrentThread() - before, Is.Zero);
                Assert.That(meter.Text, Does.Contain(tank.name));
            }
        }

        private FluidOverlay Overlay() => rig.NewObject("Overlay").AddComponent<FluidOverlay>();

        private static IEnumerator Frames(int count)
        {
            for (int i = 0; i < count; i++) yield return null;
        }
    }
}
