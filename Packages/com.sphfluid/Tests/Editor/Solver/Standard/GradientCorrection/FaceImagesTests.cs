using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>What mirrors in the faces of the domain do for liquid with the gradient correction.</summary>
    public sealed class FaceImagesTests
    {
        private const float Spacing = 0.05f;

        [TestCase(8, 13, 25, 0.005)]
        [TestCase(12, 5, 40, 0.01)]
        public void APoolBetweenWallsComesToRest(int width, int height, int times, double most)
        {
            float depth = height * Spacing;
            var domain = new Vector3(width * Spacing, depth + 4f * Spacing, width * Spacing);
            FluidSolverSettings settings = CorrectionReference.Corrected(BodyRig.Water(domain, Spacing, depth));
            FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(width, height, width), Spacing, 0.02f * Spacing, 1);
            for (int i = 0; i < start.Length; i++) start[i].Position.y -= 2f * Spacing; // onto the floor
            using (var rig = new StandardRig(settings, start))
            {
                rig.Steps((int)(times * Math.Sqrt(depth / 9.81) / settings.TimeStep));
                FluidParticle[] end = rig.Particles();
                double speed = Math.Sqrt(end.Average(p => (double)p.VelT0.sqrMagnitude));
                Assert.That(speed, Is.LessThan(most * Math.Sqrt(9.81 * depth)));
                double middle = end.Average(p => (double)p.Position.y) + 0.5 * domain.y;
                Assert.That(middle, Is.EqualTo(0.5 * depth).Within(2.5).Percent, "its own weight compresses it by 2 %");
            }
        }

        // Thrown into an edge or a corner, alone or several, as fast as liquid of the speed of sound may be.
        [Test]
        public void SprayIsNotThrownBackFasterThanItCame([Values(1, 2, 6, 20)] int count, [Values(1f, 0f)] float along)
        {
            var domain = new Vector3(0.5f, 0.5f, 0.5f);
            FluidSolverSettings settings = CorrectionReference.Corrected(BodyRig.Water(domain, Spacing, 0.4f, 4f));
            settings.Gravity = Vector3.zero;
            for (int seed = 0; seed < 4; seed++)
            {
                var random = new System.Random(seed);
                var start = new FluidParticle[count];
                for (int i = 0; i < count; i++)
                {
                    var place = new Vector3(i % 3, i / 9, i / 3 % 3) * (0.9f * Spacing) - 0.1f * Vector3.one;
                    start[i] = new FluidParticle(place + 0.1f * Spacing * ParticleSets.RandomVector(random),
                        4f * new Vector3(1f, 0.9f, along).normalized, (uint)i);
                }
                using (var rig = new StandardRig(settings, start))
                {
                    double Energy() => rig.Particles().Sum(p => 0.5 * p.VelT0.sqrMagnitude);
                    double before = Energy(), most = 0.0;
                    for (int part = 0; part < 12; part++)
                    {
                        rig.Steps((int)(0.02f / settings.TimeStep));
                        most = Math.Max(most, Energy());
                    }
                    Assert.That(most, Is.LessThan(1.05 * before), $"seed {seed}");
                }
            }
        }

        // Eight steps, as rounding grows; a corner of three faces, one of them mirrored.
        [Test]
        public void LiquidInACornerGoesAsItsMirrorImageDoes()
        {
            var domain = new Vector3(0.5f, 0.5f, 0.5f);
            FluidSolverSettings settings = CorrectionReference.Corrected(BodyRig.Water(domain, Spacing, 0.4f, 4f));
            FluidParticle[] Play(float side)
            {
                FluidParticle[] start = ParticleSets.Lattice(new Vector3Int(6, 5, 6), Spacing, 0.1f * Spacing, 7);
                for (int i = 0; i < start.Length; i++)
                {
                    Vector3 place = start[i].Position - new Vector3(0.095f, 0.12f, 0.095f);
                    start[i].Position = new Vector3(side * place.x, place.y, place.z);
                    start[i].VelT0 = new Vector3(-0.5f * side, -1f, -0.4f);
                }
                using (var rig = new StandardRig(settings, start))
                {
                    rig.Steps(8);
                    return rig.Particles().OrderBy(p => p.Id).ToArray();
                }
            }
            FluidParticle[] first = Play(1f), second = Play(-1f);
            for (int i = 0; i < first.Length; i++)
            {
                Vector3 image = first[i].Position;
                image.x = -image.x;
                Assert.That((second[i].Position - image).magnitude, Is.LessThan(5e-5f * Spacing), $"place of {i}");
            }
        }
    }
}
