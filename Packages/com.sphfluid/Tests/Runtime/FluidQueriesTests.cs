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
        private SimulationRig rig;

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
            FluidQuery inside = simulation.Queries.AddPoint(new Vector3(2f, 1f, 0f)),
                above = simulation.Queries.AddPoint(new Vector3(2f, 1.19f, 0f)),
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
        public IEnumerator RaysAndBoxesAreAnsweredBesidePoints()
        {
            FluidSimulation simulation = rig.Create(position: new Vector3(2f, 1f, 0f));
            simulation.UseSceneGravity = false;
            simulation.Gravity = Vector3.zero;
            yield return null;
            simulation.StartSimulation();
            FluidQueries queries = simulation.Queries;
            FluidQuery box = queries.AddBox(new Vector3(2f, 1f, 0f), new Vector3(0.4f, 0.4f, 0.4f), Quaternion.identity);
            FluidQuery point = queries.AddPoint(new Vector3(2f, 1f, 0f));
            FluidQuery ray = queries.AddRay(new Vector3(2.01f, 1.19f, 0.01f), 3f * Vector3.down, 1f),
                half = queries.AddBox(new Vector3(2f, 1.1f, 0f), 0.1f * Vector3.one, Quaternion.identity);
            for (int i = 0; i < 3; i++) yield return null;
            queries.Complete();
            Assert.That(queries.Points.Length, Is.EqualTo(1));
            Assert.That(queries.Count, Is.EqualTo(4));
            Assert.That(queries.TryGetBox(box, out FluidBoxResult all));
            Assert.That(all.Volume, Is.EqualTo(0.008f).Within(1e-6f));
            Assert.That(all.Particles, Is.EqualTo(64));
            Assert.That(all.Fill, Is.EqualTo(0.125f).Within(0.003f));
            Assert.That(queries.TryGetBox(half, out FluidBoxResult upper));
            Assert.That(upper.Volume / 0.001f, Is.EqualTo(0.5f).Within(0.01f));
            Assert.That(queries.TryGetRay(ray, out FluidRayResult surface));
            Assert.That(surface.IsHit);
            Assert.That(surface.Place.y, Is.EqualTo(1.1f).Within(0.25f * SimulationRig.Spacing));
            Assert.That(queries.TryGet(point, out FluidPointResult inside) && inside.IsWet);
            Assert.That(queries.TryGet(box, out _) || queries.TryGet(ray, out _) || queries.TryGetBox(ray, out _) ||
                queries.TryGetRay(point, out _), Is.False, "another kind");

            queries.Move(box, new Vector3(2f, 1f, 0f), 0.1f * Vector3.one, Quaternion.Euler(0f, 90f, 0f));
            queries.Move(ray, new Vector3(2f, 0.81f, 0f), Vector3.up, 1f);
            queries.Remove(point);
            for (int i = 0; i < 3; i++) yield return null;
            queries.Complete();
            Assert.That(queries.TryGetBox(box, out all) && all.Fill > 0.95f, $"{all.Fill}");
            Assert.That(queries.TryGetRay(ray, out surface) && Mathf.Abs(surface.Place.y - 0.9f) < 0.25f * SimulationRig.Spacing,
                $"{surface.Place}");
            Assert.That(queries.TryGet(point, out _), Is.False);
        }

        [UnityTest]
        public IEnumerator RaysAndBoxesThatAreNoneAreRefused()
        {
            FluidSimulation simulation = rig.Create();
            FluidQueries queries = simulation.Queries;
            yield return null;
            Assert.That(() => queries.AddRay(Vector3.zero, Vector3.zero, 1f), Throws.ArgumentException.With.Message.Contains("direction"));
            Assert.That(() => queries.AddRay(Vector3.zero, Vector3.up, 0f), Throws.ArgumentException.With.Message.Contains("length"));
            Assert.That(() => queries.AddRay(new Vector3(float.NaN, 0f, 0f), Vector3.up, 1f), Throws.ArgumentException);
            Assert.That(() => queries.AddBox(Vector3.zero, new Vector3(1f, 0f, 1f), Quaternion.identity),
                Throws.ArgumentException.With.Message.Contains("edge lengths"));
            Assert.That(() => queries.AddBox(Vector3.zero, Vector3.one, default),
                Throws.ArgumentException.With.Message.Contains("rotation"));
            FluidQuery ray = queries.AddRay(Vector3.zero, Vector3.up, float.PositiveInfinity);
            Assert.That(() => queries.Move(ray, Vector3.zero), Throws.ArgumentException.With.Message.Contains("no point's"));
            Assert.That(() => queries.Move(ray, Vector3.zero, Vector3.one, Quaternion.identity),
                Throws.ArgumentException.With.Message.Contains("no box's"));
            queries.Remove(ray);
            Assert.That(() => queries.Move(ray, Vector3.zero, Vector3.up, 1f), Throws.ArgumentException.With.Message.Contains("removed"));
            Assert.That(queries.Count, Is.Zero);
        }

        [UnityTest]
        public IEnumerator TheNearestParticleAndTheFlowThroughRectanglesAreAnswered()
        {
            FluidSimulation simulation = rig.Create(position: new Vector3(2f, 1f, 0f));
            yield return null;
            simulation.StartSimulation();
            FluidQueries queries = simulation.Queries;
            Quaternion down = Quaternion.LookRotation(Vector3.down, Vector3.forward);
            FluidQuery near = queries.AddNearest(new Vector3(2f, 1.3f, 0f), 0.25f),
                far = queries.AddNearest(new Vector3(2f, 1.3f, 0f), 0.1f);
            // The block of 64 particles falls through the first and not beside it.
            FluidQuery below = queries.AddPatch(new Vector3(2f, 0.89f, 0f), new Vector2(0.4f, 0.4f), down);
            FluidQuery turned = queries.AddPatch(new Vector3(2f, 0.89f, 0f), new Vector2(0.4f, 0.4f), Quaternion.Inverse(down));
            FluidQuery beside = queries.AddPatch(new Vector3(2.3f, 0.89f, 0f), new Vector2(0.15f, 0.4f), down);
            for (int i = 0; i < 3; i++) yield return null;
            queries.Complete();
            Assert.That(queries.TryGetNearest(near, out FluidNearestResult found) && found.IsFound);
            Assert.That(found.Distance, Is.EqualTo(0.23f).Within(0.03f));
            Assert.That((found.Place - new Vector3(2f, 1.3f, 0f)).magnitude, Is.EqualTo(found.Distance).Within(1e-5f));
            Assert.That(found.Velocity.y, Is.Negative);
            Assert.That(queries.TryGetNearest(far, out found) && !found.IsFound);
            Assert.That(queries.TryGet(near, out _) || queries.TryGetPatch(near, out _) || queries.TryGetNearest(below, out _), Is.False,
                "another kind");
            for (int i = 0; i < 22; i++) yield return null;
            queries.Complete();
            Assert.That(queries.TryGetPatch(below, out FluidPatchResult passed));
            Assert.That(passed.Particles, Is.EqualTo(64).Within(16), "it has not splashed up yet");
            Assert.That(passed.Volume, Is.EqualTo(passed.Particles * Mathf.Pow(SimulationRig.Spacing, 3f)).Within(1e-6f));
            Assert.That(queries.TryGetPatch(turned, out FluidPatchResult back));
            Assert.That((back.Particles, back.Forward), Is.EqualTo((-passed.Particles, passed.Backward)));
            Assert.That(queries.TryGetPatch(beside, out FluidPatchResult none) && none.Particles == 0);

            // What a rectangle passes over went through it.
            queries.Move(turned, new Vector3(2f, 1.15f, 0f), new Vector2(0.4f, 0.4f), Quaternion.Inverse(down));
            queries.Move(near, new Vector3(2f, 0.8f, 0f), 1f);
            queries.Remove(below);
            for (int i = 0; i < 3; i++) yield return null;
            queries.Complete();
            Assert.That(queries.TryGetPatch(turned, out back) && Math.Abs(back.Particles + 64) <= 2, $"{back.Particles}");
            Assert.That(queries.TryGetNearest(near, out found) && found.IsFound);
            Assert.That(queries.TryGetPatch(below, out _), Is.False);
        }

        [UnityTest]
        public IEnumerator NearestAndRectanglesThatAreNoneAreRefused()
        {
            FluidQueries queries = rig.Create().Queries;
            yield return null;
            Assert.That(() => queries.AddNearest(Vector3.zero, 0f),
                Throws.ArgumentException.With.Message.Contains("distance is 0; it must be a positive number"));
            Assert.That(() => queries.AddNearest(new Vector3(0f, float.NaN, 0f), 1f),
                Throws.ArgumentException.With.Message.Contains("finite"));
            Assert.That(() => queries.AddPatch(Vector3.zero, new Vector2(1f, 0f), Quaternion.identity),
                Throws.ArgumentException.With.Message.Contains("edge lengths"));
            Assert.That(() => queries.AddPatch(Vector3.zero, Vector2.one, default),
                Throws.ArgumentException.With.Message.Contains("rotation"));
            FluidQuery point = queries.AddPoint(Vector3.zero);
            Assert.That(() => queries.Move(point, Vector3.zero, 1f),
                Throws.ArgumentException.With.Message.Contains("no nearest particle's"));
            Assert.That(() => queries.Move(point, Vector3.zero, Vector2.one, Quaternion.identity),
                Throws.ArgumentException.With.Message.Contains("no rectangle's"));
        }

        [UnityTest]
        public IEnumerator LiquidOfTheThesisMethodAnswersToo()
        {
            FluidSimulation simulation = rig.Create();
            simulation.Method = FluidMethodKind.Thesis;
            yield return null;
            simulation.StartSimulation();
            FluidQueries queries = simulation.Queries;
            FluidQuery point = queries.AddPoint(Vector3.zero), ray = queries.AddRay(0.19f * Vector3.up, Vector3.down, 1f),
                near = queries.AddNearest(Vector3.zero, 1f);
            FluidQuery box = queries.AddBox(Vector3.zero, 0.4f * Vector3.one, Quaternion.identity),
                patch = queries.AddPatch(Vector3.zero, 0.4f * Vector2.one, Quaternion.LookRotation(Vector3.down, Vector3.forward));
            for (int i = 0; i < 6; i++) yield return null;
            queries.Complete();
            Assert.That(queries.TryGet(point, out FluidPointResult inside) && inside.IsWet);
            Assert.That(queries.TryGetRay(ray, out FluidRayResult hit) && hit.IsHit);
            Assert.That(queries.TryGetNearest(near, out FluidNearestResult nearest) && nearest.IsFound);
            Assert.That(queries.TryGetBox(box, out FluidBoxResult all) && all.Particles == 64, $"{all.Particles}");
            Assert.That(queries.TryGetPatch(patch, out _));
        }

        // What a command buffer and a read-back take belongs to the engine, and does not depend on the number of points.
        [UnityTest]
        public IEnumerator AskingTenThousandPointsAFrameMakesNoMoreGarbageThanAskingTen()
        {
            FluidSimulation simulation = rig.Create();
            yield return null;
            simulation.StartSimulation();
            FluidQueries queries = simulation.Queries;
            var made = new List<long>();
            foreach (int count in new[] { 10, 10000 })
            {
                while (queries.Count < count) queries.AddPoint(new Vector3(0.00001f * queries.Count, 0f, 0f));
                long least = long.MaxValue;
                for (int turn = 0; turn < 8; turn++)
                {
                    yield return null;
                    queries.Complete();
                    long before = GC.GetAllocatedBytesForCurrentThread();
                    queries.Ask(simulation.Solver, rig.Profile.Shaders, simulation.SimulatedTime, Vector3.zero, Quaternion.identity);
                    least = Math.Min(least, GC.GetAllocatedBytesForCurrentThread() - before);
                }
                made.Add(least);
            }
            Assert.That(made[1], Is.EqualTo(made[0]));
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
            Assert.That(() => rig.Create().Queries.AddPoint(new Vector3(0f, float.NaN, 0f)),
                Throws.ArgumentException.With.Message.Contains("world is (0.00, NaN, 0.00); it must be three finite numbers"));
    }
}
