using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>When GatherWalls finds a particle's walls anew, and when those of an earlier step serve.</summary>
    public sealed class KeptWallsTests
    {
        private const float Spacing = 0.05f;

        // In a step that keeps the order a particle's walls are gathered anew where it has gone 0.07 R since, and 0.45 R where it had none.
        [TestCase(0.9f, 0.067f, false)]
        [TestCase(0.9f, 0.073f, true)]
        [TestCase(1.1f, 0.44f, false)]
        [TestCase(1.1f, 0.46f, true)]
        public void KeptWallsAreGatheredAnewWhereTheirParticleHasGoneFar(float distanceOverRadius, float goneOverRadius, bool gathers)
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            float radius = settings.SupportRadius;
            FluidShaderSet set = TestShaders.CreateSet();
            using (var rig = new BodyRig(settings))
            {
                rig.AddBall(0.2f, 12);
                rig.Start(new[] { new FluidParticle((0.2f + distanceOverRadius * radius) * Vector3.right, Vector3.zero, 0u) });
                rig.Setup();
                float was = Gap();
                Vector4[] at = GpuTest.Read<Vector4>(rig.State.Buffers.Positions, 1);
                at[0] += (Vector4)(goneOverRadius * radius * Vector3.left);
                rig.State.Buffers.Positions.SetData(at);
                GpuTest.Run(cmd => new GatherWallsPass(set).Record(cmd, rig.State, rig.State.Buffers.Positions, isKept: true));
                Assert.That(Gap() < was - 1e-3f * radius, Is.EqualTo(gathers));

                float Gap() => Mathf.Abs(rig.State.Walls.WallGap.Read<Vector4>(1)[0].w);
            }
            UnityEngine.Object.DestroyImmediate(set);
        }

        // Whoever gathers is listed once, in as many groups as that takes, and the lists of the steps before are forgotten.
        [TestCase(1)]
        [TestCase(63)]
        [TestCase(64)]
        [TestCase(65)]
        [TestCase(1009)]
        public void WhoSeesTrianglesIsListedOnce(int count)
        {
            FluidSolverSettings settings = BodyRig.Water(Vector3.one, Spacing, 0.3f);
            FluidParticle[] near = ParticleSets.Random(4 * count, new Vector3(0.35f, 0.35f, 0.35f), 0f, 3)
                .Where(p => p.Position.magnitude > 0.21f).Take(count - count / 4).ToArray();
            FluidParticle[] all = Enumerable.Range(0, count).Select(i => new FluidParticle(
                i < near.Length ? near[i].Position : new Vector3(-0.45f, -0.45f, -0.45f), Vector3.zero, (uint)i)).ToArray();
            using (var rig = new BodyRig(settings))
            {
                rig.AddBall(0.2f, 12);
                rig.Start(all);
                rig.Setup();
                for (int time = 0; time < 3; time++)
                {
                    GpuTest.Run(cmd => new GatherWallsPass(rig.Shaders).Record(cmd, rig.State, rig.State.Buffers.Positions, isKept: false));
                    uint[] words = GpuTest.Read<uint>(rig.State.Walls.Walled, 8 + count);
                    uint[] arguments = words.Skip((int)rig.State.Walls.WalledArguments / 4).Take(4).ToArray();
                    uint[] slots = rig.State.List.WallSlot.Read<uint>(count);
                    int[] listed = words.Skip(8).Take((int)arguments[3]).Select(id => (int)id).ToArray();
                    Assert.That(listed, Is.Unique);
                    Assert.That(Enumerable.Range(0, count).Where(i => slots[i] != 0u), Is.SubsetOf(listed));
                    Assert.That(listed.Length, Is.InRange(near.Length / 4, near.Length), "none of those far away");
                    Assert.That(arguments.Take(3), Is.EqualTo(new[] { (uint)(listed.Length + 63) / 64u, 1u, 1u }));
                }
            }
        }

        // A body that has moved, has rested for some frames and then jumps is at its new place in the next step.
        [Test]
        public void ABodyThatRestedAndJumpsIsAWallWhereItIsNow()
        {
            FluidSolverSettings settings = BodyRig.Water(20f * Vector3.one, 0.1f, 0.3f);
            float jump = 70f * settings.SupportRadius;
            using (var rig = new BodyRig(settings))
            {
                Transform box = rig.AddBox(0.4f * Vector3.one);
                box.localPosition = new Vector3(-8f, 0f, 0f);
                rig.Start(new[] { new FluidParticle(new Vector3(-8f + 0.01f + jump, 0.21f, 0f), Vector3.zero, 0u) });
                box.Translate(0.01f, 0f, 0f);
                for (int frame = 0; frame < 4; frame++) rig.Frame(1);
                Assert.That((rig.Bodies.Jumps, Slot()), Is.EqualTo((0, 0u)));
                box.Translate(jump, 0f, 0f);
                rig.Frame(1);
                Assert.That((rig.Bodies.Jumps, Slot()), Is.EqualTo((1, 1u)));

                uint Slot() => rig.State.List.WallSlot.Read<uint>(1)[0];
            }
        }
    }
}
