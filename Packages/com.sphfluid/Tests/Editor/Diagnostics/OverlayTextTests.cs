using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What the overlay writes, and where it stands.</summary>
    public sealed class OverlayTextTests
    {
        private static readonly LiquidFigures Tank = new LiquidFigures
        {
            Name = "Tank", State = "running", Runs = true, Particles = 16380, Slots = 16384, StepsPerFrame = 11.25, SetupsPerFrame = 1.25,
            MostSteps = 64,
            TimeStep = 1.02e-3,
            RealTimeFactor = 1.0, Limit = TimeStepLimit.Acoustic, Bytes = 34 * 1048576 - 5,
        };

        [Test]
        public void ARunningLiquidHasFourLines()
        {
            Assert.That(Lines(Tank), Is.EqualTo(new[]
            {
                "SPH Fluid   frame 16.7 ms, 98 dispatches",
                "Tank   running",
                "  16,380 particles, 16,384 slots",
                "  11.3 steps a frame of 1.02 ms, 1.3 neighbour set-ups, real time x 1.00",
                "  limited by speed of sound; 34 MB",
            }));
        }

        [Test]
        public void WhatLeftWhatWasRefusedAndTheCapAreSaidWhereTheyAre()
        {
            LiquidFigures tank = Tank;
            tank.Removed = 1200;
            tank.Refused = 7;
            tank.CapHits = 3;
            tank.Limit = TimeStepLimit.Viscosity;
            tank.Message = "A frame of 33 ms needs 90 steps.";
            string[] lines = Lines(tank);
            Assert.That(lines[2], Is.EqualTo("  16,380 particles, 16,384 slots, 1,200 removed, 7 not born for want of slots"));
            Assert.That(lines[4], Is.EqualTo("  limited by viscosity and Max Substeps Per Frame, 64; 34 MB"));
            Assert.That(lines[5], Is.EqualTo("  ! A frame of 33 ms needs 90 steps."));
        }

        [Test]
        public void AMethodThatWasPickedHasALine()
        {
            LiquidFigures tank = Tank;
            tank.Method = "Standard, 15 steps a frame at most, 2.31 ms of 4 ms";
            Assert.That(Lines(tank)[2], Is.EqualTo("  Standard, 15 steps a frame at most, 2.31 ms of 4 ms"));
        }

        [Test]
        public void AStoppedLiquidSaysWhy()
        {
            var stopped = new LiquidFigures { Name = "Tank", State = "stopped", Message = "The liquid is empty." };
            Assert.That(Lines(stopped).Skip(1), Is.EqualTo(new[] { "Tank   stopped", "  ! The liquid is empty." }));
        }

        [Test]
        public void ALongMessageTakesSeveralLines()
        {
            var stopped =
                new LiquidFigures { Name = "Tank", State = "stopped", Message = string.Join(" ", Enumerable.Repeat("twelve-signs", 12)) };
            string[] lines = Lines(stopped).Skip(2).ToArray();
            string five = string.Join(" ", Enumerable.Repeat("twelve-signs", 5));
            Assert.That(lines, Is.EqualTo(new[] { "  ! " + five, "    " + five, "    twelve-signs twelve-signs" }), "64 signs a line");
        }

        [Test]
        public void NoLiquidIsSaid() => Assert.That(Lines().Skip(1), Is.EqualTo(new[] { "no Fluid Simulation is enabled" }));

        [Test]
        public void ReleaseBuildsHaveNoStageTimesAndSaySo()
        {
            using (var times = new StageTimes(FluidStage.All, StageClock.None))
                Assert.That(Write(times).Split('\n').Last(),
                    Is.EqualTo("no stage times: Unity measures them in the Editor and in development builds"));
        }

        [Test]
        public void TheClockOfTheStagesIsNamed()
        {
            using (var gpu = new StageTimes(FluidStage.All, StageClock.Gpu)) Assert.That(Write(gpu).Split('\n').Last(),
                Is.EqualTo("GPU, ms a frame: none yet"));
            using (var cpu = new StageTimes(FluidStage.All, StageClock.Cpu))
                Assert.That(Write(cpu).Split('\n').Last(), Is.EqualTo("CPU, ms a frame to submit: no GPU times here: none yet"));
        }

        [Test]
        public void AClockThatStaysSilentWhileLiquidMovesGivesWayToTheNext()
        {
            using (var times = new StageTimes(new[] { FluidStage.All[0] }, StageClock.Gpu))
            {
                for (int i = 0; i < 3 * StageTimes.Patience; i++) times.Read(false);
                Assert.That(times.Clock, Is.EqualTo(StageClock.Gpu), "nothing was to be measured");
                for (int i = 0; i < StageTimes.Patience; i++) times.Read(true);
                Assert.That(times.Clock, Is.EqualTo(StageClock.Cpu));
                for (int i = 0; i < StageTimes.Patience; i++) times.Read(true);
                Assert.That(times.Clock, Is.EqualTo(StageClock.None));
            }
        }

        [TestCase(FluidOverlayCorner.UpperLeft, 8f, 8f)]
        [TestCase(FluidOverlayCorner.UpperRight, 692f, 8f)]
        [TestCase(FluidOverlayCorner.LowerLeft, 8f, 542f)]
        [TestCase(FluidOverlayCorner.LowerRight, 692f, 542f)]
        public void ItStandsInItsCorner(FluidOverlayCorner corner, float x, float y) =>
            Assert.That(FluidOverlay.Place(corner, new Vector2(100f, 50f), new Vector2(800f, 600f)), Is.EqualTo(new Rect(x, y, 100f, 50f)));

        private static string[] Lines(params LiquidFigures[] liquids) =>
            new OverlayText().Write(liquids, null, FluidStage.All, 1.0 / 60.0, 98.4).Split('\n');

        private static string Write(StageTimes times) =>
            new OverlayText().Write(Array.Empty<LiquidFigures>(), times, FluidStage.All, 0.01, 0.0);
    }
}
