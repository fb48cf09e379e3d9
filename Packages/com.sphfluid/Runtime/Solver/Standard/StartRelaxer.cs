using System;
using System.Collections.Generic;
using System.Diagnostics;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Brings particles to rest by damped steps of the Standard method, in command buffers of bounded work. With a damping rate γ
    /// of π c/H a column of height H settles as fast as it can without swinging: its slowest wave has the rate π c/(2 H). Liquid whose
    /// lattice cannot carry it, as between upright walls, creeps on under that; it is let flow almost freely for a while, and settled
    /// again.
    /// </summary>
    internal sealed class StartRelaxer : IDisposable
    {
        // Particle-steps of a command buffer: a tenth of a second on a slow card, where a driver gives up after two.
        private const int WorkPerBuffer = 1 << 22;
        private const int MostStepsPerBuffer = 16;

        // Longest time without asking whether to go on; a single step may take longer.
        private const double SubmissionSeconds = 0.2;

        // Times that sound crosses the liquid while it settles.
        private const double Crossings = 8.0;

        // Flowing takes about ten times √(H/g) in all, whether damped by half a √(g/H) or not at all; ten times that damping stops it.
        private const double FlowTime = 4.0;
        private const double FlowRate = 0.5;
        private const int MostFlows = 16;

        // Overlaps push particles about their own width; they part at once, and sooner than the liquid as a whole settles.
        private const double LocalRate = 0.5;

        private readonly StandardStepper stepper;
        private readonly StandardState state;
        private readonly DampVelocitiesPass damping;
        private readonly CounterReadback counters;
        private readonly double step, crossing, fall;
        private readonly RestEstimate estimate;
        private readonly Stopwatch watch = new Stopwatch();
        private Func<FluidStartProgress, bool> watcher;
        private double timeLeft, secondsPerStep;

        /// <summary>Takes particles at rest.</summary>
        /// <param name="settings">The physics; its gravity acts.</param>
        /// <param name="shaders">The compute shaders.</param>
        /// <param name="particles">The particles; their velocities do not count.</param>
        /// <param name="bodies">The scene's bodies; null for none.</param>
        /// <param name="height">Height over which the liquid settles [m].</param>
        public StartRelaxer(in FluidSolverSettings settings, FluidShaderSet shaders, IReadOnlyList<FluidParticle> particles,
            CollisionBodies bodies, double height)
        {
            damping = new DampVelocitiesPass(shaders);
            step = Math.Min(settings.TimeStep, StandardRules.Advise(settings, settings.MaxSpeed).Largest);
            double depth = Math.Max(height, settings.SupportRadius);
            crossing = depth / settings.SoundSpeed;
            fall = settings.Gravity.sqrMagnitude > 0f ? Math.Sqrt(depth / settings.Gravity.magnitude) : 0.0;
            timeLeft = 0.5 * Crossings * crossing;
            estimate = new RestEstimate(crossing, Crossings * crossing, FlowTime * fall);
            var start = new FluidParticle[particles.Count];
            for (int i = 0; i < start.Length; i++) start[i] = new FluidParticle(particles[i].Position, Vector3.zero, particles[i].Id);
            stepper = new StandardStepper(settings, shaders, start.Length);
            state = stepper.State;
            state.Bodies = bodies;
            state.Published.Particles.SetData(start);
            counters = new CounterReadback(state.Published.Counters, settings.RestDensity);
        }

        /// <summary>Steps taken.</summary>
        public int Steps { get; private set; }

        /// <summary>Largest speed in the last steps [m/s].</summary>
        public float Speed { get; private set; }

        /// <summary>
        /// Largest acceleration that the damping held in the last steps, about what moves the liquid when it is let go [m/s²].
        /// </summary>
        public double Acceleration => Speed * Rate;

        // π c/H.
        private double Rate => Math.PI / crossing;

        /// <summary>
        /// Settles the liquid, lets it flow and settles it again until no particle is accelerated by more than what is asked for, or
        /// sixteen times.
        /// </summary>
        /// <param name="acceleration">Largest acceleration to be left [m/s²].</param>
        /// <param name="goesOn">Asked after each part of bounded work; false ends the relaxation. Null: nobody is asked.</param>
        /// <returns>Whether it came to that.</returns>
        /// <exception cref="OperationCanceledException">It was ended.</exception>
        public bool Run(double acceleration, Func<FluidStartProgress, bool> goesOn = null)
        {
            watcher = goesOn;
            watch.Restart();
            using (var cmd = new CommandBuffer { name = "SPH Fluid Relaxation" })
            {
                stepper.RecordLoad(cmd);
                Settle(cmd, acceleration);
                for (int flows = 0; flows < MostFlows && fall > 0.0 && Acceleration > acceleration; flows++)
                {
                    Flow(cmd);
                    Settle(cmd, acceleration);
                }
                stepper.RecordNeighbourSetup(cmd);
                stepper.RecordPublish(cmd);
                Graphics.ExecuteCommandBuffer(cmd);
            }
            return Acceleration <= acceleration;
        }

        /// <summary>The particles in the order of their ids.</summary>
        public FluidParticle[] Read()
        {
            var particles = new FluidParticle[state.ParticleCount];
            state.Published.Particles.GetData(particles);
            Array.Sort(particles, (a, b) => a.Id.CompareTo(b.Id));
            return particles;
        }

        public void Dispose()
        {
            counters.Dispose();
            state.Dispose();
        }

        // At once where overlaps part, then where the liquid as a whole settles.
        private void Settle(CommandBuffer cmd, double acceleration)
        {
            double local = Math.Max(LocalRate * state.Settings.SoundSpeed / state.Settings.Spacing, Rate);
            double time = 0.0;
            do
            {
                time = Advance(cmd, time, Crossings * crossing, t => Rate + (local - Rate) * Math.Exp(-t / crossing));
                timeLeft = estimate.Settling(time, Acceleration / acceleration);
            }
            while (time < Crossings * crossing && !(Acceleration <= acceleration && time > crossing));
        }

        private void Flow(CommandBuffer cmd)
        {
            for (double time = 0.0; time < FlowTime * fall; timeLeft = estimate.Flowing(time))
            {
                time = Advance(cmd, time, FlowTime * fall, _ => FlowRate / fall);
            }
        }

        // A command buffer of steps: the time after them.
        private double Advance(CommandBuffer cmd, double time, double end, Func<double, double> rate)
        {
            int batch = Mathf.Clamp(WorkPerBuffer / state.ParticleCount, 1, MostStepsPerBuffer);
            counters.RecordReset(cmd);
            int recorded = 0;
            for (int i = 0; i < batch && time < end; i++)
            {
                if (recorded >= StepsPerSubmission) Submit(cmd, ref recorded);
                state.BeginBodyStep(0, 1, (float)step);
                stepper.RecordNeighbourSetup(cmd);
                stepper.RecordMotion(cmd, new FluidStep((float)step, (float)step, Steps == 0));
                damping.Record(cmd, state, (float)Math.Exp(-rate(time) * step));
                Steps++;
                recorded++;
                time += step;
            }
            Submit(cmd, ref recorded);
            return time;
        }

        // How many steps are submitted at once does not change what they compute: only maxima of a whole batch are looked at.
        private int StepsPerSubmission => secondsPerStep > 0.0 ? Math.Max(1, (int)(SubmissionSeconds / secondsPerStep)) : 1;

        // Executes, waits, and asks whether to go on.
        private void Submit(CommandBuffer cmd, ref int recorded)
        {
            double before = watch.Elapsed.TotalSeconds;
            Graphics.ExecuteCommandBuffer(cmd);
            cmd.Clear();
            Speed = counters.ReadNow().MaxSpeed;
            double now = watch.Elapsed.TotalSeconds;
            secondsPerStep = (now - before) / Math.Max(1, recorded);
            recorded = 0;
            double left = timeLeft / step * (now / Math.Max(1, Steps));
            if (watcher != null && !watcher(new FluidStartProgress(Steps, now, left)))
            {
                throw new OperationCanceledException("The relaxed start was ended.");
            }
        }
    }
}
