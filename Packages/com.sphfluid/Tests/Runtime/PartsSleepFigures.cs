using System;
using System.Collections;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    /// <summary>
    /// The manual's table of a wave that a wall pushes into a pool: where parts of it sleep, and where all of it is awake. Two pushes into
    /// liquid that is awake, a moment apart, tell what chance does.
    /// </summary>
    [Explicit("Takes minutes.")]
    public sealed class PartsSleepFigures
    {
        private const float Spacing = 0.05f, PushTime = 0.4f;
        private const double Settled = 8.0, WaveTime = 3.0;
        private static readonly Vector3Int Layers = new Vector3Int(110, 10, 6);
        private static readonly float[] Gauges = { 0.3f, 0.6f, 0.85f };

        private static readonly Dictionary<(string, int), Run> Runs = new Dictionary<(string, int), Run>();

        // Each push has a test of its own, as a test has three minutes; the last of them compares.
        [UnityTest]
        public IEnumerator Wave([Values(24, 60)] int framesPerSecond, [Values("asleep", "awake", "awake later")] string liquid)
        {
            var run = new Run();
            Runs[(liquid, framesPerSecond)] = run;
            yield return Play(run, liquid == "asleep", liquid == "awake later" ? 0.35 : 0.0, framesPerSecond);
            Say($"{liquid}, {run.AsleepShare:0.00} asleep at {run.Settled:0.0} s: ahead of the wave {run.Ahead}; anywhere {run.Anywhere}");
            if (liquid != "awake later" || !Runs.TryGetValue(("awake", framesPerSecond), out Run awake)) yield break;
            foreach (string name in new[] { "asleep", liquid })
            {
                for (int gauge = 0; gauge < Gauges.Length; gauge++) Compare(name, Runs[(name, framesPerSecond)], awake, gauge);
            }
        }

        private static IEnumerator Play(Run run, bool sleeps, double later, int framesPerSecond)
        {
            using (var rig = new SimulationRig(1f / framesPerSecond))
            {
                FluidSimulation pool = rig.Create(liquid: false);
                (pool.Spacing, pool.SleepsAtRest, pool.PartsSleep) = (Spacing, sleeps, sleeps);
                pool.DomainSize = Spacing * (Vector3)(Layers + 8 * Vector3Int.up);
                FluidVolume water = rig.AddVolume(pool);
                water.Size = Spacing * (Vector3)Layers;
                water.transform.localPosition = 4f * Spacing * Vector3.down;
                Transform wall = rig.NewObject("Wall").transform;
                wall.gameObject.AddComponent<BoxCollider>().size = Spacing * new Vector3(4f, 30f, 20f);
                Vector3 place = Spacing * (0.5f * Layers.x + 2f) * Vector3.left;
                wall.position = place;
                while (pool.SimulatedTime < Settled + later || sleeps && pool.AsleepShare < 0.9f) yield return null;
                var particles = new List<FluidParticle>();
                var densities = new float[pool.ParticleCount];
                run.AsleepShare = pool.AsleepShare;
                run.Begin(SimulationRig.Read(pool));
                double begin = run.Settled = pool.SimulatedTime;
                while (pool.SimulatedTime < begin + WaveTime)
                {
                    float share = Mathf.Clamp01((float)(pool.SimulatedTime - begin) / PushTime);
                    wall.position = place + 6f * Spacing * (share * share * (3f - 2f * share)) * Vector3.right;
                    yield return null;
                    particles.Clear();
                    pool.TryReadParticles(particles);
                    pool.Solver.Density.GetData(densities);
                    run.Add(pool.SimulatedTime - begin, particles.ToArray(), densities);
                }
            }
        }

        private static void Compare(string name, Run run, Run awake, int gauge)
        {
            double[] wave = run.Heights[gauge].ToArray(), reference = awake.Heights[gauge].ToArray();
            double crest = run.Crest(gauge, out double at), expected = awake.Crest(gauge, out double due);
            double half = run.Rise(gauge, 0.5 * expected), halfDue = awake.Rise(gauge, 0.5 * expected);
            double delay = run.DelayTo(awake, gauge);
            Say($"{name} at {Gauges[gauge]:0.00}: crest {crest:0.00} for {expected:0.00} dx, at {at:0.000} for {due:0.000} s;");
            Say($"half of its height at {half:0.000} for {halfDue:0.000} s;");
            Say($"shifted by {delay:0.0000} s, {100 * delay / due:0.00} % of the way");
        }

        private static void Say(FormattableString text) => Console.WriteLine(FormattableString.Invariant(text));

        /// <summary>Heights of the water at the gauges over time, and the densities of what the crest has not reached.</summary>
        private sealed class Run
        {
            private const int Count = 3;

            // dx: half the width of a gauge.
            private const double Width = 2.0;

            private readonly List<double> times = new List<double>();
            private readonly double[] rest = new double[Count];
            public List<double>[] Heights { get; } = Enumerable.Range(0, Count).Select(_ => new List<double>()).ToArray();

            public float AsleepShare { get; set; }

            public double Settled { get; set; }

            public Worst Ahead { get; } = new Worst();

            public Worst Anywhere { get; } = new Worst();

            public void Begin(FluidParticle[] particles)
            {
                for (int gauge = 0; gauge < Count; gauge++) rest[gauge] = Height(particles, gauge);
            }

            public void Add(double time, FluidParticle[] particles, float[] densities)
            {
                times.Add(time);
                for (int gauge = 0; gauge < Count; gauge++) Heights[gauge].Add(Height(particles, gauge) - rest[gauge]);
                Ahead.Add(particles, densities, (-0.5f * Layers.x + 12f) * Spacing + 3f * (float)time); // the wave goes with 2.2 to 2.6 m/s
                Anywhere.Add(particles, densities, (-0.5f * Layers.x + 8f) * Spacing);
            }

            public double Crest(int gauge, out double at)
            {
                int i = Heights[gauge].IndexOf(Heights[gauge].Max());
                at = times[i];
                return Heights[gauge][i];
            }

            public double Rise(int gauge, double height)
            {
                List<double> wave = Heights[gauge];
                for (int i = 1; i < wave.Count; i++)
                {
                    if (wave[i] < height) continue;
                    double part = (height - wave[i - 1]) / (wave[i] - wave[i - 1]);
                    return times[i - 1] + part * (times[i] - times[i - 1]);
                }
                return double.NaN;
            }

            /// <summary>By how much this wave is later than another [s]: the shift for which they differ least until the crest.</summary>
            public double DelayTo(Run other, int gauge)
            {
                other.Crest(gauge, out double crest);
                double best = 0.0, least = double.MaxValue;
                for (double shift = -0.15; shift <= 0.15; shift += 0.0005)
                {
                    double sum = 0.0;
                    for (int i = 0; i < other.times.Count && other.times[i] < crest + 0.1; i++)
                    {
                        double difference = At(gauge, other.times[i] + shift) - other.Heights[gauge][i];
                        sum += difference * difference;
                    }
                    if (sum < least) (best, least) = (shift, sum);
                }
                return best;
            }

            private double At(int gauge, double time)
            {
                int i = times.BinarySearch(time);
                if (i < 0) i = ~i;
                if (i == 0) return 0.0;
                if (i >= times.Count) return Heights[gauge][times.Count - 1];
                double part = (time - times[i - 1]) / (times[i] - times[i - 1]);
                return Heights[gauge][i - 1] + part * (Heights[gauge][i] - Heights[gauge][i - 1]);
            }

            // dx
            private static double Height(FluidParticle[] particles, int gauge)
            {
                double place = (Gauges[gauge] - 0.5) * Layers.x * Spacing, sum = 0.0;
                foreach (FluidParticle p in particles) sum += Math.Max(0.0, 1.0 - Math.Abs(p.Position.x - place) / (Width * Spacing));
                return sum / (Width * Layers.z);
            }
        }

        /// <summary>
        /// The fastest particle, and the largest difference of a density from the mean of its layer; deeper than 2 dx, and 3 dx above the
        /// floor.
        /// </summary>
        private sealed class Worst
        {
            private double fastest, difference, squares;
            private long number;

            public void Add(FluidParticle[] particles, float[] densities, float from)
            {
                foreach (IGrouping<int, int> layer in Enumerable.Range(0, particles.Length)
                    .Where(i => particles[i].Position.x > from && particles[i].Position.x < (0.5f * Layers.x - 3f) * Spacing)
                    .GroupBy(i => Mathf.FloorToInt(particles[i].Position.y / Spacing + 0.5f * (Layers.y + 8))))
                {
                    if (layer.Key < 3 || layer.Key >= Layers.y - 2 || layer.Count() < 100) continue;
                    double mean = layer.Average(i => densities[i]);
                    foreach (int i in layer)
                    {
                        double error = Math.Abs(densities[i] - mean) / 1000.0;
                        fastest = Math.Max(fastest, particles[i].VelT0.magnitude);
                        difference = Math.Max(difference, error);
                        squares += error * error;
                        number++;
                    }
                }
            }

            public override string ToString() => FormattableString.Invariant(
                $"{fastest:0.00} m/s, density {100 * difference:0.0} % ({100 * Math.Sqrt(squares / Math.Max(1, number)):0.00} % rms)");
        }
    }
}
