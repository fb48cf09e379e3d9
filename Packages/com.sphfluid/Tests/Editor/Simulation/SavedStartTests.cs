using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A relaxed start that was saved is found again by the same liquid, and by no other.</summary>
    public sealed class SavedStartTests
    {
        private static readonly FluidObstacle[] None = Array.Empty<FluidObstacle>();

        [Test]
        public void TheSameLiquidFindsItWithItsVelocities()
        {
            FluidParticle[] sites = Sites(0f), rested = Sites(-0.013f);
            byte[] bytes = new SavedStart(Water(), sites, None).Write(rested);
            FluidParticle[] moving = sites.Select(p => new FluidParticle(p.Position, Vector3.right, p.Id)).ToArray();
            Assert.That(new SavedStart(Water(), moving, None).TryRead(bytes, out FluidParticle[] found));
            for (int i = 0; i < found.Length; i++)
            {
                Assert.That((found[i].Position - rested[i].Position).magnitude, Is.LessThan(2e-6f), "half of a step");
                Assert.That(found[i].VelT0, Is.EqualTo(Vector3.right));
            }
            new SavedStart(Water(), sites, None).TryRead(new SavedStart(Water(), sites, None).Write(found), out FluidParticle[] again);
            Assert.That(again.Select(p => p.Position), Is.EqualTo(found.Select(p => p.Position)), "saving it again changes nothing");
        }

        [Test]
        public void AnotherLiquidOrVesselDoesNot()
        {
            FluidParticle[] sites = Sites(0f);
            byte[] bytes = new SavedStart(Water(), sites, None).Write(sites);
            FluidSolverSettings stiff = Water().WithSoundSpeed(1.01f * Water().SoundSpeed), heavy = Water();
            heavy.Gravity *= 1.01f;
            var ball = new[] { new FluidObstacle(default, 0.1f, TestMeshes.Sphere(0.1f, 1e-3f)) };
            Assert.That(Finds(stiff, sites, None, bytes), Is.False, "sound");
            Assert.That(Finds(heavy, sites, None, bytes), Is.False, "gravity");
            Assert.That(Finds(Water(), Sites(0.001f), None, bytes), Is.False, "places");
            Assert.That(Finds(Water(), sites.Skip(1).ToArray(), None, bytes), Is.False, "count");
            Assert.That(Finds(Water(), sites, ball, bytes), Is.False, "a collider");
            Assert.That(Finds(Water(), sites, None, bytes.Take(bytes.Length / 2).ToArray()), Is.False, "half a file");
            Assert.That(Finds(Water(), sites, None, bytes));
        }

        private static bool Finds(in FluidSolverSettings settings, FluidParticle[] sites, IReadOnlyList<FluidObstacle> solids,
            byte[] bytes) => new SavedStart(settings, sites, solids).TryRead(bytes, out _);

        private static FluidSolverSettings Water() => BodyRig.Water(Vector3.one, 0.1f, 0.5f);

        private static FluidParticle[] Sites(float lower) => Enumerable.Range(0, 60)
            .Select(i => new FluidParticle(new Vector3(0.1f * (i % 5), 0.1f * (i / 5 % 4) + lower * (i % 7), 0.1f * (i / 20)),
                Vector3.zero, (uint)i)).ToArray();
    }
}
