using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>A started simulation: solver, clock, colliders and the one command buffer of a frame. Owns the GPU memory.</summary>
    internal sealed class FluidRun : IDisposable
    {
        readonly Action<FluidMessage> report;
        readonly FluidObstacles obstacles;
        readonly CommandBuffer commands;
        readonly SubstepMonitor substeps = new SubstepMonitor();
        readonly GuardMonitor guards = new GuardMonitor();
        readonly FluidPace pace;
        readonly FluidFlows flows;
        readonly FluidZones zones;
        readonly RigidbodyFloats floats;
        FluidLiveKey live;
        Vector3 position;
        Quaternion rotation;
        int knownChanges, knownParticles, knownSettings;
        double restedTime;

        /// <summary>Starts; takes over <paramref name="collision"/>, which has been gathered.</summary>
        /// <exception cref="ArgumentException">A setting cannot be computed with.</exception>
        /// <exception cref="FluidDeviceException">The device cannot run the method.</exception>
        public FluidRun(in FluidSpec spec, FluidStart start, CollisionScene collision, in StartWatch watch, Action<FluidMessage> report)
        {
            this.report = report;
            Key = FluidStartKey.Of(spec);
            live = FluidLiveKey.Of(spec);
            (position, rotation) = (spec.Position, spec.Rotation);
            Solver = new FluidSolver(start.Constants, spec.Profile.Shaders, RelaxedStart.Particles(spec, start, collision, watch, report),
                spec.CapacityPolicy == FluidCapacityPolicy.Fixed && spec.Capacity > 0 ? spec.MostParticles : 0);
            flows = new FluidFlows(Solver, report);
            zones = new FluidZones(Solver, report);
            commands = new CommandBuffer { name = "SPH Fluid" };
            try
            {
                obstacles = new FluidObstacles(Solver.Settings, collision);
                pace = new FluidPace(spec, start, Solver);
                obstacles.Share();
                if (obstacles.Bodies != null) collision.Owners = floats = new RigidbodyFloats(Solver.Settings.SupportRadius);
                FollowBodies(spec);
                Solver.SetObstacles(obstacles);
                Execute(0);
                Know();
            }
            catch
            {
                Dispose();
                throw;
            }
        }

        public FluidSolver Solver { get; }
        public FluidStartKey Key { get; }
        public float TimeStep => (float)pace.Clock.TimeStep;
        public long CapHits => substeps.CapHits;
        public double RealTimeFactor => substeps.RealTimeFactor;
        public long GpuBytes => Solver.GpuBytes + obstacles.GpuBytes + pace.GpuBytes;
        public bool IsAsleep => pace.IsAsleep;

        /// <summary>Time since the start [s], that of rest without steps included.</summary>
        public double SimulatedTime => Solver.SimulatedTime + restedTime;
        public CollisionScene Collision => obstacles.Scene;

        /// <summary>Advances by a frame.</summary>
        /// <param name="spec">The simulation as it is now.</param>
        /// <param name="deltaTime">Frame time [s]; null: one step, whatever the time.</param>
        /// <param name="failure">What went wrong.</param>
        /// <returns>False when it cannot go on.</returns>
        public bool TryAdvance(in FluidSpec spec, float? deltaTime, out FluidMessage failure)
        {
            failure = default;
            try
            {
                Advance(spec, deltaTime);
                return true;
            }
            catch (Exception exception) when (exception is ArgumentException || exception is FluidDeviceException)
            {
                failure = FluidReports.Failure(spec.Owner, exception);
                return false;
            }
        }

        void Advance(in FluidSpec spec, float? frameTime)
        {
            float deltaTime = frameTime ?? 0f;
            if (WasChanged() | ApplyChanges(spec) | GatherColliders(spec) | Moved(spec) | frameTime == null | flows.Acts(spec) | zones.Waits(spec) | zones.Follow(spec, 0.0)) pace.Wake();
            if (pace.IsAsleep)
            {
                Rest(deltaTime);
                return;
            }
            floats?.Follow();
            FollowBodies(spec);
            double motion = Math.Max(obstacles.Bodies?.LongestMotion ?? 0.0, deltaTime * flows.FastestSpeed(spec));
            int steps = frameTime == null ? pace.StepOnce(motion) : pace.Advance(deltaTime, motion);
            flows.Begin(spec, steps * pace.Clock.TimeStep);
            if (zones.Waits(spec)) zones.Follow(spec, steps * pace.Clock.TimeStep);
            Execute(steps);
            flows.End(spec, steps);
            if (steps > 0) floats?.Note(obstacles.Bodies.Floating, Solver.SimulatedTime);
            if (steps > 0) pace.Stepped(steps * pace.Clock.TimeStep);
            Know();
            if (substeps.Note(pace.Clock, steps, deltaTime) is string text)
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.SubstepCap, spec.Owner, text,
                    "Raise Max Substeps Per Frame, use a larger Particle Spacing, or lower the profile's Sound Speed Ratio."));
            if (guards.Note(Solver.Counters) is string guard)
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.GuardActed, spec.Owner, guard,
                    "Lower the profile's Time Step Fraction, or raise Expected Speed or set Time Step Mode to Adaptive when colliders or forces move the liquid faster than its fall."));
        }

        /// <summary>Whether there are Rigidbodies that the liquid moves.</summary>
        public bool MovesBodies => floats != null && floats.Count > 0;

        /// <summary>Before a step of the scene's physics.</summary>
        public void FixedUpdate(Vector3 domainPosition, Quaternion domainRotation, float deltaTime) => floats?.FixedUpdate(domainPosition, domainRotation, deltaTime);

        /// <summary>What pushes the liquid.</summary>
        public FluidZones Zones => zones;

        /// <summary>What comes into the liquid and leaves it.</summary>
        public FluidFlows Flows => flows;

        /// <summary>Adds a shape of liquid with the next steps.</summary>
        /// <returns>Number of particles that are tried.</returns>
        public int AddLiquid(in FluidSpec spec, LiquidShape shape)
        {
            SpawnRequest request = SpawnRequests.For(spec, new[] { shape }, Collision);
            request.MaxParticles = int.MaxValue;
            List<FluidParticle> particles = FluidSpawner.Fill(request).Particles;
            flows.Add(particles);
            return particles.Count;
        }

        /// <summary>Ends the liquid's sleep.</summary>
        public void Wake() => pace.Wake();

        /// <summary>Reads all meshes again with the next frame.</summary>
        public void InvalidateColliders() => Collision.Invalidate();

        public void Dispose()
        {
            Solver.Dispose();
            pace?.Dispose();
            zones.Dispose();
            obstacles?.Dispose();
            commands.Dispose();
        }

        bool ApplyChanges(in FluidSpec spec)
        {
            FluidLiveKey now = FluidLiveKey.Of(spec);
            if (now.Equals(live)) return false;
            live = now;
            pace.Update(spec);
            return true;
        }

        bool GatherColliders(in FluidSpec spec)
        {
            if (!Collision.Gather(spec.Query())) return false;
            obstacles.Share();
            foreach (FluidMessage message in Collision.Messages) report(message);
            return true;
        }

        bool Moved(in FluidSpec spec)
        {
            bool same = position.Equals(spec.Position) && rotation.Equals(spec.Rotation);
            (position, rotation) = (spec.Position, spec.Rotation);
            return !same;
        }

        // By a script that has the solver.
        bool WasChanged()
        {
            if (Solver.ParticleChanges != knownParticles)
            {
                knownParticles = Solver.ParticleChanges;
                pace.Restart();
                return true;
            }
            if (Solver.SettingsChanges != knownSettings) pace.Yield();
            return Solver.Changes != knownChanges;
        }

        void Know()
        {
            knownChanges = Solver.Changes;
            knownSettings = Solver.SettingsChanges;
        }

        void Rest(double deltaTime)
        {
            restedTime += deltaTime;
            substeps.Rest(deltaTime);
            Know();
        }

        void FollowBodies(in FluidSpec spec)
        {
            foreach (BodyJump jump in obstacles.Follow()) report(jump.Message);
            if (obstacles.Bodies != null && obstacles.Bodies.Floating.LeftOut > 0) report(FluidReports.TooManyBodies(spec.Owner, FloatingBodies.Most));
        }

        void Execute(int steps)
        {
            commands.Clear();
            Solver.RecordSteps(commands, steps, (float)pace.Clock.TimeStep);
            Solver.RecordNeighbourSetup(commands);
            if (steps > 0) pace.Record(commands);
            Graphics.ExecuteCommandBuffer(commands);
        }
    }
}
