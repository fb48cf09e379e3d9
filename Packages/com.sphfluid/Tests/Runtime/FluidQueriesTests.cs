using System;
using System.Collections;
using System.Collections.Generic;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Queries of a running liquid: when they are answered, and when not.</summary>
    public sealed class FluidQueriesTests
    {
        SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(0.01f);

        [TearDown]
        public void TearDown() => rig.Dispose();

        [UnityTest]
        public IEnumerator PointsInLiquidAreWetAndOthersAreNot()
        {
            FluidSimulation simulation = rig.Create(position: new Vector3(2f, 1f, 0f));
            yield return null;
            simulation.StartSimulation();
            FluidQuery inside = simulation.Queries.AddPoint(new Vector3(2f, 1f, 0f)), above = simulation.Queries.AddPoint(new Vector3(2f, 1.19f, 0f)),
                outside = simulation.Queries.AddPoint(new Vector3(9e9f, 0f, 0f));
            int received = 0;
            simulation.Queries.Received += _ => received++;
            Assert.That(simulation.Queries.TryGet(inside, out _), Is.False);
            yield return null;
            yield return null;
            simulation.Queries.Complete();
            Assert.That(simulation.Queries.TryGet(inside, out FluidPointResult wet));
            Assert.That(wet.IsWet);
            Assert.That(wet.Density, Is.EqualTo(1000f).Within(100f));
            Assert.That(wet.Velocity.y, Is.InRange(-0.5f, -0.01f), "it falls");
            Assert.That(simulation.Queries.TryGet(above, out FluidPointResult dry));
            Assert.That(dry.IsWet, Is.False);
            Assert.That(dry.Density, Is.Zero);
            Assert.That(simulation.Queries.TryGet(outside, out FluidPointResult far));
            Assert.That(far.Density, Is.Zero);
            Assert.That(received, Is.GreaterThan(0));
            Assert.That(simulation.Queries.AgeInFrames, Is.InRange(0, 4));
            Assert.That(simulation.Queries.Points.Length, Is.EqualTo(3));
        }

        [UnityTest]
        public IEnumerator RemovedAndReusedRequestsDoNotGetOldAnswers()
        {
            FluidSimulation simulation = rig.Create();
            yield return null;
            simulation.StartSimulation();
            FluidQueries queries = simulation.Queries;
            FluidQuery first = queries.AddPoint(Vector3.zero);
            yield return null;
            yield return null;
            queries.Complete();
            Assert.That(queries.TryGet(first, out _));
            queries.Remove(first);
            queries.Remove(first);
            FluidQuery second = queries.AddPoint(Vector3.zero);
            Assert.That(second.Index, Is.EqualTo(first.Index));
            Assert.That(queries.TryGet(first, out _), Is.False);
            Assert.That(queries.TryGet(second, out _), Is.False);
            Assert.That(() => queries.Move(first, Vector3.one), Throws.ArgumentException);
            Assert.That(queries.TryGet(default, out _), Is.False);
            yield return null;
            queries.Complete();
            Assert.That(queries.TryGet(second, out _));
            Assert.That(queries.TryGet(first, out _), Is.False);
        }

        [UnityTest]
        public IEnumerator ANewStartAndADisabledLiquidHaveNoAnswers()
        {
            FluidSimulation simulation = rig.Create();
            yield return null;
            simulation.StartSimulation();
            FluidQuery query = simulation.Queries.AddPoint(Vector3.zero);
            yield return null;
            yield return null;
            simulation.ResetSimulation();
            simulation.Queries.Complete();
            Assert.That(simulation.Queries.TryGet(query, out _), Is.False, "an answer of the run before");
            yield return null;
            simulation.Queries.Complete();
            Assert.That(simulation.Queries.TryGet(query, out _));
            simulation.enabled = false;
            Assert.That(simulation.Queries.TryGet(query, out _), Is.False);
            Assert.That(simulation.Queries.AgeInFrames, Is.EqualTo(-1));
        }

        [UnityTest]
        public IEnumerator CapacityGrowsAndTwoRunsAnswerAlike()
        {
            var runs = new List<FluidPointResult[]>();
            for (int run = 0; run < 2; run++)
            {
                FluidSimulation simulation = rig.Create();
                yield return null;
                simulation.StartSimulation();
                var asked = new FluidQuery[3000];
                for (int i = 0; i < asked.Length; i++)
                {
                    if (i == 1000) yield return null;
                    if (i == 1000) yield return null;
                    asked[i] = simulation.Queries.AddPoint(new Vector3(0.0001f * (i - 1500), 0.03f, -0.04f));
                }
                yield return null;
                simulation.Queries.Complete();
                var found = new FluidPointResult[asked.Length];
                for (int i = 0; i < asked.Length; i++)
                {
                    Assert.That(simulation.Queries.TryGet(asked[i], out found[i]));
                    found[i].Generation = 0;
                }
                Assert.That(simulation.Queries.AnsweredTime, Is.EqualTo(simulation.SimulatedTime));
                runs.Add(found);
                UnityEngine.Object.DestroyImmediate(simulation.gameObject);
            }
            Assert.That(runs[0], Is.EqualTo(runs[1]));
        }

        [UnityTest]
        public IEnumerator MovingAndReadingTenThousandPointsMakesNoGarbage()
        {
            FluidSimulation simulation = rig.Create();
            FluidQueries queries = simulation.Queries;
            var asked = new FluidQuery[10000];
            for (int i = 0; i < asked.Length; i++) asked[i] = queries.AddPoint(new Vector3(0.00001f * i, 0f, 0f));
            long made = -1;
            for (int turn = 0; turn < 3; turn++)
            {
                yield return null;
                yield return null;
                queries.Complete();
                int answered = 0;
                long before = GC.GetAllocatedBytesForCurrentThread();
                for (int i = 0; i < asked.Length; i++)
                {
                    queries.Move(asked[i], new Vector3(0.00001f * i, 0.01f * turn, 0f));
                    if (queries.TryGet(asked[i], out FluidPointResult _)) answered++;
                }
                made = GC.GetAllocatedBytesForCurrentThread() - before;
                if (turn > 0) Assert.That(answered, Is.EqualTo(asked.Length));
            }
            Assert.That(made, Is.Zero);
        }

        [UnityTest]
        public IEnumerator ShadersThatCannotAnswerAreNamedAndOthersServeAfterANewStart()
        {
            FluidShaderSet whole = rig.Profile.Shaders, incomplete = TestShaders.Without(whole, "AnswerPoints");
            rig.Profile.Shaders = incomplete;
            FluidSimulation simulation = rig.Create();
            FluidQuery query = simulation.Queries.AddPoint(Vector3.zero);
            LogAssert.Expect(LogType.Warning, new System.Text.RegularExpressions.Regex("Fluid queries are not answered"));
            yield return null;
            yield return null;
            yield return null;
            Assert.That(simulation.IsRunning);
            Assert.That(simulation.Queries.TryGet(query, out _), Is.False);
            Assert.That(simulation.Queries.GpuBytes, Is.Zero);
            rig.Profile.Shaders = whole;
            simulation.ResetSimulation();
            yield return null;
            yield return null;
            simulation.Queries.Complete();
            Assert.That(simulation.Queries.TryGet(query, out FluidPointResult result));
            Assert.That(result.IsWet);
            Assert.That(simulation.Queries.GpuBytes, Is.EqualTo(1024 * (16 + 32)));
            UnityEngine.Object.DestroyImmediate(incomplete);
        }

        [Test]
        public void PlacesThatAreNotFiniteAreRefused() =>
            Assert.That(() => rig.Create().Queries.AddPoint(new Vector3(0f, float.NaN, 0f)), Throws.ArgumentException.With.Message.Contains("not finite"));
    }
}
