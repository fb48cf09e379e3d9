using System;
using System.Collections;
using System.Diagnostics;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid.Validation
{
    /// <summary>
    /// How long a step takes on this device, now: half a second of the Standard method on a small liquid. What a long measurement will
    /// take follows from its number of particle-steps.
    /// </summary>
    internal sealed class DeviceCalibration
    {
        /// <summary>Particles of the liquid.</summary>
        public const int Particles = 4096;

        private const double LeastSeconds = 0.4;
        private const int MostStepsAtOnce = 256;

        private readonly FluidShaderSet shaders;

        public DeviceCalibration(FluidShaderSet shaders) => this.shaders = shaders;

        /// <summary>Time of a step [s], when <see cref="Run"/> has ended; overheads of submitting are in it.</summary>
        public double SecondsPerStep { get; private set; }

        /// <summary>Measures; it yields after each submission. The first one, which compiles, does not count.</summary>
        public IEnumerator Run()
        {
            using (var liquid = new BenchLiquid(shaders, BenchSolver.Standard, Particles))
            using (var cmd = new CommandBuffer { name = "Device Calibration" })
            {
                var clock = new Stopwatch();
                for (int steps = 0, next = 1; clock.Elapsed.TotalSeconds < LeastSeconds; next = Math.Min(2 * next, MostStepsAtOnce))
                {
                    bool counts = steps > 0;
                    cmd.Clear();
                    liquid.Solver.RecordSteps(cmd, next);
                    if (counts) clock.Start();
                    Graphics.ExecuteCommandBuffer(cmd);
                    liquid.Solver.ReadCountersNow(); // waits
                    clock.Stop();
                    steps += counts ? next : 1;
                    SecondsPerStep = clock.Elapsed.TotalSeconds / Math.Max(1, steps - 1);
                    yield return null;
                }
            }
        }
    }
}
