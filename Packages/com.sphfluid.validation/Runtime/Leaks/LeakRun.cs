using System;
using System.Collections;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Plays a scene frame by frame and shows its detectors every state.</summary>
    internal sealed class LeakRun : IDisposable
    {
        // Time at the end in which gravity moves all that nothing carries: 0.1 s, a fall of 49 mm.
        private const int RestFrames = 6;

        // In particle-steps: what a step has whatever the number of particles, reading a particle, and holding it against a triangle.
        private const double StepOverhead = 1500.0, LookWeight = 1.5, TriangleWeight = 0.015;

        // A surface that moves costs its listing; from this path a frame on, in R, most of it is the search along the path. By ./run leaks
        // on two CPU cores, 2026-11-25: a cup shaken at 1 and at 165 m/s takes 1.9 and 14 s.
        private const double MovingWeight = 3.0, LongPath = 24.0;

        private readonly LeakScene scene;
        private readonly LeakSurfaces surfaces;
        private readonly FluidSolver solver;
        private readonly int stepsPerFrame;
        private bool disposed;

        /// <exception cref="ArgumentException">The particles or constants cannot be computed with.</exception>
        /// <exception cref="FluidDeviceException">The device cannot run it.</exception>
        public LeakRun(LeakScene scene, FluidShaderSet shaders)
        {
            this.scene = scene;
            stepsPerFrame = StepsPerFrame(scene);
            solver = new FluidSolver(scene.Settings, shaders, scene.Particles);
            surfaces = new LeakSurfaces(scene);
            if (scene.Solid) surfaces.GiveTo(solver);
        }

        /// <summary>Expected work of a scene: its steps, and what looking at the particles between them takes.</summary>
        public static double CostOf(LeakScene scene)
        {
            bool eachStep = scene.Bodies.Any(b => LeakDetector.Of(b, scene.Settings.PeriodLength).NeedsSteps);
            int steps = StepsPerFrame(scene), looks = eachStep ? steps : 1;
            double path = scene.Speed / LeakScene.FrameRate / scene.Settings.SupportRadius / LongPath;
            double moving = scene.Moves ? MovingWeight * (1.0 + path * path) : 1.0;
            double look = (LookWeight + (eachStep ? TriangleWeight * scene.Bodies.Sum(b => b.Surface.Length / 3) : 0.0)) *
                scene.Particles.Length;
            return scene.Frames * (moving * steps * CostOfStep(scene.Particles.Length) + looks * look);
        }

        /// <summary>Expected work of a step.</summary>
        public static double CostOfStep(int particles) => particles + StepOverhead;

        /// <summary>The part that is done, 0 to 1.</summary>
        public double Share { get; private set; }

        /// <summary>The result, when the run has ended.</summary>
        public LeakResult Result { get; private set; }

        /// <summary>The run; it yields after each frame of the scene.</summary>
        public IEnumerator Run()
        {
            FluidParticle[] state = Look(), earlier = state;
            double start = Energy(state), highest = start, fastest = 0.0;
            for (int frame = 1; frame <= scene.Frames; frame++)
            {
                int looks = surfaces.NeedsSteps ? stepsPerFrame : 1;
                for (int look = 1; look <= looks; look++)
                {
                    // Steps that are looked at one by one each have a part of the frame's motion.
                    surfaces.Move(frame, look, looks);
                    int steps = stepsPerFrame / looks;
                    GpuWork.Submit("Leak Scene", cmd => solver.RecordSteps(cmd, steps, 1f / (LeakScene.FrameRate * stepsPerFrame)));
                    state = Look();
                    fastest = Math.Max(fastest, solver.ReadCountersNow().MaxSpeed);
                }
                highest = Math.Max(highest, Energy(state));
                if (frame == scene.Frames - RestFrames) earlier = state;
                Share = (double)frame / scene.Frames;
                yield return null;
            }
            Result = new LeakResult
            {
                Scene = scene,
                Steps = solver.StepCount,
                Escapes = surfaces.CountEscapes(),
                Counters = solver.ReadCountersNow(),
                Jumps = surfaces.Jumps,
                MaxSpeed = fastest,
                EnergyRatio = !scene.Moves ? highest / start : double.NaN,
                Rest = scene.Rests ? WallRest.Of(scene, surfaces.Pose, Places(earlier), Places(state)) : default(WallRest?),
                End = state,
            };
        }

        /// <summary>Runs to the end at once; for tests and tools.</summary>
        public LeakResult RunToEnd()
        {
            new SessionWork(Run()).Finish();
            return Result;
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            if (disposed) return;
            disposed = true;
            solver.Dispose();
            surfaces.Dispose();
        }

        private static int StepsPerFrame(LeakScene scene) => (int)Math.Ceiling(1.0 / LeakScene.FrameRate / scene.Settings.TimeStep);

        // Kinetic and potential energy over the mass of a particle, from the floor of the domain, J/kg.
        private double Energy(FluidParticle[] state)
        {
            double sum = 0.0, gravity = scene.Settings.Gravity.magnitude, floor = -0.5 * scene.Settings.DomainSize.y;
            foreach (FluidParticle particle in state) sum += 0.5 * particle.VelT0.sqrMagnitude + gravity * (particle.Position.y - floor);
            return sum;
        }

        private static Vector3[] Places(FluidParticle[] state) => Array.ConvertAll(state, p => p.Position);

        // The particles by id, after the detectors have seen them.
        private FluidParticle[] Look()
        {
            GpuWork.Submit("Leak Look", cmd => solver.RecordNeighbourSetup(cmd));
            var particles = new FluidParticle[solver.ParticleCount];
            solver.Particles.GetData(particles);
            Array.Sort(particles, (a, b) => a.Id.CompareTo(b.Id));
            surfaces.Look(Places(particles));
            return particles;
        }
    }
}
