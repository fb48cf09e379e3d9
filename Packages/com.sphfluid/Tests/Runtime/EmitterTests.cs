using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>Liquid that comes and goes, by components and by script.</summary>
    public sealed class EmitterTests
    {
        private const float Spacing = 0.02f;

        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig();

        [TearDown]
        public void TearDown() => rig.Dispose();

        private FluidSimulation Tank(bool gravity, bool liquid = false)
        {
            FluidSimulation simulation = rig.Create("Tank", liquid);
            simulation.DomainSize = new Vector3(0.4f, 0.8f, 0.4f);
            simulation.Spacing = Spacing;
            simulation.UseSceneGravity = gravity;
            simulation.Gravity = Vector3.zero;
            return simulation;
        }

        private FluidEmitter Nozzle(FluidSimulation simulation, Vector3 place, Vector3 direction, float width, float speed)
        {
            GameObject holder = rig.NewObject("Nozzle");
            holder.transform.SetParent(simulation.transform, false);
            holder.transform.localPosition = place;
            holder.transform.localRotation = Quaternion.LookRotation(direction, Vector3.right);
            FluidEmitter emitter = holder.AddComponent<FluidEmitter>();
            emitter.Size = new Vector2(width, width);
            emitter.Speed = speed;
            return emitter;
        }

        [UnityTest]
        public IEnumerator ANozzleOfAMeshPoursItsVolumeAtRestDensity()
        {
            FluidSimulation simulation = Tank(false);
            FluidEmitter emitter = Nozzle(simulation, new Vector3(0.03f, -0.3f, -0.01f), new Vector3(0.2f, 1f, 0.1f), 0.13f, 1.3f);
            emitter.Shape = FluidEmitterShape.Mesh;
            TriangleMesh ball = TestMeshes.Sphere(0.5f, 0.005f);
            var mesh = new Mesh { name = "ball", vertices = ball.Vertices, triangles = ball.Indices };
            emitter.Mesh = mesh;
            emitter.transform.localScale = 0.2f * Vector3.one;
            float longest = 0f;
            for (int frame = 0; frame < 20; frame++)
            {
                yield return null;
                if (!simulation.IsRunning) continue;
                float[] density = GpuTest.Read<float>(simulation.Solver.Density, SimulationRig.Read(simulation).Length);
                if (density.Length > 0) longest = Mathf.Max(longest, density.Max());
            }
            FluidParticle[] jet = SimulationRig.Read(simulation);
            int sites = EmitterSites.For(emitter.Spec, Spacing).Places.Length;
            Assert.That(sites, Is.GreaterThan(30));
            double volume = jet.Length * System.Math.Pow(Spacing, 3),
                expected = emitter.Spec.Area(Spacing) * 1.3 * simulation.SimulatedTime;
            Assert.That(volume, Is.EqualTo(expected).Within(1.01 * sites * System.Math.Pow(Spacing, 3)), "one layer");
            Assert.That(longest, Is.LessThan(1010f), "largest density");
            Assert.That(Nearest(jet), Is.GreaterThan(0.9f * Spacing));
            Assert.That(simulation.Solver.ReadCountersNow().Blocked, Is.Zero);
            emitter.enabled = false;
            Object.DestroyImmediate(mesh);
        }

        [UnityTest]
        public IEnumerator AFreeJetHasTheDensityTheSpeedAndTheVolumeOfItsNozzle()
        {
            FluidSimulation simulation = Tank(false);
            FluidEmitter emitter = Nozzle(simulation, new Vector3(0.03f, -0.3f, -0.01f), new Vector3(0.2f, 1f, 0.1f), 0.13f, 1.3f);
            float longest = 0f;
            for (int frame = 0; frame < 30; frame++)
            {
                yield return null;
                if (!simulation.IsRunning) continue;
                FluidParticle[] particles = SimulationRig.Read(simulation);
                float[] density = GpuTest.Read<float>(simulation.Solver.Density, particles.Length);
                if (density.Length > 0) longest = Mathf.Max(longest, density.Max());
            }
            FluidParticle[] jet = SimulationRig.Read(simulation);
            double layer = emitter.Spec.Area(Spacing) * 1.3 * 0.01; // of a frame
            double volume = jet.Length * System.Math.Pow(Spacing, 3),
                expected = emitter.Spec.Area(Spacing) * 1.3 * simulation.SimulatedTime;
            int sites = EmitterSites.For(emitter.Spec, Spacing).Places.Length;
            Assert.That(volume, Is.EqualTo(expected).Within(1.01 * sites * System.Math.Pow(Spacing, 3)), "one layer");
            Assert.That(layer, Is.Positive);
            Assert.That(longest, Is.LessThan(1010f), "largest density");
            Vector3 along = (simulation.transform.InverseTransformDirection(emitter.transform.forward)).normalized;
            foreach (FluidParticle particle in jet)
            {
                Assert.That((particle.VelT0 - 1.3f * along).magnitude, Is.LessThan(0.013f), $"velocity of {particle.Id}");
            }
            Assert.That(Nearest(jet), Is.GreaterThan(0.9f * Spacing));
            FluidCounters counters = simulation.Solver.ReadCountersNow();
            Assert.That((counters.Blocked, counters.Refused), Is.EqualTo((0L, 0L)));
            Assert.That(simulation.Messages.Where(m => m.Severity != FluidSeverity.Info).Select(m => m.ToString()), Is.Empty);
        }

        /// <summary>A fountain of constant number for a minute, twice.</summary>
        [UnityTest, Explicit("Takes minutes.")]
        public IEnumerator AFountainOfConstantNumberRunsForAMinute()
        {
            var runs = new List<(ulong hash, int living, long born, long removed, long blocked, long refused)>();
            for (int run = 0; run < 2; run++)
            {
                Time.captureDeltaTime = 1f / 32f;
                FluidSimulation simulation = Tank(true);
                simulation.DomainSize = new Vector3(0.6f, 0.8f, 0.6f);
                simulation.Spacing = 0.03f;
                simulation.Gravity = 9.81f * Vector3.down;
                simulation.CapacityPolicy = FluidCapacityPolicy.RecycleOldest;
                simulation.Capacity = 1500;
                FluidEmitter jet = Nozzle(simulation, new Vector3(0f, -0.2f, 0f), new Vector3(0.1f, 1f, 0f), 0.09f, 2.5f);
                var counts = new List<int>();
                while (!simulation.IsRunning) yield return null;
                while (simulation.SimulatedTime < 60.0)
                {
                    yield return null;
                    if (simulation.SimulatedTime > 10.0) counts.Add(simulation.ParticleCount);
                }
                FluidCounters counters = simulation.Solver.ReadCountersNow();
                int living = SimulationRig.Read(simulation).Length;
                runs.Add((simulation.ComputeStateHash(), living, counters.Born, counters.Removed, counters.Blocked, counters.Refused));
                TestContext.WriteLine(
                    $"{living} live at the end, {counts.Min()} to {counts.Max()} from 10 s on; born {counters.Born}, left " +
                    $"{counters.Removed}, blocked {counters.Blocked}, refused {counters.Refused}; " +
                    $"emitted {1000.0 * jet.EmittedVolume:f2} l of {1000.0 * jet.Spec.Area(0.03f) * 2.5 * simulation.SimulatedTime:f2} " +
                    $"l; hash {runs[run].hash:X16}");
                Assert.That(counters.Born - counters.Removed, Is.EqualTo(living));
                Assert.That(counts.Max(), Is.LessThanOrEqualTo(1500));
                Assert.That(simulation.Messages.Where(m => m.Severity == FluidSeverity.Error), Is.Empty);
                UnityEngine.Object.DestroyImmediate(jet.gameObject);
                UnityEngine.Object.DestroyImmediate(simulation.gameObject);
            }
            Assert.That(runs[0], Is.EqualTo(runs[1]));
        }

        // Liquid that is set in motion at once is compressed by U/c, 7 % at 1 m/s and the 15 m/s of this tank.
        [UnityTest]
        public IEnumerator ADrownedNozzleWithAPipePumps([Values(FluidEmitterShape.Disc)] FluidEmitterShape shape)
        {
            float speed = shape == FluidEmitterShape.Disc ? 2f : 1f;
            FluidSimulation simulation = Tank(true);
            simulation.DomainSize = new Vector3(0.28f, 0.36f, 0.36f);
            simulation.ExpectedSpeed = 3f;
            simulation.Gravity = 9.81f * Vector3.down;
            FluidVolume water = rig.AddVolume(simulation);
            water.Size = new Vector3(0.28f, 0.26f, 0.36f);
            water.transform.localPosition = new Vector3(0f, -0.05f, 0f);
            FluidEmitter emitter = Nozzle(simulation, new Vector3(0f, -0.06f, -0.08f), Vector3.forward, 0.08f, speed);
            emitter.Shape = shape;
            emitter.UnderWater = true;
            emitter.Stop();
            for (int frame = 0; frame < 8; frame++) yield return null;
            int before = SimulationRig.Read(simulation).Length;
            double begin = simulation.SimulatedTime;
            emitter.Play();
            var dense = new List<float>();
            var lateral = new List<float>();
            float nearest = 1f;
            for (int frame = 0; frame < 22; frame++)
            {
                yield return null;
                FluidParticle[] all = GpuTest.Read<FluidParticle>(simulation.Solver.Particles, simulation.Solver.ParticleCount);
                float[] density = GpuTest.Read<float>(simulation.Solver.Density, all.Length);
                var jet = new List<FluidParticle>();
                float most = 0f;
                for (int i = 0; i < all.Length; i++)
                {
                    Vector3 local = emitter.transform.InverseTransformPoint(simulation.transform.TransformPoint(all[i].Position));
                    if (all[i].IsRemoved || Mathf.Abs(local.x) > 0.08f || Mathf.Abs(local.y) > 0.08f || local.z < -0.05f || local.z > 0.14f)
                    {
                        continue;
                    }
                    most = Mathf.Max(most, density[i]);
                    if (new Vector2(local.x, local.y).magnitude < 0.04f && local.z > 0f && local.z < 0.05f) jet.Add(all[i]);
                }
                if (frame < 12) continue;
                dense.Add(most);
                lateral.AddRange(jet.Select(p => Vector3.ProjectOnPlane(p.VelT0, emitter.transform.forward).sqrMagnitude));
                nearest = Mathf.Min(nearest, Nearest(jet.ToArray()));
            }
            int sites = EmitterSites.For(emitter.Spec, Spacing).Places.Length;
            double expected = emitter.Spec.Area(Spacing) * speed * (simulation.SimulatedTime - begin) / System.Math.Pow(Spacing, 3);
            FluidCounters counters = simulation.Solver.ReadCountersNow();
            float sideways = Mathf.Sqrt(lateral.Average()) / speed;
            TestContext.WriteLine(
                $"{SimulationRig.Read(simulation).Length - before} of {expected:f0} particles in layers of {sites}, {counters.Blocked} " +
                $"blocked; density near the nozzle {dense.Max():f0} at most, {dense.Average():f0} in the mean; " +
                $"sideways {sideways:f3} U, nearest {nearest / Spacing:f2} dx, squeezed {counters.Squeezed}");
            Assert.That(SimulationRig.Read(simulation).Length - before, Is.EqualTo(expected).Within(1.5 * sites),
                "the first layer finds liquid in its place");
            Assert.That(simulation.Messages.Where(m => m.Issue == FluidIssue.EmitterBlocked), Is.Empty, "and nobody is told of it");
            Assert.That(dense.Max(), Is.LessThan(1150f));
            Assert.That(dense.Average(), Is.LessThan(1100f));
            Assert.That(sideways, Is.LessThan(0.3f));
            Assert.That(nearest, Is.GreaterThan(0.5f * Spacing));
            Assert.That(counters.Squeezed + counters.NonFinite, Is.Zero);
        }

        [UnityTest]
        public IEnumerator ANozzleThatStandsInLiquidIsToldOnce()
        {
            FluidSimulation simulation = Tank(false, true);
            Nozzle(simulation, Vector3.zero, Vector3.up, 0.08f, 1f);
            for (int frame = 0; frame < 20; frame++) yield return null;
            Assert.That(simulation.Messages.Single(m => m.Issue == FluidIssue.EmitterBlocked).Text,
                Does.StartWith("Of what the emitter gives 100 % finds no place"));
        }

        // The speed of sound follows the liquid down once nothing comes in any more.
        [UnityTest]
        public IEnumerator AnEmitterThatIsOffIsNotHeldAgainstTheSpeedOfSound()
        {
            FluidSimulation simulation = Tank(false, true);
            FluidEmitter emitter = Nozzle(simulation, 0.3f * Vector3.up, Vector3.down, 0.08f, 0.1f);
            emitter.Stop();
            for (int frame = 0; frame < 3; frame++) yield return null;
            emitter.Speed = 0.5f * simulation.Solver.Settings.SoundSpeed;
            for (int frame = 0; frame < 3; frame++) yield return null;
            Assert.That(simulation.Messages.Where(m => m.Issue == FluidIssue.EmitterInvalid), Is.Empty);
        }

        private static float Nearest(FluidParticle[] particles)
        {
            float nearest = float.PositiveInfinity;
            for (int i = 0; i < particles.Length; i++)
                for (int k = 0; k < i; k++) nearest = Mathf.Min(nearest, (particles[i].Position - particles[k].Position).sqrMagnitude);
            return Mathf.Sqrt(nearest);
        }

        [UnityTest]
        public IEnumerator LiquidOfEachEmitterLeavesAfterItsLifetime()
        {
            FluidSimulation simulation = Tank(false);
            FluidEmitter shortLived = Nozzle(simulation, new Vector3(0.1f, -0.3f, 0f), Vector3.up, 0.08f, 1f),
                longLived = Nozzle(simulation, new Vector3(-0.1f, -0.3f, 0f), Vector3.up, 0.08f, 1f);
            shortLived.Lifetime = 0.1f;
            longLived.Lifetime = 0.25f;
            while (!simulation.IsRunning || simulation.SimulatedTime < 0.2) yield return null;
            Check(simulation, 0.1f, 0.2f, "the first has its full length");
            while (simulation.SimulatedTime < 0.4) yield return null;
            Check(simulation, 0.1f, 0.25f, "both have");
            shortLived.Stop();
            longLived.Stop();
            while (simulation.SimulatedTime < 0.7) yield return null;
            Assert.That(SimulationRig.Read(simulation), Is.Empty);
            FluidCounters counters = simulation.Solver.ReadCountersNow();
            Assert.That(counters.Removed, Is.EqualTo(counters.Born).And.GreaterThan(500));
            Assert.That(simulation.ParticleCount, Is.Zero);
        }

        // At 1 m/s a jet is as long as its liquid is old.
        private static void Check(FluidSimulation simulation, float right, float left, string when)
        {
            FluidParticle[] particles = SimulationRig.Read(simulation);
            float Length(bool isRight) => particles.Where(p => p.Position.x > 0f == isRight).Max(p => p.Position.y) + 0.3f;
            Assert.That(Length(true), Is.EqualTo(right).Within(0.022f), when);
            Assert.That(Length(false), Is.EqualTo(left).Within(0.022f), when);
        }

        [UnityTest]
        public IEnumerator WhatIsPouredDrainsAndTwoRunsAreEqual()
        {
            var ends = new List<FluidParticle[]>();
            for (int run = 0; run < 2; run++)
            {
                FluidSimulation simulation = Tank(true);
                simulation.DomainSize = new Vector3(0.3f, 0.4f, 0.3f);
                simulation.CapacityPolicy = FluidCapacityPolicy.RecycleOldest;
                simulation.Capacity = 500;
                FluidEmitter emitter = Nozzle(simulation, new Vector3(0f, 0.15f, 0f), Vector3.down, 0.08f, 1f);
                emitter.Shape = FluidEmitterShape.Rectangle;
                GameObject holder = rig.NewObject("Drain");
                holder.transform.SetParent(simulation.transform, false);
                holder.transform.localPosition = new Vector3(0.12f, -0.17f, 0.12f);
                FluidDrain drain = holder.AddComponent<FluidDrain>();
                drain.Size = new Vector3(0.06f, 0.06f, 0.06f);
                while (!simulation.IsRunning || simulation.SimulatedTime < 0.9) yield return null;
                FluidCounters counters = simulation.Solver.ReadCountersNow();
                FluidParticle[] particles = SimulationRig.Read(simulation);
                Assert.That(particles.Length, Is.EqualTo(counters.Born - counters.Removed).And.LessThanOrEqualTo(500));
                Assert.That(counters.Born, Is.GreaterThan(650));
                Assert.That(drain.DrainedVolume, Is.GreaterThan(0.0));
                Assert.That(emitter.EmittedVolume, Is.GreaterThan(600 * System.Math.Pow(Spacing, 3)));
                Assert.That(simulation.Messages.Any(m => m.Issue == FluidIssue.CapacityReached), "recycling is reported");
                Assert.That(simulation.Messages.Count(m => m.Issue == FluidIssue.CapacityGrown), Is.EqualTo(1), "so is growth, once");
                ends.Add(particles);
                Object.DestroyImmediate(simulation.gameObject);
            }
            Assert.That(ends[0], Is.EqualTo(ends[1]), "to the last bit");
        }

        [UnityTest]
        public IEnumerator LiquidIsAddedWhereThereIsAPlaceAndRemoved()
        {
            FluidSimulation simulation = Tank(false, true);
            Assert.That(() => simulation.AddLiquid(Vector3.zero, Vector3.one, Quaternion.identity), Throws.InvalidOperationException);
            while (!simulation.IsRunning) yield return null;
            int start = simulation.ParticleCount;
            Assert.That(start, Is.EqualTo(1000));
            int tried = simulation.AddLiquid(new Vector3(0f, 0.1f, 0f), new Vector3(0.2f, 0.2f, 0.2f), Quaternion.identity,
                new Vector3(0f, 0f, 0f));
            Assert.That(tried, Is.EqualTo(1000));
            for (int frame = 0; frame < 5; frame++) yield return null; // one may have no step
            FluidCounters counters = simulation.Solver.ReadCountersNow();
            Assert.That(counters.Born + counters.Blocked, Is.EqualTo(1000));
            Assert.That(counters.Born, Is.InRange(400, 500), "half of it is liquid already, and nobody stands nearer than 0.9 dx");
            Assert.That(simulation.ParticleCount, Is.EqualTo(1000 + counters.Born));
            simulation.RemoveLiquid(simulation.transform.TransformPoint(new Vector3(0f, 0.2f, 0f)), 0.08f);
            for (int frame = 0; frame < 5; frame++) yield return null; // one may have no step
            Assert.That(SimulationRig.Read(simulation).Count(p => (p.Position - new Vector3(0f, 0.2f, 0f)).magnitude < 0.06f), Is.Zero);
            simulation.RemoveLiquid(simulation.transform.position, 2f * Vector3.one, Quaternion.identity);
            for (int frame = 0; frame < 5; frame++) yield return null; // one may have no step
            Assert.That(SimulationRig.Read(simulation), Is.Empty);
            FluidVolume volume = rig.AddVolume(simulation);
            Assert.That(simulation.AddLiquid(volume), Is.EqualTo(1000));
            for (int frame = 0; frame < 5; frame++) yield return null;
            FluidCounters end = simulation.Solver.ReadCountersNow();
            Assert.That((end.Refused, end.Blocked - counters.Blocked), Is.EqualTo((0L, 0L)));
            Assert.That(SimulationRig.Read(simulation).Length, Is.EqualTo(1000));
            Assert.That(simulation.ParticleCount, Is.EqualTo(1000));
        }

        [UnityTest]
        public IEnumerator AVolumeFlowsAndStops()
        {
            FluidSimulation simulation = Tank(true);
            FluidEmitter emitter = Nozzle(simulation, new Vector3(0f, 0.3f, 0f), Vector3.down, 0.08f, 1f);
            emitter.Shape = FluidEmitterShape.Rectangle;
            emitter.Stop();
            for (int frame = 0; frame < 3; frame++) yield return null;
            Assert.That(simulation.IsRunning, "an empty liquid runs where something can pour into it");
            Assert.That((emitter.IsPlaying, simulation.ParticleCount), Is.EqualTo((false, 0)));
            emitter.Play(0.00064f); // 80 particles, 5 layers of 16
            for (int frame = 0; frame < 25; frame++) yield return null;
            Assert.That(emitter.IsPlaying, Is.False);
            Assert.That(SimulationRig.Read(simulation).Length, Is.EqualTo(80));
            Assert.That(emitter.EmittedVolume, Is.EqualTo(0.00064).Within(1e-9));
            Assert.That(() => emitter.Play(0f), Throws.InstanceOf<System.ArgumentOutOfRangeException>());
            emitter.Duration = 0.1f;
            emitter.Play();
            for (int frame = 0; frame < 25; frame++) yield return null;
            Assert.That(SimulationRig.Read(simulation).Length, Is.EqualTo(160));
        }

        [UnityTest]
        public IEnumerator WhatCannotBeIsReported()
        {
            FluidSimulation simulation = Tank(true);
            FluidEmitter emitter = Nozzle(simulation, new Vector3(0f, 0.3f, 0f), Vector3.down, 0.08f, 1f);
            while (!simulation.IsRunning) yield return null;
            emitter.Speed = 1000f;
            LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("Nozzle.*1000 m/s.*quarter.*Expected Speed"));
            yield return null;
            emitter.Speed = float.NaN;
            LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("Nozzle.*flow is NaN"));
            yield return null;
            emitter.Size = new Vector2(0f, 1f);
            LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("Nozzle.*size is 0 x 1 m"));
            yield return null;
            emitter.Size = new Vector2(0.08f, 0.08f);
            emitter.Speed = 1f;
            emitter.transform.localPosition = new Vector3(0f, 3f, 0f);
            LogAssert.Expect(LogType.Warning, new System.Text.RegularExpressions.Regex("Nozzle.*100 % finds no place"));
            for (int frame = 0; frame < 8; frame++) yield return null;
            Assert.That(SimulationRig.Read(simulation).All(p => Mathf.Abs(p.Position.y) <= 0.4f));
        }

        // Ids that are born run on beyond the number of particles.
        [UnityTest]
        public IEnumerator AnEmitterOutsideTheDomainOrInsideAColliderIsNamed()
        {
            FluidSimulation simulation = Tank(true);
            FluidEmitter emitter = Nozzle(simulation, new Vector3(0f, 0.2f, 0f), Vector3.down, 0.13f, 1f);
            yield return null;
            Assert.That(simulation.Validate().Any(m => m.Issue == FluidIssue.EmitterInvalid), Is.False);
            emitter.transform.localPosition = new Vector3(0f, 0.2f, -0.21f);
            FluidMessage outside = simulation.Validate().Single(m => m.Issue == FluidIssue.EmitterInvalid);
            Assert.That(outside.ToString(), Does.Contain("outside the domain of 'Tank'"));
            Assert.That(outside.Severity, Is.EqualTo(FluidSeverity.Warning));
            GameObject tap = rig.NewObject("Tap");
            tap.transform.position = new Vector3(0.1f, 0.3f, 0f);
            tap.AddComponent<BoxCollider>().size = 0.1f * Vector3.one;
            emitter.transform.localPosition = new Vector3(0.1f, 0.26f, 0f);
            Assert.That(simulation.Validate().Single(m => m.Issue == FluidIssue.EmitterInvalid).ToString(),
                Does.Contain("inside the collider of 'Tap'"));
            emitter.transform.localPosition = new Vector3(0.1f, 0.24f, 0f);
            Assert.That(simulation.Validate().Any(m => m.Issue == FluidIssue.EmitterInvalid), Is.False);
        }

        [UnityTest]
        public IEnumerator AfterThePouringTheLiquidSleeps()
        {
            FluidSimulation simulation = rig.Create("Cup", false);
            simulation.DomainSize = new Vector3(0.2f, 0.4f, 0.2f);
            simulation.CapacityPolicy = FluidCapacityPolicy.RecycleOldest;
            simulation.Capacity = 80;
            FluidEmitter emitter = Nozzle(simulation, new Vector3(0f, 0.1f, 0f), Vector3.down, 0.1f, 0.8f);
            emitter.Shape = FluidEmitterShape.Rectangle;
            emitter.Duration = 2f;
            emitter.Play();
            for (int frame = 0; frame < 1200 && !simulation.IsAsleep; frame++)
            {
                yield return null;
                if (frame < 200) Assert.That(simulation.IsAsleep, Is.False, "while liquid flows");
            }
            FluidParticle[] particles = SimulationRig.Read(simulation);
            Assert.That(particles.Length, Is.InRange(55, 80), "a layer of 25 that is blocked has cost the oldest");
            Assert.That(particles.Min(p => p.Id), Is.GreaterThan(20u), "recycled");
            Assert.That(simulation.IsAsleep, $"after {simulation.SimulatedTime} s");
            emitter.Play(0.001f);
            for (int frame = 0; frame < 3; frame++) yield return null;
            Assert.That(simulation.IsAsleep, Is.False);
        }

        [UnityTest]
        public IEnumerator TheThesisMethodSaysThatItsNumberIsFixed()
        {
            FluidSimulation simulation = rig.Create();
            simulation.Method = FluidMethodKind.Thesis;
            Nozzle(simulation, new Vector3(0f, 0.15f, 0f), Vector3.down, 0.1f, 1f);
            LogAssert.Expect(LogType.Warning, new System.Text.RegularExpressions.Regex("fixed number of particles"));
            for (int frame = 0; frame < 3; frame++) yield return null;
            Assert.That(simulation.ParticleCount, Is.EqualTo(64));
            Assert.That(() => simulation.AddLiquid(Vector3.zero, Vector3.one, Quaternion.identity), Throws.InvalidOperationException);
            LogAssert.Expect(LogType.Error, new System.Text.RegularExpressions.Regex("holds no liquid"));
            foreach (FluidVolume volume in SceneObjects.All<FluidVolume>()) volume.enabled = false;
            LogAssert.Expect(LogType.Warning, new System.Text.RegularExpressions.Regex("fixed number of particles"));
            Assert.That(simulation.ResetSimulation(), Is.False, "it does not start in silence without any");
        }
    }
}
