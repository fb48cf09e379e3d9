using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>SleepParticles against the same rule on the CPU: which bricks are calm, which particles are slowed, which sleep.</summary>
    public sealed class SleepParticlesTests
    {
        private const float SinceSort = 0.4f; // s

        // m/s, at each pass.
        private static readonly float[] SoundSpeeds = { 12f, 12f, 15f, 21f, 18f, 24f };

        /// <summary>How the particles of a brick move, as parts of the rule's speeds.</summary>
        private enum Motion
        {
            Still, Trembling, Drifting, Wild, KeptAwake,
        }

        [Test]
        public void BricksFallAsleepAndWakeByTheRule(
            [Values(0, 1, 63, 64, 65, 1009)] int count, [Values(FluidAxes.None, FluidAxes.X)] FluidAxes periodic)
        {
            FluidSolverSettings settings = StandardStateRig.WithCells(new Vector3Int(23, 8, 15));
            settings.Boundaries.Periodic = periodic;
            using (var rig = new StandardStateRig(settings, count))
            {
                StandardState state = rig.State;
                var random = new System.Random(count + 7);
                CellRows cells = state.Cells;
                FluidParticle[] sorted = rig.FillSorted(Enumerable.Range(0, count).Select(i => new FluidParticle
                {
                    Id = (uint)i, Position = StandardStateRig.Within(cells, StandardStateRig.RandomCell(cells, random), random),
                }).ToArray());
                var rule = new SleepRule(9.81, settings.Spacing, 1.0);
                state.SetSleep(rule);
                Assert.That(state.HasSleepers, Is.True);
                SleepBricks bricks = state.Sleep;
                var expected = new ExpectedBricks(bricks, rule, periodic, sorted.Select(p => BrickOf(bricks, cells, p.Position)).ToArray());
                GpuTest.Run(cmd => new SleepParticlesPass(rig.Shaders).Record(cmd, state)); // at first all wake
                int slept = 0, slowed = 0;
                for (int pass = 0; pass < 6; pass++)
                {
                    bool isRough = pass >= 4;
                    Motion[] motions = Enumerable.Range(0, bricks.Total)
                        .Select(b => random.Next(isRough ? 6 : 60) == 0 ? (Motion)random.Next(5) : Motion.Still).ToArray();
                    Vector3[] velocities = expected.VelocitiesFor(motions);
                    state.KeepAwake(Enumerable.Range(0, bricks.Total).Where(b => motions[b] == Motion.KeptAwake)
                        .Select(b => new Bounds(CentreOf(bricks, cells, b), 0.1f * settings.Spacing * Vector3.one)).ToArray());
                    StandardStateRig.Fill(state.Buffers.Positions, sorted.Select(p => StandardStateRig.WithW(p.Position, 1f)).ToArray());
                    StandardStateRig.Fill(state.Buffers.PositionTerms,
                        sorted.Select((p, i) => StandardStateRig.WithW(p.Position, 1000f + i)).ToArray());
                    StandardStateRig.Fill(state.Buffers.Velocities,
                        sorted.Select((p, i) => StandardStateRig.WithW(velocities[i], StandardStateRig.FromBits(p.Id))).ToArray());
                    bricks.SinceSort = SinceSort;
                    double softened = pass == 0 ? 1.0 : Math.Pow(SoundSpeeds[pass - 1] / SoundSpeeds[pass], 2.0);
                    state.Settings = settings.WithSoundSpeed(SoundSpeeds[pass]);
                    GpuTest.Run(cmd => new SleepParticlesPass(rig.Shaders).Record(cmd, state));
                    expected.Judge(motions, softened);

                    Vector4[] places = GpuTest.Read<Vector4>(state.Buffers.Positions, count);
                    Vector4[] after = GpuTest.Read<Vector4>(state.Buffers.Velocities, count);
                    for (int i = 0; i < count; i++)
                    {
                        int was = expected.States[expected.BrickOf[i]];
                        float left = was == 0 ? 1f : was == 1 ? Mathf.Exp(-SinceSort / rule.FadeTime) : 0f;
                        slept += was == 2 ? 1 : 0;
                        slowed += was == 1 ? 1 : 0;
                        float ahead = was == 2 ? -1099511627776f * (1000f + i) : 1f;
                        Assert.That(places[i].w, Is.EqualTo(ahead), "the density of one that sleeps");
                        Assert.That(((Vector3)after[i] - left * velocities[i]).magnitude, Is.LessThan(1e-6f), $"m/s, of state {was}");
                        Assert.That(StandardStateRig.ToBits(after[i].w), Is.EqualTo(sorted[i].Id));
                    }
                    uint[] words = GpuTest.Read<uint>(bricks.Bricks, bricks.Total * SleepBricks.Words);
                    int[] states = words.Where((_, i) => i % SleepBricks.Words == SleepBricks.State).Select(w => (int)w).ToArray();
                    Assert.That(states, Is.EqualTo(expected.States), $"behind pass {pass}");
                    for (int b = 0; b < bricks.Total; b++)
                    {
                        float stiffness = 1f + StandardStateRig.FromBits(words[b * SleepBricks.Words + SleepBricks.Softness]);
                        Assert.That(stiffness, Is.EqualTo(expected.Stiffness[b]).Within(1e-5), $"of {states[b]}, behind pass {pass}");
                    }
                }
                if (count > 1000) Assert.That(Math.Min(slept, slowed), Is.GreaterThan(50), "of both there were some");
            }
        }

        private static int BrickOf(SleepBricks bricks, in CellRows cells, Vector3 position)
        {
            int cell = StandardStateRig.CellOf(cells, position);
            var at = new Vector3Int(cell % cells.Counts.x, cell / cells.Counts.x % cells.Counts.y, cell / cells.Counts.x / cells.Counts.y);
            at = (at - Vector3Int.one) / bricks.Side;
            return at.x + bricks.Counts.x * (at.y + bricks.Counts.y * at.z);
        }

        private static Vector3 CentreOf(SleepBricks bricks, in CellRows cells, int brick)
        {
            Vector3Int at = ExpectedBricks.At(bricks, brick);
            return cells.Origin + cells.CellSize + Vector3.Scale(bricks.Side * ((Vector3)at + 0.5f * Vector3.one), cells.CellSize);
        }

        /// <summary>The rule once more.</summary>
        private sealed class ExpectedBricks
        {
            private readonly SleepBricks bricks;
            private readonly SleepRule rule;
            private readonly FluidAxes periodic;
            private readonly double[] calm;

            public ExpectedBricks(SleepBricks bricks, in SleepRule rule, FluidAxes periodic, int[] brickOf)
            {
                (this.bricks, this.rule, this.periodic, BrickOf) = (bricks, rule, periodic, brickOf);
                calm = new double[bricks.Total];
                States = new int[bricks.Total];
                Stiffness = Enumerable.Repeat(1.0, bricks.Total).ToArray();
            }

            public int[] BrickOf { get; }
            public int[] States { get; }
            public double[] Stiffness { get; }

            public static Vector3Int At(SleepBricks bricks, int brick) => new Vector3Int(
                brick % bricks.Counts.x, brick / bricks.Counts.x % bricks.Counts.y, brick / bricks.Counts.x / bricks.Counts.y);

            // Trembling particles of a brick move against each other, the rest of them one way.
            public Vector3[] VelocitiesFor(Motion[] motions)
            {
                var seen = new Dictionary<int, int>();
                int[] totals = Enumerable.Range(0, bricks.Total).Select(b => BrickOf.Count(of => of == b)).ToArray();
                return BrickOf.Select(b =>
                {
                    seen.TryGetValue(b, out int place);
                    seen[b] = place + 1;
                    float trembling = place == totals[b] - 1 && place % 2 == 0 ? 0f : place % 2 == 0 ? 0.8f : -0.8f;
                    return motions[b] == Motion.Wild ? 3f * rule.JitterSpeed * Vector3.up
                        : motions[b] == Motion.Trembling ? trembling * rule.JitterSpeed * Vector3.right
                        : motions[b] == Motion.Drifting ? 0.7f * rule.DriftSpeed * Vector3.forward : Vector3.zero;
                }).ToArray();
            }

            public void Judge(Motion[] motions, double softened)
            {
                double whole = rule.CalmTime + rule.StillTime;
                for (int b = 0; b < calm.Length; b++)
                {
                    int count = BrickOf.Count(of => of == b);
                    bool moves = count > 0 && (motions[b] == Motion.Wild || motions[b] == Motion.Drifting);
                    bool trembles = count > 1 && motions[b] == Motion.Trembling;
                    double longer = calm[b] + SinceSort;
                    double later = trembles ? Math.Max(calm[b], Math.Min(longer, rule.CalmTime)) : Math.Min(longer, whole);
                    calm[b] = moves || motions[b] == Motion.KeptAwake ? 0.0 : later;
                }
                for (int b = 0; b < calm.Length; b++)
                {
                    double least = Near(b).Min(n => calm[n]);
                    double kept = Stiffness[b] * (States[b] == 2 ? softened : 1.0);
                    States[b] = least > whole - 1e-5 ? 2 : least > rule.CalmTime - 1e-5 ? 1 : 0;
                    double stiffer = 1.0 + Math.Min(kept - 1.0, 0.0) * Math.Exp(-SinceSort / rule.StillTime);
                    Stiffness[b] = States[b] == 2 ? kept : stiffer;
                }
            }

            private IEnumerable<int> Near(int brick)
            {
                Vector3Int at = At(bricks, brick), counts = bricks.Counts;
                for (int z = Math.Max(0, at.z - 1); z <= Math.Min(counts.z - 1, at.z + 1); z++)
                    for (int y = Math.Max(0, at.y - 1); y <= Math.Min(counts.y - 1, at.y + 1); y++)
                        for (int x = at.x - 1; x <= at.x + 1; x++)
                        {
                            bool wraps = (periodic & FluidAxes.X) != 0;
                            if (!wraps && (x < 0 || x >= counts.x)) continue;
                            yield return (x + counts.x) % counts.x + counts.x * (y + counts.y * z);
                        }
            }
        }
    }
}
