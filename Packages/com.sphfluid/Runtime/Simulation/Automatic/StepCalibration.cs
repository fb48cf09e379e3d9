using System;
using System.Collections.Generic;
using System.Diagnostics;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Times steps of a liquid at its start, on a solver beside it with the same particles and colliders: blocks of steps between two waits
    /// for the GPU, less what such a wait takes without steps. A large liquid is timed in part first, and whole only where that fits the
    /// time; else by the part, in proportion.
    /// </summary>
    internal static class StepCalibration
    {
        /// <summary>Time that the timing of a method may take, besides its first steps [s].</summary>
        public const double LongestTime = 0.3;

        private const int StepsABlock = 4;
        private const int MostBlocks = 3;

        // Few enough for any device, enough to fill it in part.
        private const int FirstPart = 4096;

        /// <summary>Times the steps.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="shaders">The shaders.</param>
        /// <param name="particles">Its particles.</param>
        /// <param name="collision">Its colliders, gathered.</param>
        /// <returns>What was measured, with the number of particles that it was measured with; null where there is nothing to time or the
        /// device cannot run it.</returns>
        public static StepCost? Measure(in FluidSolverSettings settings, FluidShaderSet shaders, IReadOnlyList<FluidParticle> particles,
            CollisionScene collision)
        {
            if (particles.Count == 0) return null;
            try
            {
                IReadOnlyList<FluidParticle> part = Middle(particles, FirstPart, settings.Spacing);
                StepCost first = Time(settings, shaders, part, collision, out double took);
                if (part.Count == particles.Count) return first;
                bool fits = took * particles.Count / part.Count < LongestTime;
                return fits ? Time(settings, shaders, particles, collision, out _) : first;
            }
            catch (Exception exception) when (exception is FluidDeviceException || exception is InvalidOperationException)
            {
                return null; // the start reports what the device lacks
            }
        }

        private static StepCost Time(in FluidSolverSettings settings, FluidShaderSet shaders, IReadOnlyList<FluidParticle> particles,
            CollisionScene collision, out double took)
        {
            using (var bodies = new CollisionBodies(settings))
            using (var solver = new FluidSolver(settings, shaders, particles))
            using (var commands = new CommandBuffer { name = "SPH Fluid Calibration" })
            {
                if (FluidMethods.Has(settings.Method, FluidMethodFeatures.BodyContact))
                {
                    bodies.Update(collision.Solids);
                    solver.SetBodies(bodies);
                }
                Seconds(solver, commands, 1); // compiles, allocates, uploads
                double wait = Math.Min(Seconds(solver, commands, 0), Seconds(solver, commands, 0)), spent = 0.0;
                var blocks = new List<double>();
                while (blocks.Count < MostBlocks && (blocks.Count == 0 || spent < LongestTime))
                {
                    blocks.Add(Seconds(solver, commands, StepsABlock));
                    spent += blocks[blocks.Count - 1];
                }
                took = spent;
                blocks.Sort();
                double block = blocks[(blocks.Count - 1) / 2];
                // Steps of a few particles may cost less than waits differ by; they take no longer than the block with its wait.
                double step = (block > wait ? block - wait : block) / StepsABlock;
                return new StepCost { Particles = particles.Count, Milliseconds = 1e3 * step };
            }
        }

        private static double Seconds(FluidSolver solver, CommandBuffer commands, int steps)
        {
            var clock = Stopwatch.StartNew();
            commands.Clear();
            solver.RecordSteps(commands, steps);
            Graphics.ExecuteCommandBuffer(commands);
            solver.ReadCountersNow();
            return clock.Elapsed.TotalSeconds;
        }

        /// <summary>About so many particles about the middle of the liquid, as they lie there.</summary>
        internal static IReadOnlyList<FluidParticle> Middle(IReadOnlyList<FluidParticle> particles, int count, float spacing)
        {
            if (particles.Count <= 2 * count) return particles;
            Vector3 centre = Vector3.zero;
            foreach (FluidParticle particle in particles) centre += particle.Position / particles.Count;
            var distances = new float[particles.Count];
            for (int i = 0; i < distances.Length; i++)
            {
                Vector3 away = particles[i].Position - centre;
                distances[i] = Mathf.Max(Mathf.Abs(away.x), Mathf.Max(Mathf.Abs(away.y), Mathf.Abs(away.z)));
            }
            var sorted = (float[])distances.Clone();
            Array.Sort(sorted);
            float reach = sorted[count - 1] + 0.25f * spacing; // whole layers of the lattice
            var part = new List<FluidParticle>(count);
            for (int i = 0; i < distances.Length; i++)
                if (distances[i] <= reach) part.Add(particles[i]);
            return part;
        }
    }
}
