using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Steps that pass over the groups where all sleep against those that go through all particles.</summary>
    public sealed class AwakeGroupsTests
    {
        private const float Spacing = 0.05f;
        private const int GroupSize = 64;

        [TestCase(24, false)]
        [TestCase(36, true)]
        [TestCase(31, true)]
        public void TheStepsAreThoseOfAllParticles(int length, bool hasBodies)
        {
            var frames = new (FluidParticle[] particles, float[] densities, bool[] sleep)[2][];
            for (int turn = 0; turn < 2; turn++)
            {
                using (BodyRig rig = Sleepers(length, hasBodies))
                {
                    frames[turn] = Enumerable.Range(0, 4).Select(frame =>
                    {
                        if (turn == 1) rig.State.Sleep.Groups.AreListed = false; // the steps until the sort at the frame's end
                        rig.Frame(3);
                        return (rig.Particles(), rig.Densities(), Sleeping(rig));
                    }).ToArray();
                }
            }
            for (int frame = 0; frame < 4; frame++)
            {
                Assert.That(frames[0][frame].particles, Is.EqualTo(frames[1][frame].particles), "bit by bit");
                Assert.That(frames[0][frame].densities, Is.EqualTo(frames[1][frame].densities));
                Assert.That(frames[0][frame].sleep, Is.EqualTo(frames[1][frame].sleep));
            }
            FluidParticle[] last = frames[0][3].particles;
            Assert.That(frames[0][3].sleep.Count(s => s), Is.InRange(4 * GroupSize, last.Length - GroupSize), "some of both");
            Assert.That(last.Max(p => p.VelT0.magnitude), Is.GreaterThan(0.1f));
        }

        [Test]
        public void EachGroupIsListedOnce()
        {
            using (BodyRig rig = Sleepers(31, false))
            {
                CellState state = rig.State;
                bool[] sleeps = Sleeping(rig);
                int groups = (sleeps.Length + GroupSize - 1) / GroupSize, begin = state.Buffers.GroupLists.Begin;
                uint[] table = GpuTest.Read<uint>(state.Buffers.CellTable, begin + (int)AwakeGroups.Words(state.Capacity));
                Assert.That(table[begin], Is.EqualTo(uint.MaxValue), "of what takes all");
                uint[] List(int at) => table.Skip(at + 1).Take((int)table[at]).OrderBy(g => g).ToArray();
                uint[] Those(bool asleep) => Enumerable.Range(0, groups)
                    .Where(g => sleeps.Skip(g * GroupSize).Take(GroupSize).All(s => s) == asleep).Select(g => (uint)g).ToArray();
                Assert.That(List(begin + 1), Is.EqualTo(Those(false)).And.Not.Empty);
                Assert.That(List(begin + 2 + groups), Is.EqualTo(Those(true)).And.Not.Empty);
            }
        }

        [Test]
        public void ThoseThatSleepKeepPlaceDensityAndPressure()
        {
            using (BodyRig rig = Sleepers(24, false))
            {
                bool[] sleeps = Sleeping(rig);
                FluidParticle[] before = rig.Particles();
                float[] densities = rig.Densities(), pressures = GpuTest.Read<float>(rig.Solver.Pressure, before.Length);
                rig.State.Sleep.SinceSort = 0f;
                FluidSolverSettings settings = rig.Solver.Settings;
                rig.Solver.ApplySettings(settings.WithSoundSpeed(1.5f * settings.SoundSpeed));
                rig.Frame(2);
                FluidParticle[] after = rig.Particles();
                float[] later = rig.Densities(), pressedLater = GpuTest.Read<float>(rig.Solver.Pressure, before.Length);
                bool[] sleepStill = Sleeping(rig);
                int same = 0;
                for (int i = 0; i < before.Length; i++)
                {
                    if (!sleeps[i]) continue;
                    float pressure = settings.SoundSpeed * settings.SoundSpeed * Mathf.Max(densities[i] - settings.RestDensity, 0f);
                    Assert.That(pressures[i], Is.EqualTo(pressure).Within(1e-3f * pressure + 1e-3f), "Pa");
                    Assert.That(before[i].VelT0, Is.EqualTo(Vector3.zero));
                    int now = Array.FindIndex(after, p => p.Id == before[i].Id);
                    if (!sleepStill[now]) continue;
                    Assert.That(after[now].Position, Is.EqualTo(before[i].Position));
                    Assert.That(later[now], Is.EqualTo(densities[i]));
                    Assert.That(pressedLater[now], Is.EqualTo(pressures[i]).Within(1e-3f * pressure + 1e-3f), "Pa, as c rose");
                    same++;
                }
                Assert.That(same, Is.GreaterThan(4 * GroupSize));
                Assert.That(pressures.Where((_, i) => sleeps[i]).Max(), Is.Positive);
            }
        }

        [Test]
        public void WallsOfThoseThatSleepAreThereWhereDrawingAsks()
        {
            using (BodyRig rig = Sleepers(24, true))
            {
                StandardState state = rig.State;
                Assert.That(state.Walls.LackSleepers, Is.True);
                GpuTest.Run(cmd => state.GatherAsleep(cmd));
                Assert.That(state.Walls.LackSleepers, Is.False);
                uint[] asked = Slots(state);
                PackedPlane[] planes = Planes(state);
                state.Sleep.Groups.AreListed = false;
                GpuTest.Run(cmd => new GatherWallsPass(rig.Shaders).Record(cmd, state, state.Buffers.Positions));
                Assert.That(asked, Is.EqualTo(Slots(state)));
                PackedPlane[] expected = Planes(state);
                bool[] sleeps = Sleeping(rig);
                int walled = 0;
                for (int i = 0; i < asked.Length; i++)
                {
                    if (asked[i] == 0u) continue;
                    Assert.That(planes[i], Is.EqualTo(expected[i]));
                    walled += sleeps[i] ? 1 : 0;
                }
                Assert.That(walled, Is.GreaterThan(GroupSize));
            }
        }

        // The first numbers of a PackedWall; the rest of it follows from the same triangles.
        private struct PackedPlane
        {
            public uint A, B, C, D;
        }

        private static uint[] Slots(StandardState state) =>
            GpuTest.Read<uint>(state.List.Neighbours, state.List.WallSlot.Begin + state.ParticleCount)
                .Skip(state.List.WallSlot.Begin).ToArray();

        private static PackedPlane[] Planes(StandardState state)
        {
            int words = MeshWallBuffers.WallStride / sizeof(uint);
            uint[] all = GpuTest.Read<uint>(state.Walls.NearWalls, state.ParticleCount * words);
            return Enumerable.Range(0, state.ParticleCount).Select(i => new PackedPlane
            {
                A = all[i * words], B = all[i * words + 1], C = all[i * words + 2], D = all[i * words + 3],
            }).ToArray();
        }

        private static bool[] Sleeping(BodyRig rig) =>
            GpuTest.Read<Vector4>(rig.State.Buffers.Positions, rig.State.ParticleCount).Select(p => p.w < -1e9f).ToArray();

        // A long pool of which all but the left end sleeps, with a box at rest in what sleeps.
        private static BodyRig Sleepers(int length, bool hasBodies)
        {
            GpuTest.Require();
            var counts = new Vector3Int(length, 6, 9);
            var rig = new BodyRig(BodyRig.Water(Spacing * ((Vector3)counts + 4f * Vector3.up), Spacing, 6f * Spacing));
            try
            {
                float end = 0.5f * length * Spacing;
                if (hasBodies)
                {
                    Transform box = rig.AddBox(3f * Spacing * Vector3.one);
                    box.position = new Vector3(end - 6f * Spacing, -2f * Spacing, 0f);
                }
                FluidParticle[] pool = FloatingRig.Block(counts, Spacing, -0.5f * Spacing * ((Vector3)counts + 4f * Vector3.up))
                    .Where(p => !hasBodies || Mathf.Abs(p.Position.x - end + 6f * Spacing) > 2f * Spacing).ToArray();
                for (int i = 0; i < pool.Length; i++)
                    if (pool[i].Position.x < -end + 3f * Spacing) pool[i].VelT0 = pool[i].VelT1 = 0.5f * Vector3.right;
                rig.Start(pool);
                rig.State.SetSleep(new SleepRule(9.81, Spacing, 1000.0));
                rig.State.KeepAwake(new[] { new Bounds(-end * Vector3.right, 10f * Spacing * Vector3.one) });
                for (int frame = 0; frame < 3; frame++)
                {
                    rig.State.Sleep.SinceSort = 10f; // s
                    rig.Frame(1);
                }
                return rig;
            }
            catch
            {
                rig.Dispose();
                throw;
            }
        }
    }
}
