using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>StandardDensity on particles that the test sorts, against sums over all pairs in double.</summary>
    public sealed class StandardDensityTests
    {
        private const float Spacing = 0.05f;
        private const int MaxDensity = 15; // COUNTER_MAX_DENSITY

        private static readonly Vector2 Canary = new Vector2(-7f, -8f);
        private static readonly Vector3 Domain = new Vector3(0.4f, 0.5f, 0.35f);

        [Test]
        public void DensityAndPressureAreTheSumsOverAllPairs(
            [Values(1, 63, 64, 65, 257, 1009)] int count,
            [Values(FluidAxes.None, FluidAxes.X | FluidAxes.Z)] FluidAxes periodic, [Values] bool clamp)
        {
            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing, periodic);
            settings.PressureClamp = clamp;
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, Domain, 1f, 3));
                Vector2[] terms = Record(rig);
                AssertTerms(terms, particles, settings);
                float largest = terms.Max(t => t.x);
                Assert.That(rig.Counters()[MaxDensity], Is.EqualTo(StandardStateRig.ToBits(largest)));
            }
        }

        [Test]
        public void NeighboursAreCountedAndListedAsFarAsTheListHoldsThem(
            [Values(1, 31, 32, 33, 257, 1009)] int count, [Values(FluidAxes.None, FluidAxes.All)] FluidAxes periodic)
        {
            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing, periodic);
            using (var rig = new StandardStateRig(settings, count))
            {
                // A clump among others: some lists are full.
                FluidParticle[] all = ParticleSets.Random(count, Domain, 1f, 5);
                for (int i = 0; i < count / 4; i++) all[i].Position *= 0.2f;
                FluidParticle[] particles = rig.FillSorted(all);
                Record(rig);
                NeighbourList list = rig.State.List;
                uint[] counts = list.Counts.Read<uint>(count);
                uint[] words = GpuTest.Read<uint>(list.Neighbours, (count + 31) / 32 * 32 * NeighbourList.ColumnWords(list.Length));
                for (int i = 0; i < count; i++)
                {
                    // Within R but for rounding.
                    HashSet<int> surely = Within(particles, i, settings, 1.0 - 1e-6);
                    HashSet<int> perhaps = Within(particles, i, settings, 1.0 + 1e-6);
                    if (counts[i] <= list.Length)
                    {
                        Assert.That(counts[i], Is.InRange(surely.Count, perhaps.Count), $"neighbours of {i}");
                        List<int> found = counts[i] > 0u ? ListColumns.Read(words, i, list.Length) : new List<int>();
                        Assert.That(found.Count, Is.EqualTo(counts[i]), $"neighbours of {i} are listed once each");
                        Assert.That(found.ToHashSet().IsSubsetOf(perhaps) && surely.IsSubsetOf(found), Is.True, $"list of {i}");
                    }
                    else
                    {
                        // Eight runs at most where axes are periodic, and each may end with half a pair.
                        int most = Math.Max(list.Length + 1, perhaps.Count);
                        Assert.That(counts[i], Is.InRange(surely.Count, most), $"neighbours of {i}");
                        int room = list.Length - (periodic == FluidAxes.None ? 0 : 24);
                        Assert.That(perhaps.Count, Is.GreaterThan(room), $"a list holds the neighbours of {i}");
                    }
                }

                if (count == 1009) Assert.That(counts.Max(), Is.GreaterThan(list.Length), "some have more than a list holds");
            }
        }

        [Test]
        public void ParticlesThatLeftTheDomainHaveNoPartInIt()
        {
            const int count = 129;
            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing);
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] all = ParticleSets.Random(count, Domain, 1f, 8);
                for (int i = 0; i < count; i += 3) all[i].Removed = 1f;
                FluidParticle[] live = rig.FillSorted(all).Where(p => !p.IsRemoved).ToArray();
                Vector2[] terms = Record(rig);
                AssertTerms(terms.Take(live.Length).ToArray(), live, settings);
                Assert.That(terms.Skip(live.Length), Is.All.EqualTo(Canary), "no density is written for them");
            }
        }

        // Of every second particle the walls are those of a record that the test makes, in place of the domain's.
        [Test]
        public void AParticleNearATriangleHasTheWallsOfItsRecord()
        {
            const int count = 65;
            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing);
            using (StandardStateRig rig = WalledStateRig.Create(settings, count, out CollisionBodies bodies))
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, Domain, 1f, 4));
                double[] expected = Enumerable.Range(0, count).Select(i =>
                    StandardReference.Density(particles, i, settings)).ToArray();
                var records = new List<StoredWall.Packed>();
                for (int i = 0; i < count; i++)
                {
                    float distance = 0.01f * i * Spacing;
                    float value = 0.007f * i;
                    records.Add(StoredWall.Pack(particles[i].Position, false, value, null, (Vector3.right, distance)));
                    if (i % 2 != 0) continue;
                    double domain = StandardReference.Walls(particles[i].Position, settings);
                    expected[i] += settings.RestDensity * (value - domain) / StandardReference.Response(settings);
                }

                WalledStateRig.SetWalls(rig, records, i => i % 2 == 0);
                Vector2[] terms = Record(rig);
                bodies.Dispose();
                double error = 2e-5 * settings.RestDensity;
                for (int i = 0; i < count; i++) Assert.That(terms[i].x, Is.EqualTo(expected[i]).Within(error), $"particle {i}");
            }
        }

        // Faces of a wedge along z whose edge is the origin's: to the right of x = 0 particles see the right one, to the left the left one.
        // In a step that sorts and in three that keep the list; in the second of these the planes are no faces. A blunt wedge parts no
        // liquid.
        [TestCase(0f, true)]
        [TestCase(55f, true)]
        [TestCase(65f, false)]
        [TestCase(90f, false)]
        [TestCase(170f, false)]
        public void LiquidBehindFacesThatLookAgainstEachOtherAddsNothing(float angle, bool parts)
        {
            const int count = 257;
            Vector3 toRight = Quaternion.Euler(0f, 0f, 0.5f * angle) * Vector3.right, toLeft = new Vector3(-toRight.x, toRight.y, 0f);
            Vector3 Face(Vector3 place) => place.x > 0f ? toRight : toLeft;
            bool IsHidden(Vector3 one, Vector3 other) =>
                one.x > 0f != other.x > 0f && Vector3.Dot(Face(one), other) < 0f && Vector3.Dot(Face(other), one) < 0f;
            bool IsClear(Vector3 place) => // of the rounding of normals
                Mathf.Min(Mathf.Abs(place.x), Mathf.Abs(Vector3.Dot(toRight, place)), Mathf.Abs(Vector3.Dot(toLeft, place))) >
                    1e-3f * Spacing;

            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing);
            using (StandardStateRig rig = WalledStateRig.Create(settings, count, out CollisionBodies bodies))
            using (bodies)
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(2 * count, 0.5f * Domain, 1f, 6)
                    .Where(p => IsClear(p.Position)).Take(count).Select((p, i) => new FluidParticle(p.Position, p.VelT0, (uint)i))
                    .ToArray());
                Assert.That(particles.Sum(p => particles.Count(q => IsHidden(p.Position, q.Position))), Is.GreaterThan(count));
                SetFaces(true);
                AssertDensities(Record(rig), true);
                StandardStateRig.Fill(rig.State.Buffers.NewPositions, particles.Select(p => (Vector4)p.Position).ToArray());
                foreach (bool areFaces in new[] { true, false, true })
                {
                    SetFaces(areFaces);
                    GpuTest.Run(cmd => new StandardDensityPass(rig.Shaders).RecordListed(cmd, rig.State, rig.State.Buffers.NewPositions));
                    AssertDensities(rig.Terms(), areFaces);
                }

                void SetFaces(bool areFaces) =>
                    WalledStateRig.SetWalls(rig, particles.Select(p =>
                        StoredWall.Pack(p.Position, areFaces, 0f, null, (Face(p.Position), Vector3.Dot(Face(p.Position), p.Position))))
                        .ToList());

                void AssertDensities(Vector2[] terms, bool areFaces)
                {
                    for (int i = 0; i < terms.Length; i++)
                    {
                        FluidParticle[] seen = particles.Where(p => !(areFaces && parts && IsHidden(particles[i].Position, p.Position)))
                            .ToArray();
                        int own = Array.FindIndex(seen, p => p.Id == particles[i].Id);
                        double walls = StandardReference.Walls(particles[i].Position, settings);
                        double expected = StandardReference.Density(seen, own, settings) -
                            settings.RestDensity * walls / StandardReference.Response(settings);
                        Assert.That(terms[i].x, Is.EqualTo(expected).Within(2e-5 * settings.RestDensity),
                            $"particle {i}, faces: {areFaces}");
                    }
                }
            }
        }

        // Steps after the sort each particle is elsewhere; the pairs are still those of the sort.
        [Test]
        public void ListedDensityIsTheSumOverTheListAtPresentPlaces(
            [Values(1, 63, 64, 65, 257, 1009)] int count, [Values(FluidAxes.None, FluidAxes.X | FluidAxes.Z)] FluidAxes periodic)
        {
            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing, periodic);
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] all = ParticleSets.Random(count, Domain, 1f, 3);
                for (int i = 0; i < count / 5; i++) all[i].Position *= 0.15f; // more than a list holds
                FluidParticle[] sorted = rig.FillSorted(all);
                Record(rig);
                uint[] counts = rig.State.List.Counts.Read<uint>(count);
                var random = new System.Random(count);
                FluidParticle[] moved = sorted.Select(p =>
                {
                    p.Position += 0.05f * Spacing * ParticleSets.RandomVector(random);
                    p.Position = Vector3.Max(Vector3.Min(p.Position, 0.5f * Domain), -0.5f * Domain);
                    return p;
                }).ToArray();
                StandardStateRig.Fill(rig.State.Buffers.NewPositions, moved.Select(p => (Vector4)p.Position).ToArray());
                GpuTest.Run(cmd => new StandardDensityPass(rig.Shaders).RecordListed(cmd, rig.State, rig.State.Buffers.NewPositions));
                Vector2[] terms = rig.Terms();
                Vector4[] places = GpuTest.Read<Vector4>(rig.State.Buffers.PositionTerms, count);
                Assert.That(places.Select(p => (Vector3)p), Is.EqualTo(moved.Select(p => p.Position)));

                // Who came within R since the sort is missing; of a listed particle that is all that is.
                double rest = settings.RestDensity;
                for (int i = 0; i < count; i++)
                {
                    double late = 0.0;
                    bool isListed = counts[i] <= rig.State.List.Length;
                    for (int j = 0; j < count && isListed; j++)
                    {
                        double before = ThesisReference.Separation(sorted[i], sorted[j], settings.PeriodLength).Length;
                        double now = ThesisReference.Separation(moved[i], moved[j], settings.PeriodLength).Length;
                        if (j != i && before >= settings.SupportRadius && now < settings.SupportRadius)
                        {
                            late += settings.ParticleMass * StandardReference.Kernel(now, settings.SupportRadius);
                        }
                    }
                    double expected = StandardReference.Density(moved, i, settings) - late / StandardReference.Response(settings);
                    Assert.That(terms[i].x, Is.EqualTo(expected).Within(3e-5 * Math.Max(rest, expected)), $"density of {i}");
                }
            }
        }

        // What the density was a step before: unknown, within what it may grow by, further down, and above.
        [Test]
        public void PressureIsThatOfADensityAheadWhereItGrowsFast([Values] bool listed)
        {
            const int count = 257;
            FluidSolverSettings settings = StandardStateRig.Water(Domain, Spacing, FluidAxes.None);
            using (var rig = new StandardStateRig(settings, count))
            {
                FluidParticle[] particles = rig.FillSorted(ParticleSets.Random(count, Domain, 1f, 3));
                float[] densities = Record(rig).Select(t => t.x).ToArray();
                float Before(int i) => i % 4 == 0 ? 0f : densities[i] * (i % 4 == 1 ? 0.99f : i % 4 == 2 ? 0.9f : 1.1f);
                Vector4[] places = particles.Select((p, i) => StandardStateRig.WithW(p.Position, Before(i))).ToArray();
                float free = 0.02f * settings.RestDensity;
                rig.State.Impact = new Vector2(0.5f, free);
                StandardStateRig.Fill(listed ? rig.State.Buffers.NewPositions : rig.State.Buffers.PositionTerms, places);
                var pass = new StandardDensityPass(rig.Shaders);
                GpuTest.Run(cmd =>
                {
                    if (listed) pass.RecordListed(cmd, rig.State, rig.State.Buffers.NewPositions);
                    else pass.Record(cmd, rig.State);
                });
                Vector2[] terms = rig.Terms();
                double c2 = settings.SoundSpeed * (double)settings.SoundSpeed;
                for (int i = 0; i < count; i++)
                {
                    double growth = Before(i) > 0f ? Math.Max(densities[i] - Before(i) - free, 0.0) : 0.0;
                    double pressure = c2 * Math.Max(densities[i] + 0.5 * growth - settings.RestDensity, 0.0);
                    Assert.That((double)terms[i].y * terms[i].x * terms[i].x,
                        Is.EqualTo(pressure).Within(1e-4 * c2 * Math.Max(settings.RestDensity, densities[i])), $"pressure of {i}");
                }
            }
        }

        private static Vector2[] Record(StandardStateRig rig)
        {
            int count = rig.State.ParticleCount;
            rig.SetTerms(Enumerable.Repeat(Canary, count).ToArray());
            var pass = new StandardDensityPass(rig.Shaders);
            GpuTest.Run(cmd => pass.Record(cmd, rig.State));
            return rig.Terms();
        }

        private static void AssertTerms(Vector2[] terms, FluidParticle[] particles, in FluidSolverSettings settings)
        {
            double rest = settings.RestDensity, c2 = settings.SoundSpeed * (double)settings.SoundSpeed;
            for (int i = 0; i < terms.Length; i++)
            {
                double density = StandardReference.Density(particles, i, settings);
                Assert.That(terms[i].x, Is.EqualTo(density).Within(2e-5 * Math.Max(rest, density)), $"density of {i}");
                double pressure = c2 * Math.Max(density - rest, settings.PressureClamp ? 0.0 : -rest);
                double measured = (double)terms[i].y * terms[i].x * terms[i].x;
                double error = 4e-5 * c2 * Math.Max(rest, density);
                Assert.That(measured, Is.EqualTo(pressure).Within(error), $"pressure of {i}");
            }
        }

        // Indices of the particles within a part of R, the particle itself left out.
        private static HashSet<int> Within(FluidParticle[] particles, int i, FluidSolverSettings settings, double part) =>
            new HashSet<int>(Enumerable.Range(0, particles.Length).Where(j => j != i && ThesisReference.Separation(
                particles[i], particles[j], settings.PeriodLength).Length < part * settings.SupportRadius));
    }
}
