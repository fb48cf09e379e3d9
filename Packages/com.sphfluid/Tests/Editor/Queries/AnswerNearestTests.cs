using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>AnswerNearest against a look at every particle on the CPU.</summary>
    public sealed class AnswerNearestTests
    {
        private static readonly Vector3 Domain = new Vector3(0.62f, 0.5f, 0.54f);

        private static FluidNearestResult[] Ask(in FluidSolverSettings settings, FluidParticle[] particles, Vector3[] places,
            float distance, uint generation = 7u)
        {
            QueryWord[] words = places
                .SelectMany(p =>
                    new[] { new QueryWord { Vector = QueryRig.World(p), Number = generation }, new QueryWord(Vector3.zero, distance) })
                    .ToArray();
            using (var rig = new QueryRig(settings, particles))
            {
                var pass = new AnswerNearestPass(rig.Shaders);
                return rig.Ask<FluidNearestResult>(words, places.Length, 3,
                    (cmd, target, queries) => pass.Record(cmd, target, queries, places.Length, 3));
            }
        }

        [TestCase(0, 1009, 0.2f)]
        [TestCase(1, 1, 5f)]
        [TestCase(1, 255, 0.2f)]
        [TestCase(17, 256, 0.05f)]
        [TestCase(257, 257, 0.2f)]
        [TestCase(67, 1009, 0.03f)]
        [TestCase(67, 1009, 0.2f, FluidAxes.X | FluidAxes.Z)]
        public void TheNearestIsThatOfALookAtAll(int count, int particleCount, float distance, FluidAxes periodic = FluidAxes.None)
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.04f);
            settings.Boundaries.Periodic = periodic;
            FluidParticle[] particles = ParticleSets.Random(particleCount, Domain, 1f, 3);
            var random = new System.Random(4);
            Vector3[] places = Enumerable.Range(0, count)
                .Select(_ => 1.1f * Vector3.Scale(ParticleSets.RandomVector(random), Domain)).ToArray();
            FluidNearestResult[] found = Ask(settings, particles, places, distance);
            Vector3 period = settings.PeriodLength;
            int none = 0;
            for (int i = 0; i < count; i++)
            {
                Vector3 Apart(FluidParticle p)
                {
                    Vector3 d = p.Position - places[i];
                    for (int axis = 0; axis < 3; axis++)
                        if (period[axis] > 0f) d[axis] -= period[axis] * Mathf.Round(d[axis] / period[axis]);
                    return d;
                }
                FluidParticle nearest = particles.OrderBy(p => Apart(p).sqrMagnitude).First();
                float expected = Apart(nearest).magnitude;
                Assert.That(found[i].Generation, Is.EqualTo(7u));
                if (expected > distance)
                {
                    none++;
                    Assert.That((found[i].Distance, found[i].IsFound), Is.EqualTo((-1f, false)), $"place {i}");
                    continue;
                }
                Assert.That(found[i].Distance, Is.EqualTo(expected).Within(1e-5f), $"place {i}");
                Assert.That((found[i].Place - QueryRig.World(places[i] + Apart(nearest))).magnitude, Is.LessThan(1e-5f));
                Assert.That((found[i].Velocity - QueryRig.Turn * nearest.VelT0).magnitude, Is.LessThan(1e-5f));
            }
            if (distance < 0.04f) Assert.That(none, Is.InRange(5, count - 5));
        }

        [Test]
        public void OfThoseEquallyFarTheOneOfTheLeastIdIsNearest()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.04f);
            FluidParticle[] particles = Enumerable.Range(0, 300).Select(i => new FluidParticle
            {
                Id = (uint)(i * 37 % 300),
                Position = 0.125f * new[] { Vector3.right, Vector3.left, Vector3.up, Vector3.down }[i % 4],
                VelT0 = i * 37 % 300 * Vector3.one,
            }).ToArray();
            using (var rig = new QueryRig(settings, particles))
            {
                var pass = new AnswerNearestPass(rig.Shaders);
                // The domain unturned and at the origin, so that all are as far to the last bit.
                var words = new[] { new QueryWord { Vector = Vector3.zero, Number = 1u }, new QueryWord(Vector3.zero, 1f) };
                FluidNearestResult found = rig.Ask<FluidNearestResult>(words, 1, 0, (cmd, target, queries) =>
                {
                    target.Position = Vector3.zero;
                    target.Rotation = Quaternion.identity;
                    pass.Record(cmd, target, queries, 1, 0);
                })[0];
                Assert.That(found.Velocity, Is.EqualTo(Vector3.zero), "that of id 0");
                Assert.That(found.Distance, Is.EqualTo(0.125f));
            }
        }

        [Test]
        public void RemovedRequestsFindNothing()
        {
            FluidSolverSettings settings = TestSettings.ByRule(Domain, 0.04f);
            FluidNearestResult found = Ask(settings, ParticleSets.Random(100, Domain, 1f, 3), new[] { Vector3.zero }, 5f, 0u)[0];
            Assert.That((found.IsFound, found.Generation), Is.EqualTo((false, 0u)));
        }
    }
}
