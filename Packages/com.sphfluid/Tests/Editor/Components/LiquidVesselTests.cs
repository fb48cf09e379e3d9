using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A cup of triangles is filled to its level; where it leaks, the place and the level that it holds are reported.</summary>
    public sealed class LiquidVesselTests
    {
        private const float Spacing = 0.04f, Radius = 0.3f, Depth = 0.6f;
        private const int Sides = 32;

        private ColliderRig rig;

        [SetUp]
        public void SetUp() => rig = new ColliderRig { DomainSize = new Vector3(2f, 2f, 2f), Spacing = Spacing };

        [TearDown]
        public void TearDown() => rig.Dispose();

        [TestCase(0f, 0.35f)]
        [TestCase(0f, 0.5f)]
        [TestCase(20f, 0.25f)]
        public void ACupIsFilledToItsLevel(float tilt, float level)
        {
            Quaternion turn = Quaternion.Euler(0f, 0f, tilt);
            AddCup(Depth, turn);
            (LiquidVessel vessel, SpawnResult result) = Fill(level);
            Assert.That(vessel.Leak, Is.Null);
            // The mean depth under a tilted surface is that on the axis: the seed lies a twentieth above the floor.
            double volume = 0.5 * Sides * Math.Sin(2.0 * Math.PI / Sides) * Radius * Radius *
                (level / Math.Cos(tilt * Math.PI / 180.0) + 0.05);
            SpawnTally tally = result.Tallies[0];
            Assert.That(tally.Filled + tally.Carved, Is.EqualTo(volume / Math.Pow(Spacing, 3)).Within(2).Percent);
            Assert.That(tally.Expected, Is.EqualTo(tally.Filled + tally.Carved).Within(0.51));
            foreach (FluidParticle particle in result.Particles)
            {
                Vector3 p = Quaternion.Inverse(turn) * particle.Position;
                Assert.That(new Vector2(p.x, p.z).magnitude, Is.LessThan(Radius));
                Assert.That(p.y, Is.GreaterThan(-0.05f));
                Assert.That(particle.Position.y, Is.LessThan(level + Spacing));
                Assert.That(rig.Scene.FindCovering(particle.Position, 0.29f * Spacing), Is.EqualTo(-1));
            }
            Assert.That(result.Particles.Max(p => p.Position.y), Is.EqualTo(level).Within(Spacing));
        }

        [Test]
        public void ALevelAboveTheRimIsReported()
        {
            AddCup(Depth, Quaternion.identity);
            (LiquidVessel vessel, SpawnResult result) = Fill(0.7f);
            Assert.That(result.Particles, Is.Empty);
            Assert.That(vessel.Leak.Value.HoldsTo, Is.EqualTo(Depth - 0.05f).Within(Spacing));
            Assert.That(vessel.Leak.Value.Position.y, Is.EqualTo(Depth - 0.05f).Within(Spacing));
            Assert.That(Fill(vessel.Leak.Value.HoldsTo).vessel.Leak, Is.Null, "the cure works");
        }

        [Test]
        public void AGapIsFound()
        {
            AddCup(Depth, Quaternion.identity, gap: 5);
            (LiquidVessel vessel, SpawnResult result) = Fill(0.3f);
            Assert.That(result.Particles, Is.Empty);
            Assert.That(vessel.Leak.Value.HoldsTo, Is.Zero);
            Assert.That(vessel.Leak.Value.Position.y, Is.EqualTo(-0.05f).Within(2f * Spacing), "a piece of the floor is missing");
        }

        [Test]
        public void TheDomainHoldsLiquidWhereItIsAskedTo()
        {
            rig.DomainSize = new Vector3(0.4f, 1f, 0.4f);
            Transform floor = rig.AddMesh(TestMeshes.Cube()).transform;
            floor.localScale = new Vector3(2f, 0.2f, 2f);
            floor.localPosition = new Vector3(0f, -0.32f, 0f);
            Assert.That(Fill(0.19f).vessel.Leak, Is.Not.Null);
            SpawnTally tally = Fill(0.19f, domainHolds: true).result.Tallies[0];
            Assert.That(tally.Filled + tally.Carved, Is.EqualTo(10 * 10 * 10.25).Within(1), "from the floor at −0.22 m to 0.19 m");
        }

        [Test]
        public void AnotherSpacingFloodsAgain()
        {
            AddCup(Depth, Quaternion.identity);
            LiquidVessel vessel = Vessel(0.4f, false);
            var request = new SpawnRequest { DomainSize = rig.DomainSize, Spacing = Spacing, Shapes = new[] { vessel } };
            float spacing = ParticleCountFit.Spacing(request, 1000);
            request.Spacing = spacing;
            Assert.That(FluidSpawner.Measure(request).Needed, Is.EqualTo(1000).Within(8).Percent);
        }

        private (LiquidVessel vessel, SpawnResult result) Fill(float level, bool domainHolds = false)
        {
            LiquidVessel vessel = Vessel(level, domainHolds);
            SpawnResult result = FluidSpawner.Fill(new SpawnRequest
            {
                DomainSize = rig.DomainSize, Spacing = Spacing, Shapes = new[] { vessel },
                Obstacle = p => rig.Scene.FindCovering(p, SpawnRequest.ObstacleClearance * Spacing),
            });
            return (vessel, result);
        }

        private LiquidVessel Vessel(float level, bool domainHolds)
        {
            rig.Gather();
            return new LiquidVessel("vessel", new VesselInput
            {
                Up = Vector3.up, Level = level, DomainHolds = domainHolds, DomainSize = rig.DomainSize,
                Colliders = rig.Scene, Clearance = SpawnRequest.ObstacleClearance * Spacing,
            }, Vector3.zero);
        }

        // Single faces, open at the top, the floor a twentieth below the origin; without the floor's triangles from 0 to the gap.
        private void AddCup(float depth, Quaternion turn, int gap = 0)
        {
            var vertices = new Vector3[2 * Sides + 1];
            var indices = new System.Collections.Generic.List<int>();
            vertices[2 * Sides] = turn * new Vector3(0f, -0.05f, 0f);
            for (int i = 0; i < Sides; i++)
            {
                double angle = 2.0 * Math.PI * i / Sides;
                var rim = new Vector3((float)(Radius * Math.Cos(angle)), 0f, (float)(Radius * Math.Sin(angle)));
                vertices[i] = turn * (rim + new Vector3(0f, -0.05f, 0f));
                vertices[Sides + i] = turn * (rim + new Vector3(0f, depth - 0.05f, 0f));
                int next = (i + 1) % Sides;
                indices.AddRange(new[] { i, next, Sides + i, next, Sides + next, Sides + i });
                if (i >= gap) indices.AddRange(new[] { 2 * Sides, i, next });
            }
            rig.AddMesh(new Mesh { name = "Test Cup", vertices = vertices, triangles = indices.ToArray() });
        }
    }
}
