using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Where rectangles on walls are in a step, and what a script can ask of them.</summary>
    public sealed class PlaceWallPatchesTests
    {
        private const float Spacing = 0.05f;

        // The buffer that the kernels read: Centre, half an edge, Right, half an edge, Up, depth, count, place of sums, two of none, ends.
        private static Vector3 At(float[] words, int patch, int word) =>
            new Vector3(words[20 * patch + word], words[20 * patch + word + 1], words[20 * patch + word + 2]);

        [Test]
        public void PatchesStandAsAsked([Values(1, 2, 63, 64)] int count)
        {
            var random = new System.Random(count);
            using (WallForceRig rig = Rig())
            {
                for (int i = 0; i < count; i++)
                {
                    rig.Forces.Add(ParticleSets.RandomVector(random), ParticleSets.RandomRotation(random), new Vector2(0.1f + i, 0.2f + i),
                        i % 2 == 0 ? 0f : 0.3f);
                }
                rig.Frame(1);
                float[] words = GpuTest.Read<float>(rig.Forces.Placed, 20 * count);
                uint[] bits = GpuTest.Read<uint>(rig.Forces.Placed, 20 * count);
                for (int i = 0; i < count; i++)
                {
                    WallPatch patch = rig.Forces.Patches[i];
                    Assert.That(At(words, i, 0), Is.EqualTo(patch.Centre));
                    Assert.That((At(words, i, 4) - patch.Rotation * Vector3.right).magnitude, Is.LessThan(1e-6f));
                    Assert.That((At(words, i, 8) - patch.Rotation * Vector3.up).magnitude, Is.LessThan(1e-6f));
                    Assert.That((words[20 * i + 3], words[20 * i + 7]), Is.EqualTo((0.5f * patch.Size.x, 0.5f * patch.Size.y)));
                    Assert.That(words[20 * i + 11], Is.EqualTo(i % 2 == 0 ? Spacing : 0.3f));
                    Assert.That((bits[20 * i + 12], bits[20 * i + 13]), Is.EqualTo(((uint)count, 2u * (uint)i)));
                }
            }
        }

        // A plate turns and goes along in a frame of four steps; the last begins at three quarters of the way.
        [Test]
        public void OneThatIsCarriedIsWhereItsMeshIsAtTheStartOfAStep()
        {
            using (WallForceRig rig = Rig())
            {
                Matrix4x4 before = Matrix4x4.TRS(new Vector3(0.1f, -0.1f, 0f), Quaternion.Euler(0f, 10f, 0f), Vector3.one);
                Matrix4x4 after = Matrix4x4.TRS(new Vector3(0.15f, -0.05f, 0.02f), Quaternion.Euler(0f, 10f, 25f), Vector3.one);
                int plate = rig.Obstacles.Add(TriangleMesh.Box(Matrix4x4.Scale(new Vector3(0.1f, 0.3f, 0.3f))), before);
                WallPatch still = rig.Forces.Add(Vector3.zero, Quaternion.identity, Vector2.one);
                WallPatch carried = rig.Forces.Add(before.MultiplyPoint3x4(new Vector3(0.05f, 0.1f, 0f)),
                    before.rotation * Quaternion.Euler(0f, 90f, 0f), Vector2.one);
                rig.Obstacles.Carry(plate, carried);
                rig.Frame(1);
                rig.Obstacles.MoveTo(plate, after);
                rig.Forces.Move(carried, after.MultiplyPoint3x4(new Vector3(0.05f, 0.1f, 0f)),
                    after.rotation * Quaternion.Euler(0f, 90f, 0f), Vector2.one);
                rig.Frame(4);
                // The motion is one of the frame that was simulation space at the start.
                Matrix4x4 motion = after * before.inverse;
                Quaternion turn = Quaternion.LerpUnclamped(Quaternion.identity, motion.rotation, 0.75f);
                Vector3 expected = turn * before.MultiplyPoint3x4(new Vector3(0.05f, 0.1f, 0f)) + 0.75f * (Vector3)motion.GetColumn(3);
                float[] words = GpuTest.Read<float>(rig.Forces.Placed, 40);
                Assert.That((At(words, 1, 0) - expected).magnitude, Is.LessThan(1e-5f));
                Assert.That((At(words, 1, 8) - turn * (before.rotation * Vector3.up)).magnitude, Is.LessThan(1e-5f));
                Assert.That(At(words, 0, 0), Is.EqualTo(still.Centre), "one that nothing carries stays");
            }
        }

        // The first step kicks by half; a long batch has several steps in a part.
        [TestCase(1, 1)]
        [TestCase(64, 64)]
        [TestCase(65, 64)]
        [TestCase(200, 64)]
        public void SamplesSpanAllSteps(int steps, int parts)
        {
            using (WallForceRig rig = Rig())
            {
                WallPatch patch = rig.Add(new Vector3(0f, -0.5f, 0f), Vector3.up, 1f, 1f);
                double step = rig.Solver.Settings.TimeStep;
                patch.Memory = 1e6;
                rig.Frame(steps);
                rig.Forces.Complete();
                Assert.That(patch.Samples.Count(), Is.EqualTo(parts));
                Assert.That(patch.Seconds, Is.EqualTo((steps - 0.5) * step).Within(1e-4).Percent);
                Assert.That(patch.Samples.Sum(s => s.Seconds), Is.EqualTo(patch.Seconds).Within(1e-6).Percent);
                Assert.That(patch.Time, Is.EqualTo(rig.Solver.SimulatedTime).Within(1e-6).Percent);
                Assert.That(patch.Samples.Select(s => s.Time), Is.Ordered);
            }
        }

        [Test]
        public void AMeanTakesThePartOfASampleThatLiesInItsTime()
        {
            var patch = new WallPatch { Size = new Vector2(2f, 1f), Memory = 10.0 };
            Assert.That(patch.MeanPressure(1.0), Is.Zero, "there is none");
            patch.SetSample(new WallSample(1.0, 1.0, 8.0));
            patch.SetSample(new WallSample(2.0, 1.0, 2.0));
            patch.SetSample(new WallSample(2.5, 0.5, 4.0));
            Assert.That(patch.MeanForce(0.0), Is.EqualTo(8.0), "the last alone");
            Assert.That(patch.MeanForce(0.5), Is.EqualTo(8.0));
            Assert.That(patch.MeanForce(1.0), Is.EqualTo(5.0));
            Assert.That(patch.MeanForce(2.0), Is.EqualTo((4.0 + 2.0 + 4.0) / 2.0));
            Assert.That(patch.MeanForce(100.0), Is.EqualTo(14.0 / 2.5), "of all there is");
            Assert.That(patch.MeanPressure(1.0), Is.EqualTo(2.5));
            Assert.That(patch.PeakPressure(1.0, 1), Is.EqualTo(2.5));
            Assert.That(patch.PeakPressure(1.0, 3), Is.EqualTo(4.0), "the first alone was the strongest");
            patch.Memory = 0.4;
            patch.SetSample(new WallSample(3.0, 0.5, 1.0));
            Assert.That(patch.MeanForce(100.0), Is.EqualTo(2.0), "what is older is forgotten");
            Assert.That(patch.Impulse, Is.EqualTo(15.0), "but counts");
            patch.Clear();
            Assert.That((patch.Impulse, patch.HasValue, patch.Time), Is.EqualTo((0.0, false, -1.0)));
        }

        [Test]
        public void WhatCannotBeReadIsRefusedWithTheCure()
        {
            using (WallForceRig rig = Rig())
            {
                WallForces forces = rig.Forces;
                Assert.That(() => forces.Add(new Vector3(float.NaN, 0f, 0f), Quaternion.identity, Vector2.one),
                    Throws.ArgumentException.With.Message.Contains("centre"));
                Assert.That(() => forces.Add(Vector3.zero, default, Vector2.one),
                    Throws.ArgumentException.With.Message.Contains("quaternion"));
                Assert.That(() => forces.Add(Vector3.zero, Quaternion.identity, new Vector2(1f, 0f)),
                    Throws.ArgumentException.With.Message.Contains("edge lengths"));
                Assert.That(() => forces.Add(Vector3.zero, Quaternion.identity, Vector2.one, -1f),
                    Throws.ArgumentException.With.Message.Contains("depth"));
                WallPatch[] all = Enumerable.Range(0, WallForces.Most)
                    .Select(_ => forces.Add(Vector3.zero, Quaternion.identity, Vector2.one)).ToArray();
                Assert.That(() => forces.Add(Vector3.zero, Quaternion.identity, Vector2.one),
                    Throws.InvalidOperationException.With.Message.Contains("64"));
                forces.Remove(all[3]);
                forces.Add(Vector3.zero, Quaternion.identity, Vector2.one);
                Assert.That(() => forces.Move(all[3], Vector3.zero, Quaternion.identity, Vector2.one),
                    Throws.ArgumentException.With.Message.Contains("removed"));
            }

            using (var thesis = new FluidSolver(TestSettings.ByRule(Vector3.one, 0.2f), TestShaders.CreateSet(),
                new[] { new FluidParticle(Vector3.zero, Vector3.zero, 0u) }))
            {
                Assert.That(thesis.MeasuresWallForces, Is.False);
                Assert.That(() => thesis.WallForces, Throws.InstanceOf<NotSupportedException>().With.Message.Contains("Standard"));
            }
        }

        private static WallForceRig Rig() =>
            new WallForceRig(BodyRig.Water(Vector3.one, Spacing, 0.3f, 3f),
                new[] { new FluidParticle(new Vector3(0.4f, 0.4f, 0.4f), Vector3.zero, 0u) });
    }
}
