using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What emitters, drains and scripts bring into a running liquid and take out of it, frame by frame.</summary>
    internal sealed class FluidFlows
    {
        // Of what an emitter gives, besides a layer and a bit: where a pump begins, liquid stands in the place of the first.
        private const double BlockedShare = 0.02;
        private const double BlockedLayers = 1.5;

        private readonly FluidSolver solver;
        private readonly FluidStart start;
        private readonly Action<FluidMessage> report;
        private readonly Dictionary<EmitterState, EmitterRun> emitters = new Dictionary<EmitterState, EmitterRun>();
        private readonly Dictionary<DrainState, int> drainSources = new Dictionary<DrainState, int>();
        private readonly List<EmitterState> gone = new List<EmitterState>();
        private readonly List<DrainState> goneDrains = new List<DrainState>();
        private readonly List<(DrainZone zone, int source)> zones = new List<(DrainZone, int)>();
        private readonly List<DrainZone> once = new List<DrainZone>();
        private readonly int firstCapacity;
        private bool reportedGrowth, reportedRecycling, reportedFull;

        public FluidFlows(FluidSolver solver, FluidStart start, Action<FluidMessage> report)
        {
            this.solver = solver;
            this.start = start;
            this.report = report;
            firstCapacity = solver.Capacity;
        }

        /// <summary>Whether something comes or goes, so that the liquid cannot sleep.</summary>
        public bool Acts(in FluidSpec spec)
        {
            if (spec.Drains?.Count > 0 || once.Count > 0 || IsUsed &&
                (solver.Exchange.Births.Waiting > 0 || solver.Exchange.Lifetimes.Waiting > 0))
            {
                return true;
            }
            for (int i = 0; i < (spec.Emitters?.Count ?? 0); i++)
                if (spec.Emitters[i].State.IsOn) return true;
            return false;
        }

        /// <summary>Adds boxes around what drains liquid in the next steps, in simulation space [m].</summary>
        public void AddDrained(in FluidSpec spec, List<Bounds> boxes)
        {
            foreach (DrainZone zone in once) boxes.Add(zone.Bounds);
            for (int i = 0; i < (spec.Drains?.Count ?? 0); i++) boxes.Add(spec.Drains[i].Zone(spec.WorldToLocal).Bounds);
        }

        /// <summary>Speed of the fastest emitter that is on [m/s]: known before its liquid is there.</summary>
        public double FastestSpeed(in FluidSpec spec)
        {
            double fastest = 0.0;
            for (int i = 0; i < (spec.Emitters?.Count ?? 0); i++)
            {
                double speed = spec.Emitters[i].State.IsOn ? spec.Emitters[i].Speed(spec.Spacing) : 0.0;
                if (speed > fastest && !double.IsInfinity(speed)) fastest = speed;
            }
            return fastest;
        }

        /// <summary>Removes the liquid in a zone with the next steps.</summary>
        public void Remove(in DrainZone zone)
        {
            Use();
            once.Add(zone);
        }

        /// <summary>Adds particles with the next steps, where there is a place for them.</summary>
        /// <param name="particles">Positions and velocities in simulation space.</param>
        public void Add(IReadOnlyList<FluidParticle> particles)
        {
            Use();
            for (int i = 0; i < particles.Count; i++)
            {
                solver.Exchange.Births.Add(particles[i].Position, particles[i].VelT0, solver.SimulatedTime, SourceCounts.Added);
            }
        }

        /// <summary>To be called before the steps of a frame are recorded.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="time">Time that the steps take [s].</param>
        public void Begin(in FluidSpec spec, double time)
        {
            if (!IsUsed && !(spec.Emitters?.Count > 0) && !(spec.Drains?.Count > 0)) return;
            if (!solver.Exchanges) return; // a check has said so
            Use();
            ParticleExchange exchange = solver.Exchange;
            exchange.MostParticles = spec.MostParticles;
            exchange.Recycles = spec.CapacityPolicy == FluidCapacityPolicy.RecycleOldest;
            Emit(spec, time);
            Drain(spec);
        }

        /// <summary>To be called after they are recorded.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="steps">Number of steps.</param>
        public void End(in FluidSpec spec, int steps)
        {
            if (!IsUsed) return;
            if (steps > 0) once.Clear();
            Count(spec);
            Report(spec);
        }

        /// <summary>Writes what comes and goes, once no read-back is under way.</summary>
        public void Save(SaveWriter writer, in FluidSpec spec)
        {
            writer.Write(IsUsed);
            if (!IsUsed) return;
            solver.Exchange.Save(writer);
            writer.WriteItems(once.ToArray(), once.Count);
            writer.Write(emitters.Count);
            foreach (KeyValuePair<EmitterState, EmitterRun> pair in emitters)
            {
                writer.WriteKey(OwnerOf(spec, pair.Key));
                pair.Value.Save(writer);
                pair.Key.Save(writer);
            }
            writer.Write(drainSources.Count);
            foreach (KeyValuePair<DrainState, int> pair in drainSources)
            {
                writer.WriteKey(OwnerOf(spec, pair.Key));
                writer.Write(pair.Value);
                writer.Write(pair.Key.Before);
            }
        }

        /// <summary>Goes on from a save.</summary>
        public void Load(SaveReader reader, in FluidSpec spec)
        {
            if (!reader.Read<bool>()) return;
            Use();
            solver.Exchange.Load(reader);
            once.Clear();
            once.AddRange(reader.ReadItems<DrainZone>());
            emitters.Clear();
            Dictionary<string, EmitterSpec> sources = SaveReader.ByKey(spec.Emitters, e => e.Owner);
            for (int left = reader.Read<int>(); left > 0; left--)
            {
                bool isThere = reader.TryFind(sources, out EmitterSpec emitter);
                EmitterRun run = EmitterRun.Load(reader);
                EmitterState state = isThere ? emitter.State : new EmitterState();
                state.Load(reader);
                state.Run = this;
                emitters[state] = run; // of one that is gone the next frame closes the source
            }
            drainSources.Clear();
            Dictionary<string, DrainSpec> sinks = SaveReader.ByKey(spec.Drains, d => d.Owner);
            for (int left = reader.Read<int>(); left > 0; left--)
            {
                DrainState state = reader.TryFind(sinks, out DrainSpec drain) ? drain.State : new DrainState();
                drainSources[state] = reader.Read<int>();
                (state.Run, state.Before) = (this, reader.Read<double>());
            }
            Count(spec);
        }

        private bool IsUsed { get; set; }

        private void Use() => IsUsed = true;

        private void Emit(in FluidSpec spec, double time)
        {
            foreach (EmitterRun run in emitters.Values) run.IsUsed = false;
            double begin = solver.SimulatedTime;
            for (int i = 0; i < (spec.Emitters?.Count ?? 0); i++)
            {
                EmitterSpec emitter = spec.Emitters[i];
                if (!emitters.TryGetValue(emitter.State, out EmitterRun run))
                {
                    if (!solver.Exchange.Counts.TryOpen(out int source))
                    {
                        ReportTooMany(spec, emitter.Owner);
                        continue;
                    }
                    emitters.Add(emitter.State, run = new EmitterRun(source));
                    Adopt(emitter.State);
                }
                run.IsUsed = true;
                // it falls where nothing comes in
                double soundSpeed = emitter.State.IsOn ? solver.Settings.SoundSpeed : double.PositiveInfinity;
                if (EmitterChecks.CheckLiquid(emitter, spec) is FluidMessage other) report(other);
                if (EmitterChecks.Check(emitter, spec) is FluidMessage wrong) report(wrong);
                else if (EmitterChecks.IsTooFast(emitter, spec, soundSpeed)) report(TooFast(emitter, spec, soundSpeed));
                else run.Emit(emitter, spec, begin, begin + time, solver.Exchange.Births, solver.Exchange.Lifetimes);
            }
            gone.Clear();
            foreach (KeyValuePair<EmitterState, EmitterRun> pair in emitters)
                if (!pair.Value.IsUsed) gone.Add(pair.Key);
            foreach (EmitterState state in gone)
            {
                solver.Exchange.Counts.Close(emitters[state].Source);
                emitters.Remove(state);
            }
        }

        private FluidMessage TooFast(in EmitterSpec emitter, in FluidSpec spec, double soundSpeed)
        {
            double speed = emitter.Speed(spec.Spacing);
            return EmitterChecks.Wrong(emitter,
                FormattableString.Invariant($"The emitter gives liquid of {speed:0.###} m/s, more than a quarter of the speed of sound ") +
                FormattableString.Invariant($"of '{spec.Name}', {soundSpeed:0.#} m/s."),
                FluidConstants.ExpectedSpeedCure(spec, start, speed) + ", or use a larger Size or less flow.");
        }

        // One that was disabled goes on counting.
        private void Adopt(EmitterState state)
        {
            if (state.Run != this) (state.Run, state.Emitted, state.Blocked, state.Refused) = (this, 0.0, 0.0, 0.0);
            (state.EmittedBefore, state.BlockedBefore, state.RefusedBefore) = (state.Emitted, state.Blocked, state.Refused);
        }

        private void Drain(in FluidSpec spec)
        {
            zones.Clear();
            DomainPose worldToLocal = spec.WorldToLocal;
            for (int i = 0; i < (spec.Drains?.Count ?? 0); i++)
            {
                DrainSpec drain = spec.Drains[i];
                if (!drainSources.TryGetValue(drain.State, out int source))
                {
                    if (!solver.Exchange.Counts.TryOpen(out source))
                    {
                        ReportTooMany(spec, drain.Owner);
                        continue;
                    }
                    drainSources.Add(drain.State, source);
                    if (drain.State.Run != this) (drain.State.Run, drain.State.Drained) = (this, 0.0);
                    drain.State.Before = drain.State.Drained;
                }
                if (EmitterChecks.Check(drain) is FluidMessage wrong) report(wrong);
                if (zones.Count < ParticleExchange.MostDrains) zones.Add((drain.Zone(worldToLocal), source));
                else ReportTooMany(spec, drain.Owner);
            }
            goneDrains.Clear();
            foreach (DrainState state in drainSources.Keys)
                if (OwnerOf(spec, state) is null) goneDrains.Add(state);
            foreach (DrainState state in goneDrains)
            {
                solver.Exchange.Counts.Close(drainSources[state]);
                drainSources.Remove(state);
            }
            for (int i = 0; i < once.Count; i++)
            {
                if (zones.Count < ParticleExchange.MostDrains) zones.Add((once[i], SourceCounts.Removed));
                else ReportTooMany(spec, spec.Owner);
            }
            solver.Exchange.SetDrains(zones);
        }

        private void Count(in FluidSpec spec)
        {
            double volume = Math.Pow(spec.Spacing, 3);
            SourceCounts counts = solver.Exchange.Counts;
            foreach (KeyValuePair<EmitterState, EmitterRun> pair in emitters)
            {
                EmitterState state = pair.Key;
                int source = pair.Value.Source;
                state.Emitted = state.EmittedBefore + volume * counts.Passed(source);
                state.Blocked = state.BlockedBefore + volume * counts.Blocked(source);
                state.Refused = state.RefusedBefore + volume * counts.Refused(source);
            }
            foreach (KeyValuePair<DrainState, int> pair in drainSources)
            {
                pair.Key.Drained = pair.Key.Before + volume * counts.Passed(pair.Value);
            }
        }

        private void Report(in FluidSpec spec)
        {
            if (!reportedGrowth && solver.Capacity > firstCapacity)
            {
                reportedGrowth = true;
                report(new FluidMessage(FluidSeverity.Info, FluidIssue.CapacityGrown, spec.Owner, FormattableString.Invariant(
                    $"There are slots for {solver.Capacity} particles now, as more liquid came in. Whenever they are full they double, ") +
                    FormattableString.Invariant($"up to {spec.MostParticles}."), ""));
            }
            if (!reportedRecycling && solver.Exchange.Counts.Passed(SourceCounts.Recycled) > 0)
            {
                reportedRecycling = true;
                report(new FluidMessage(FluidSeverity.Info, FluidIssue.CapacityReached, spec.Owner,
                    FormattableString.Invariant($"The liquid has {spec.MostParticles} particles, and the oldest leave for those that ") +
                    "come in.", ""));
            }
            if (!reportedFull && solver.Counters.Refused > 0)
            {
                reportedFull = true;
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.CapacityReached, spec.Owner,
                    FormattableString.Invariant($"The liquid has {spec.MostParticles} particles, as many as it may have: nothing more ") +
                    "comes in.",
                    "Raise Capacity, or Max Particles in the profile, add a Fluid Drain, or set Capacity Policy to Recycle Oldest."));
            }
            for (int i = 0; i < (spec.Emitters?.Count ?? 0); i++)
            {
                EmitterSpec emitter = spec.Emitters[i];
                if (!emitters.TryGetValue(emitter.State, out EmitterRun run) || run.ReportedBlocked) continue;
                double given = emitter.State.Emitted + emitter.State.Blocked;
                if (!(emitter.State.Blocked > BlockedShare * given + BlockedLayers * run.Sites * Math.Pow(spec.Spacing, 3))) continue;
                run.ReportedBlocked = true;
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.EmitterBlocked, emitter.Owner,
                    FormattableString.Invariant($"Of what the emitter gives {100.0 * emitter.State.Blocked / given:0} % finds no place: ") +
                    "liquid stands before the nozzle, or the nozzle reaches out of the domain.",
                    emitter.UnderWater ? "Move the nozzle into the domain, away from colliders, or lower its speed."
                        : "Raise the nozzle out of the liquid, switch Under Water on, or move it into the domain."));
            }
        }

        private static Component OwnerOf(in FluidSpec spec, EmitterState state)
        {
            for (int i = 0; i < (spec.Emitters?.Count ?? 0); i++)
                if (spec.Emitters[i].State == state) return spec.Emitters[i].Owner;
            return null;
        }

        private static Component OwnerOf(in FluidSpec spec, DrainState state)
        {
            for (int i = 0; i < (spec.Drains?.Count ?? 0); i++)
                if (spec.Drains[i].State == state) return spec.Drains[i].Owner;
            return null;
        }

        private void ReportTooMany(in FluidSpec spec, Component owner) =>
            report(new FluidMessage(FluidSeverity.Warning, FluidIssue.EmitterInvalid, owner,
            $"'{spec.Name}' has {SourceCounts.Most} emitters and drains, or {ParticleExchange.MostDrains} drains, as many as a liquid " +
            "may have; this one does nothing.",
            "Disable some, or make one of several."));
    }
}
