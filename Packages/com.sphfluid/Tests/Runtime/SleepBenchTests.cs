using System;
using System.Collections;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.TestTools;

namespace SphFluid.Tests
{
    public sealed class SleepBenchTests
    {
        private SimulationRig rig;

        [SetUp]
        public void SetUp() => rig = new SimulationRig(1f / 60f);

        [TearDown]
        public void TearDown() => rig.Dispose();

        private static float Env(string name, float otherwise) =>
            float.TryParse(Environment.GetEnvironmentVariable(name), out float f) ? f : otherwise;

        [UnityTest, Explicit]
        public IEnumerator Pool()
        {
            int n = (int)Env("N", 48), h = (int)Env("H", 10);
            float dx = 0.05f;
            FluidSimulation simulation = rig.Create(liquid: false);
            simulation.Spacing = dx;
            simulation.DomainSize = new Vector3(n * dx, (h + 8) * dx, n * dx);
            FluidVolume pool = rig.AddVolume(simulation, "Pool");
            pool.Size = new Vector3(n * dx, h * dx, n * dx);
            pool.transform.localPosition = new Vector3(0f, -4 * dx, 0f);
            GameObject body = null;
            float bob = Env("BOB", 0f);
            if (bob > 0f)
            {
                body = GameObject.CreatePrimitive(PrimitiveType.Cube);
                body.layer = SimulationRig.Layer;
                body.transform.localScale = Vector3.one * 6 * dx;
                body.transform.position = new Vector3(-(n / 2 - 8) * dx, (h / 2f - 4) * dx, -(n / 2 - 8) * dx);
            }
            simulation.SleepsAtRest = simulation.PartsSleep = Env("SLEEP", 1f) > 0f;
            float unit = Mathf.Sqrt(9.81f * dx);
            bool sleeps = Env("SLEEP", 1f) > 0f;
            while (!simulation.IsRunning) yield return null;
            var state = (CellState)simulation.Solver.State;
            yield return null;
            if (sleeps) Console.Error.WriteLine($"bricks {state.Sleep.Counts} side {state.Sleep.Side}");
            double last = 0;
            long steps = 0;
            bool woken = false;
            Process process = Process.GetCurrentProcess();
            double cpu = process.TotalProcessorTime.TotalSeconds;
            Vector3 corner = new Vector3(-(n / 2 - 8) * dx, (h / 2f - 4) * dx, -(n / 2 - 8) * dx);
            while (simulation.SimulatedTime < Env("END", 6f))
            {
                if (body != null && simulation.SimulatedTime > Env("START", 3f))
                {
                    body.transform.position = corner + Vector3.up * (bob * dx * Mathf.Sin(((float)simulation.SimulatedTime - Env("START", 3f)) * Env("OMEGA", 4f)));
                }
                if (sleeps && simulation.SimulatedTime > Env("WAKE", 1000f) && !woken)
                {
                    woken = true;
                    simulation.Wake();
                }
                yield return null;
                if (simulation.SimulatedTime < last + (simulation.SimulatedTime > Env("FINE", 1000f) ? 0.01 : 0.5)) continue;
                last = simulation.SimulatedTime;
                FluidParticle[] particles = SimulationRig.Read(simulation);
                process.Refresh();
                double wall = process.TotalProcessorTime.TotalSeconds - cpu;
                var bricks = new Dictionary<(int, int, int), (Vector3 sum, int count, float max)>();
                float side = 4 * 2.25f * dx;
                foreach (FluidParticle p in particles)
                {
                    Vector3 at = (p.Position + simulation.DomainSize / 2) / side;
                    var key = ((int)at.x, (int)at.y, (int)at.z);
                    bricks.TryGetValue(key, out var old);
                    bricks[key] = (old.sum + p.VelT0, old.count + 1, Mathf.Max(old.max, p.VelT0.magnitude));
                }
                float[] means = bricks.Values.Where(b => b.count > 50).Select(b => b.sum.magnitude / b.count / unit).OrderBy(v => v).ToArray();
                float[] small = bricks.Values.Where(b => b.count <= 50).Select(b => b.sum.magnitude / b.count / unit).OrderBy(v => v).ToArray();
                float[] rms = bricks.Select(b => Mathf.Sqrt(particles.Where(p => { Vector3 at = (p.Position + simulation.DomainSize / 2) / side; return ((int)at.x, (int)at.y, (int)at.z) == b.Key; }).Average(p => p.VelT0.sqrMagnitude)) / unit).OrderBy(v => v).ToArray();
                float[] fast = bricks.Values.Select(b => b.max / unit).OrderBy(v => v).ToArray();
                string sleepers = "";
                if (sleeps)
                {
                    uint[] words = GpuTest.Read<uint>(state.Sleep.Bricks, state.Sleep.Total * SleepBricks.Words);
                    int asleep = 0;
                    for (int i = 0; i < state.Sleep.Total; i++) asleep += words[i * SleepBricks.Words + SleepBricks.State] == SleepBricks.Asleep ? 1 : 0;
                    sleepers = $"asleep {asleep} of {state.Sleep.Total}, {particles.Count(p => p.VelT0 == Vector3.zero)} of {particles.Length} particles share {simulation.AsleepShare:F3}";
                }
                float Q(float[] a, double q) => a.Length == 0 ? 0 : a[Math.Min(a.Length - 1, (int)(q * a.Length))];
                double energy = particles.Sum(p => 0.5 * p.VelT0.sqrMagnitude + 9.81 * p.Position.y) / particles.Length;
                Console.Error.WriteLine($"t {last:F2} steps {simulation.Solver.StepCount - steps} sorts {simulation.Solver.SetupCount} wall {wall:F2} s | mean q50 {Q(means, .5):F4} q90 {Q(means, .9):F4} max {Q(means, 1):F4} small {Q(small, 1):F4} | fast q50 {Q(fast, .5):F3} q90 {Q(fast, .9):F3} max {Q(fast, 1):F3} rms {Q(rms, .5):F3} {Q(rms, .9):F3} {Q(rms, 1):F3} c {simulation.Solver.Settings.SoundSpeed:F2} E {energy:F5} {sleepers}");
                steps = simulation.Solver.StepCount;
                process.Refresh();
                cpu = process.TotalProcessorTime.TotalSeconds;
            }
            if (body != null) UnityEngine.Object.DestroyImmediate(body);
        }

        [UnityTest, Explicit]
        public IEnumerator Wave()
        {
            int n = (int)Env("N", 120), h = (int)Env("H", 16), w = (int)Env("W", 10);
            float dx = 0.05f, start = Env("START", 4.5f);
            FluidSimulation simulation = rig.Create(liquid: false);
            simulation.Spacing = dx;
            simulation.DomainSize = new Vector3(n * dx, (h + 10) * dx, w * dx);
            FluidVolume pool = rig.AddVolume(simulation, "Pool");
            pool.Size = new Vector3(n * dx, h * dx, w * dx);
            pool.transform.localPosition = new Vector3(0f, -5 * dx, 0f);
            GameObject body = GameObject.CreatePrimitive(PrimitiveType.Cube);
            body.layer = SimulationRig.Layer;
            body.transform.localScale = new Vector3(6, 20, w + 2) * dx;
            Vector3 left = new Vector3(-n / 2f - 2, -3, 0) * dx;
            body.transform.position = left;
            simulation.SleepsAtRest = simulation.PartsSleep = Env("SLEEP", 1f) > 0f;
            float push = Env("PUSH", 2f);
            double rest = 0;
            while (!simulation.IsRunning) yield return null;
            while (simulation.SimulatedTime < start + Env("LONG", 3f))
            {
                float t = Mathf.Clamp01(((float)simulation.SimulatedTime - start) / Env("RISE", 0.5f));
                body.transform.position = left + Vector3.right * (push * dx * (t - Mathf.Sin(2 * Mathf.PI * t) / (2 * Mathf.PI)));
                yield return null;
                if (simulation.SimulatedTime < start - 0.3) continue;
                FluidParticle[] particles = SimulationRig.Read(simulation);
                string line = "";
                foreach (float at in new[] { 0.3f, 0.6f, 0.85f })
                {
                    float x = (at - 0.5f) * n * dx;
                    line += $" {particles.Where(p => Mathf.Abs(p.Position.x - x) < 3 * dx).Average(p => (double)p.Position.y) * 2 / dx:F4}";
                }
                double energy = particles.Sum(p => 0.5 * p.VelT0.sqrMagnitude + 9.81 * p.Position.y) / particles.Length;
                Console.Error.WriteLine($"W {simulation.SimulatedTime - start:F3}{line} E {energy:F5} asleep {particles.Count(p => p.VelT0 == Vector3.zero) / (float)particles.Length:F3} max {particles.Max(p => p.VelT0.magnitude):F3}");
            }
            UnityEngine.Object.DestroyImmediate(body);
        }
    }
}
