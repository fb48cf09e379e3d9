using System;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>AnswerRays against liquids whose surface is known.</summary>
    public sealed class AnswerRaysTests
    {
        private const float Spacing = 0.02f;

        // A pool of 20 layers: its surface is half a spacing above the highest.
        private static readonly Vector3Int Pool = new Vector3Int(26, 20, 24);
        private static readonly Vector3 Domain = new Vector3(26, 40, 24) * Spacing;
        private const float Level = 0f;

        private static QueryWord[] Words(int count, Func<int, (Vector3 origin, Vector3 direction, float length)> ray)
        {
            var words = new QueryWord[AnswerRaysPass.Words * count];
            for (int i = 0; i < count; i++)
            {
                (Vector3 origin, Vector3 direction, float length) = ray(i);
                words[2 * i] = new QueryWord { Vector = QueryRig.World(origin), Number = (uint)(i + 1) };
                words[2 * i + 1] = new QueryWord(QueryRig.Turn * direction.normalized, length);
            }
            return words;
        }

        private static FluidRayResult[] Ask(int count, Func<int, (Vector3, Vector3, float)> ray, FluidAxes periodic = FluidAxes.None)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, Spacing);
            settings.Boundaries.Periodic = periodic;
            FluidParticle[] particles = ParticleSets.Lattice(Pool, Spacing, 0f, 1);
            for (int i = 0; i < particles.Length; i++) particles[i].Position.y -= 10 * Spacing;
            using (var rig = new QueryRig(settings, particles))
            {
                var pass = new AnswerRaysPass(rig.Shaders);
                return rig.Ask<FluidRayResult>(Words(count, ray), count, 3,
                    (cmd, target, queries) => pass.Record(cmd, target, queries, count, 3));
            }
        }

        [TestCase(0)]
        [TestCase(1)]
        [TestCase(255)]
        [TestCase(257)]
        public void RaysDownFindTheLevelOfAPool(int count)
        {
            var random = new System.Random(2);
            var places = new Vector3[count];
            for (int i = 0; i < count; i++) places[i] = At(random);
            FluidRayResult[] found = Ask(count, i => (places[i], Vector3.down, 5f));
            for (int i = 0; i < count; i++)
            {
                Assert.That(found[i].Generation, Is.EqualTo(i + 1));
                Assert.That(found[i].IsHit);
                float height = (Quaternion.Inverse(QueryRig.Turn) * (found[i].Place - QueryRig.Place)).y;
                Assert.That(height, Is.EqualTo(Level).Within(0.25f * Spacing), $"below {places[i]}");
                Assert.That(found[i].Distance, Is.EqualTo(places[i].y - height).Within(1e-5f));
                Assert.That(Vector3.Angle(found[i].Normal, QueryRig.Turn * Vector3.up), Is.LessThan(6f), $"normal below {places[i]}");
            }
        }

        // Above the pool, up to the domain's faces along x and z; some begin above the domain.
        private static Vector3 At(System.Random random) => new Vector3(
            ((float)random.NextDouble() - 0.5f) * 0.999f * Domain.x, 0.05f + (float)random.NextDouble(),
            ((float)random.NextDouble() - 0.5f) * 0.999f * Domain.z);

        [Test]
        public void WhatARayCannotReachItDoesNotMeet()
        {
            (Vector3, Vector3, float)[] rays =
            {
                (new Vector3(0f, 0.2f, 0f), Vector3.up, 5f), // away from the water
                (new Vector3(0f, 0.2f, 0f), Vector3.down, 0.15f), // too short
                (new Vector3(0f, 0.2f, 0f), Vector3.down, 0.25f),
                (new Vector3(3f, 0.2f, 0f), Vector3.down, 5f), // beside the domain
                (new Vector3(0f, 0.1f, 0f), new Vector3(1f, -0.001f, 0f), 5f), // over the water to the wall
                (new Vector3(0.05f, -0.1f, 0.02f), Vector3.down, 1f), // begins in it
                (new Vector3(-1f, -0.1f, 0f), Vector3.right, 5f), // through the domain's face: the water stands at it
            };
            FluidRayResult[] found = Ask(rays.Length, i => rays[i]);
            Assert.That(Array.ConvertAll(found, r => r.IsHit), Is.EqualTo(new[] { false, false, true, false, false, true, true }));
            Assert.That(found[0].Distance, Is.EqualTo(-1f));
            Assert.That(found[0].Place, Is.EqualTo(QueryRig.World(new Vector3(0f, 0.2f, 0f))));
            Assert.That(found[5].Distance, Is.Zero);
            Assert.That(found[6].Distance, Is.EqualTo(1f - 0.5f * Domain.x).Within(1e-4f));
        }

        [Test]
        public void ObliqueRaysMeetTheSamePlane([Values(FluidAxes.None, FluidAxes.X | FluidAxes.Z)] FluidAxes periodic)
        {
            const int count = 61;
            FluidRayResult[] found = Ask(count,
                i => (new Vector3(0.1f, 0.15f, -0.05f), new Vector3(Mathf.Sin(i) * 0.8f, -1f, Mathf.Cos(i) * 0.8f), 5f), periodic);
            foreach (FluidRayResult result in found)
            {
                Assert.That((Quaternion.Inverse(QueryRig.Turn) * (result.Place - QueryRig.Place)).y,
                    Is.EqualTo(Level).Within(0.25f * Spacing));
            }
        }
    }
}
