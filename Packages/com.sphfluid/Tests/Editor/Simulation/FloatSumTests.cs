using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Bodies as one: together they have the force and the torque that each was given.</summary>
    public sealed class FloatSumTests
    {
        [Test]
        public void AllTogetherHaveWhatEachWasGiven([Values(1, 2, 5)] int count)
        {
            var random = new System.Random(count);
            Vector3 Any(float size) => size * ParticleSets.RandomVector(random);
            FloatingMass[] masses = Enumerable.Range(0, count)
                .Select(_ => FloatingMass.Box(0.3f * Vector3.one + Any(0.4f), 400f, Vector3.zero)).ToArray();
            FloatingPose[] poses = masses.Select(_ => new FloatingPose(Any(2f), Quaternion.Euler(Any(300f)))).ToArray();
            Vector3[] given = masses.Select(_ => Any(3f)).ToArray(), turns = masses.Select(_ => Any(5f)).ToArray();
            var sum = new FloatSum(poses[0].Centre + Any(0.5f));
            for (int i = 0; i < count; i++) sum.Add(masses[i], poses[i], given[i], turns[i]);
            Vector3[] moved = poses.Select(p => sum.At(p.Centre, out _)).ToArray();
            sum.At(Vector3.zero, out Vector3 spin);

            Vector3 Force(Vector3[] of) => Enumerable.Range(0, count).Aggregate(Vector3.zero, (all, i) => all + masses[i].Mass * of[i]);
            Vector3 Torque(Vector3[] of, Vector3[] turning) =>
                Enumerable.Range(0, count)
                    .Aggregate(Vector3.zero, (all, i) => all + Vector3.Cross(poses[i].Centre, masses[i].Mass * of[i]) +
                poses[i].Rotation * Vector3.Scale(masses[i].Inertia, Quaternion.Inverse(poses[i].Rotation) * turning[i]));
            Assert.That(sum.Mass, Is.EqualTo(masses.Sum(m => m.Mass)).Within(1e-3).Percent);
            Assert.That((Force(moved) - Force(given)).magnitude, Is.LessThan(1e-4f * Force(given).magnitude));
            Assert.That((Torque(moved, turns.Select(_ => spin).ToArray()) - Torque(given, turns)).magnitude,
                Is.LessThan(1e-3f * Torque(given, turns).magnitude));
            for (int i = 0; i < count; i++)
            {
                Assert.That((moved[i] - moved[0] - Vector3.Cross(spin, poses[i].Centre - poses[0].Centre)).magnitude,
                    Is.LessThan(1e-4f * spin.magnitude), "one rigid body");
            }
            sum.Torque = Vector3.zero;
            Assert.That((sum.At(Any(2f), out spin) - Force(given) / sum.Mass).magnitude, Is.LessThan(1e-4f));
            Assert.That(spin.magnitude, Is.LessThan(1e-4f), "nothing turns it about its centre");
        }
    }
}
