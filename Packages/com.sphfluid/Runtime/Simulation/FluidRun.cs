using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>A started simulation: solver, clock, colliders and the one command buffer of a frame. Owns the GPU memory.</summary>
    internal sealed class FluidRun : IDisposable
    {
        private readonly FluidStart start;
        private readonly Action<FluidMessage> report;
        private readonly FluidObstacles obstacles;
        private readonly CommandBuffer commands;
        private readonly SubstepMonitor substeps = new SubstepMonitor();
        private readonly GuardMonitor guards = new GuardMonitor();
        private readonly ColliderLoads loads = new ColliderLoads();
        private readonly SoftnessWatch softness = new SoftnessWatch();
        private readonly FarthestWatch farthest = new FarthestWatch();
        private readonly FluidPace pace;
        private readonly FluidFlows flows;
        private readonly FluidZones zones;
        private readonly SleepingParts parts;
        private readonly RigidbodyFloats floats;
        private FluidLiveKey live;
        private Vector3 position;
        private Quaternion rotation;
        private int knownChanges, knownParticles, knownSettings, knownDetail;
        private double restedTime, motionTime;

        /// <summary>Starts; takes over <paramref name="collision"/>, which has been gathered.</summary>
        /// <exception cref="ArgumentException">A setting cannot be computed with.</exception>
        /// <exception cref="FluidDeviceException">The device cannot run the method.</exception>
        public FluidRun(in FluidSpec spec, FluidStart start, IReadOnlyList<FluidParticle> particles, CollisionScene collision,
            Action<FluidMessage> report)
        {
            this.start = start;
            this.report = report;
            Key = FluidStartKey.Create(spec);
            live = FluidLiveKey.Create(spec);
            (position, rotation) = (spec.Position, spec.Rotation);
            Solver = new FluidSolver(start.Constants, spec.Profile.Shaders, particles, spec.FixedSlots);
            flows = new FluidFlows(Solver, start, report);
            zones = new FluidZones(Solver, start, report);
            parts = new SleepingParts(Solver);
            commands = new CommandBuffer { name = "SPH Fluid" };
            try
            {
                obstacles = new FluidObstacles(Solver.Settings, collision);
                pace = new FluidPace(spec, start, Solver);
                obstacles.Share();
                if (obstacles.Bodies != null && spec.Playback == null)
                {
                    collision.Owners = floats = new RigidbodyFloats(Solver.Settings.SupportRadius);
                }
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

        /// <summary>How it started: its constants follow from that.</summary>
        public FluidStart Start => start;

        /// <summary>Whether there are triangles in the domain.</summary>
        public bool HasBodies => Collision.Solids.Count > 0;

        /// <summary>Takes the GPU time of the steps; null: nobody asks for it.</summary>
        public StepTimer Timer { get; set; }

        public FluidStartKey Key { get; }
        public float TimeStep => (float)pace.Clock.TimeStep;
        public long CapHits => substeps.CapHits;
        public double RealTimeFactor => substeps.RealTimeFactor;
        public long GpuBytes => Solver.GpuBytes + obstacles.GpuBytes + pace.GpuBytes;
        public bool IsAsleep => pace.IsAsleep;

        /// <summary>Part of the particles that takes no part in the steps, as of some frames ago, 0 to 1.</summary>
        public float AsleepShare => pace.IsAsleep ? 1f : Solver.State.HasSleepers ? pace.StillShare : 0f;

        /// <summary>Time since the start [s], that of rest without steps included.</summary>
        public double SimulatedTime => Solver.SimulatedTime + restedTime;
        public CollisionScene Collision => obstacles.Scene;

        /// <summary>Advances by a frame; a liquid that is played goes to what is to be shown now.</summary>
        /// <param name="spec">The simulation as it is now.</param>
        /// <param name="deltaTime">Frame time [s]; null: one step, whatever the time.</param>
        /// <param name="failure">What went wrong.</param>
        /// <returns>False when it cannot go on.</returns>
        public bool TryAdvance(in FluidSpec spec, float? deltaTime, out FluidMessage failure)
        {
            failure = default;
            try
            {
                if (spec.Playback != null) Show(spec);
                else Advance(spec, deltaTime);
                return true;
            }
            catch (Exception exception) when (exception is ArgumentException || exception is FluidDeviceException)
            {
                failure = FluidReports.Failure(spec.Owner, exception);
                return false;
            }
        }

        // The particles are where they are shown to be: only walls and constants follow the scene.
        private void Show(in FluidSpec spec)
        {
            ApplyChanges(spec);
            GatherColliders(spec);
            Moved(spec);
            FollowBodies(spec);
            if (spec.Playback.TryTake(spec.DomainSize, Solver.Settings.PeriodLength, Solver.StepCount == 0, out FluidPlaybackFrame frame))
            {
                Solver.Show(frame.Particles, frame.Count, frame.Time, frame.IsJump);
            }
            Know();
        }

        /// <summary>
        /// Finds the neighbours of particles that are shown, if nobody who draws or measures has done so: where nobody does, a frame is an
        /// upload and no more.
        /// </summary>
        public void Prepare() => Execute(0);

        private void Advance(in FluidSpec spec, float? frameTime)
        {
            float deltaTime = frameTime ?? 0f;
            bool changed = WasChanged() | ApplyChanges(spec) | Moved(spec);
            if (changed) Solver.WakeAll();
            if (changed | GatherColliders(spec) | frameTime == null | flows.Acts(spec) | zones.Waits(spec) | zones.Update(spec, 0.0))
            {
                pace.Wake();
            }
            if (pace.IsAsleep)
            {
                Rest(deltaTime);
                return;
            }
            floats?.Track(spec.Owner.gameObject.scene);
            FollowBodies(spec);
            motionTime += deltaTime; // frames without a step join into one motion
            double moved = obstacles.Bodies?.LongestMotion ?? 0.0;
            if (motionTime > deltaTime && deltaTime > 0f) moved *= deltaTime / motionTime;
            double motion = Math.Max(moved, deltaTime * flows.FastestSpeed(spec));
            loads.Record(Collision.Solids, spec.DomainSize, deltaTime, moved);
            FollowDetail(spec, deltaTime);
            int steps = frameTime == null ? pace.StepOnce(motion) : pace.Advance(deltaTime, motion, loads);
            flows.Begin(spec, steps * pace.Clock.TimeStep);
            bool pushed = zones.Waits(spec);
            if (pushed) zones.Update(spec, steps * pace.Clock.TimeStep);
            parts.Update(spec, Collision.Solids, zones, flows);
            if (pushed) Solver.WakeKept();
            Execute(steps);
            flows.End(spec, steps);
            if (steps > 0) floats?.Record(obstacles.Bodies.Floating, Solver.SimulatedTime);
            floats?.GiveAhead();
            if (steps > 0) motionTime = 0.0;
            if (steps > 0) pace.Stepped(steps * pace.Clock.TimeStep);
            Know();
            if (softness.Update(spec, start, pace, Solver.Settings, loads, deltaTime) is FluidMessage soft) report(soft);
            if (farthest.Update(spec, Solver.LeftThroughFaces) is FluidMessage far) report(far);
            if (substeps.Update(pace.Clock, steps, deltaTime) is string text)
            {
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.SubstepCap, spec.Owner, text,
                    "Raise Max Substeps Per Frame, " + (spec.TimeStepMode == FluidTimeStepMode.Fixed ? "or Fixed Time Step." :
                    FluidMethods.Has(spec.Method, FluidMethodFeatures.StepsByFrame) ? "or lower the profile's Substeps."
                    : $"or use a larger Particle Spacing; {FluidRules.Advise(Solver.Settings, Solver.Settings.MaxSpeed).Cure}.")));
            }
            if (guards.Update(Solver.Counters, FluidMethods.Get(spec.Method).ShorterSteps, Solver.Squeezers, obstacles.Bodies)
                is string guard)
            {
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.GuardActed, spec.Owner, guard, guards.Cure));
            }
        }

        /// <summary>Whether there are Rigidbodies that the liquid moves.</summary>
        public bool MovesBodies => floats != null && floats.Count > 0;

        /// <summary>Before a step of the scene's physics.</summary>
        public void FixedUpdate(Vector3 domainPosition, Quaternion domainRotation, float deltaTime) =>
            floats?.FixedUpdate(domainPosition, domainRotation, deltaTime);

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

        /// <summary>Adds a box of liquid with the next steps.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="unitToWorld">Maps the unit cube centred on the origin to the box in the world [m].</param>
        /// <param name="velocity">World velocity [m/s].</param>
        /// <returns>Number of particles that are tried.</returns>
        public int AddLiquid(in FluidSpec spec, Matrix4x4 unitToWorld, Vector3 velocity)
        {
            DomainPose toLocal = spec.WorldToLocal;
            return AddLiquid(spec, new LiquidBox("Added liquid", toLocal * unitToWorld, toLocal.MultiplyVector(velocity)));
        }

        /// <summary>
        /// Writes all that the liquid goes on from, waiting for the GPU. It goes on as one does that is restored from it, so that both stay
        /// equal to the bit.
        /// </summary>
        public void Save(in FluidSpec spec, Stream stream)
        {
            AsyncGPUReadback.WaitAllRequests();
            List<(string name, SaveWriter contents)> sections = FluidSave.Collect(spec, start, Solver);
            SaveWriter Section(string name)
            {
                sections.Add((name, new SaveWriter()));
                return sections[sections.Count - 1].contents;
            }

            SaveWriter run = Section(FluidSave.Run);
            run.Write(position);
            run.Write(rotation);
            run.Write(restedTime);
            pace.Save(Section(FluidSave.Pace));
            flows.Save(Section(FluidSave.Flows), spec);
            zones.Save(Section(FluidSave.Zones), spec);
            if (pace.Coarseness != 1.0) Section(FluidSave.Detail).Write(pace.Coarseness);
            obstacles.Bodies?.Save(Section(FluidSave.Colliders));
            floats?.Save(Section(FluidSave.Floats), obstacles.Bodies.Floating);
            SaveFile.Write(stream, sections);
            Continue(spec, FluidSave.From(sections));
        }

        /// <summary>Goes on from a save of a liquid with these settings.</summary>
        /// <exception cref="InvalidDataException">A section is not what it should be.</exception>
        public void Continue(in FluidSpec spec, FluidSave save)
        {
            ApplyChanges(spec);
            GatherColliders(spec);
            Solver.Continue(save.Live, save.Progress);
            if (save.Has(FluidSave.Colliders)) obstacles.Bodies?.Load(save.Section(FluidSave.Colliders), Collision);
            if (save.Has(FluidSave.Floats)) floats?.Load(save.Section(FluidSave.Floats), obstacles.Bodies.Floating);
            loads.Forget();
            parts.Forget();
            pace.Continue(spec, save.Has(FluidSave.Detail) ? save.Section(FluidSave.Detail).Read<double>() : 1.0);
            pace.Load(save.Section(FluidSave.Pace));
            flows.Load(save.Section(FluidSave.Flows), spec);
            zones.Load(save.Section(FluidSave.Zones), spec);
            zones.Update(spec, 0.0);
            SaveReader run = save.Section(FluidSave.Run);
            (position, rotation, restedTime) = (run.Read<Vector3>(), run.Read<Quaternion>(), run.Read<double>());
            FollowBodies(spec);
            if (obstacles.Bodies != null && obstacles.Bodies.IsUnderWay) pace.Wake();
            Execute(0);
            Know();
        }

        /// <summary>Ends the liquid's sleep.</summary>
        public void Wake()
        {
            pace.Wake();
            Solver.WakeAll();
        }

        /// <summary>Reads all meshes again with the next frame.</summary>
        public void InvalidateColliders() => Collision.Invalidate();

        public void Dispose()
        {
            Solver.Dispose();
            pace?.Dispose();
            zones.Dispose();
            floats?.Dispose();
            obstacles?.Dispose();
            commands.Dispose();
        }

        private bool ApplyChanges(in FluidSpec spec)
        {
            FluidLiveKey now = FluidLiveKey.Create(spec);
            if (now.Equals(live)) return false;
            live = now;
            pace.Update(spec);
            return true;
        }

        private void FollowDetail(in FluidSpec spec, double deltaTime)
        {
            pace.Follow(spec, deltaTime);
            if (spec.Detail.Number == knownDetail) return;
            knownDetail = spec.Detail.Number;
            if (knownDetail > 0 && DetailChecks.Find(spec, start, knownDetail) is FluidMessage vain) report(vain);
        }

        private bool GatherColliders(in FluidSpec spec)
        {
            if (!Collision.Gather(spec.Query())) return false;
            obstacles.Share();
            foreach (FluidMessage message in Collision.Messages) report(message);
            return true;
        }

        private bool Moved(in FluidSpec spec)
        {
            bool same = position.Equals(spec.Position) && rotation.Equals(spec.Rotation);
            (position, rotation) = (spec.Position, spec.Rotation);
            return !same;
        }

        // By a script that has the solver.
        private bool WasChanged()
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

        private void Know()
        {
            knownChanges = Solver.Changes;
            knownSettings = Solver.SettingsChanges;
        }

        private void Rest(double deltaTime)
        {
            restedTime += deltaTime;
            substeps.Rest(deltaTime);
            Know();
        }

        private void FollowBodies(in FluidSpec spec)
        {
            foreach (BodyJump jump in obstacles.TrackMotion()) report(jump.Message);
            if (obstacles.Bodies == null) return;
            foreach (FluidMessage message in obstacles.Bodies.Floating.Messages) report(message);
            if (obstacles.Bodies.Floating.LeftOut > 0) report(FluidReports.TooManyBodies(spec.Owner, FloatingBodies.Most));
        }

        private void Execute(int steps)
        {
            commands.Clear();
            Timer?.Begin(commands, steps, Solver.LiveCount);
            Solver.RecordSteps(commands, steps, (float)pace.Clock.TimeStep, SubmitPart);
            Solver.RecordNeighbourSetup(commands);
            if (steps > 0) pace.Record(commands);
            Timer?.End(commands, steps);
            Graphics.ExecuteCommandBuffer(commands);
        }

        private void SubmitPart()
        {
            Timer?.EndPart(commands);
            Graphics.ExecuteCommandBuffer(commands);
            GL.Flush();
            commands.Clear();
            Timer?.BeginPart(commands);
        }
    }
}
