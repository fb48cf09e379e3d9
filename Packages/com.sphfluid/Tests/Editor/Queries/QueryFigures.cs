using System;
using System.Diagnostics;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Tests
{
    /// <summary>What questions cost on this device; figures for the documentation, not a test.</summary>
    [Explicit("Takes a minute and measures time.")]
    public sealed class QueryFigures
    {
        private const float Spacing = 0.02f;
        private const int Repeats = 8;

        // A pool in the lower half of a cube.
        [TestCase(32, 16)]
        [TestCase(64, 32)]
        public void MillisecondsAFrame(int side, int layers)
        {
            FluidSolverSettings settings = TestSettings.ByRule(side * Spacing * Vector3.one, Spacing);
            FluidParticle[] particles = ParticleSets.Lattice(new Vector3Int(side, layers, side), Spacing, 0.2f * Spacing, 1);
            for (int i = 0; i < particles.Length; i++) particles[i].Position.y -= 0.5f * (side - layers) * Spacing;
            using (var rig = new QueryRig(settings, particles))
            {
                var points = new AnswerPointsPass(rig.Shaders);
                var rays = new AnswerRaysPass(rig.Shaders);
                var nearest = new AnswerNearestPass(rig.Shaders);
                TestContext.WriteLine($"{SystemInfo.graphicsDeviceName}, {particles.Length} particles");
                foreach (int count in new[] { 100, 1000, 10000 })
                {
                    Say("points", count, Time(rig, 1, count, (cmd, target, queries) => points.Record(cmd, target, queries, count, 0)));
                    if (count < 10000)
                    {
                        Say("rays down", count, Time(rig, 2, count, (cmd, target, queries) => rays.Record(cmd, target, queries, count, 0)));
                    }
                    if (count == 100)
                    {
                        Say("nearest", count,
                            Time(rig, 2, count, (cmd, target, queries) => nearest.Record(cmd, target, queries, count, 0)));
                    }
                }
            }
        }

        private static void Say(string what, int count, double milliseconds) =>
            TestContext.WriteLine($"{count} {what}: {milliseconds:0.000} ms");

        // Of a recorded batch over an empty one, the least of some.
        private static double Time(QueryRig rig, int words, int count, Action<CommandBuffer, QueryTarget, GraphicsBuffer> record)
        {
            var random = new System.Random(1);
            var asked = new QueryWord[words * count];
            for (int i = 0; i < count; i++)
            {
                Vector3 place = Vector3.Scale(ParticleSets.RandomVector(random), rig.Solver.Settings.DomainSize);
                asked[words * i] = new QueryWord { Vector = QueryRig.World(place), Number = 1u };
                if (words > 1) asked[words * i + 1] = new QueryWord(QueryRig.Turn * Vector3.down, 1f);
            }
            double Run(int repeats)
            {
                var watch = Stopwatch.StartNew();
                rig.Ask<FluidPointResult>(asked, count, 0, (cmd, target, queries) =>
                {
                    for (int i = 0; i < repeats; i++) record(cmd, target, queries);
                });
                return watch.Elapsed.TotalMilliseconds;
            }
            Run(1);
            return (Enumerable.Range(0, 5).Min(_ => Run(Repeats + 1)) - Enumerable.Range(0, 5).Min(_ => Run(1))) / Repeats;
        }
    }
}
