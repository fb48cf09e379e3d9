using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The force zones of a running liquid, frame by frame.</summary>
    internal sealed class FluidZones : IDisposable
    {
        // Over the speed of sound: more in one step makes sound that is louder than the flow.
        private const double MostInAStep = 0.1;

        // Over the speed of sound: the most that a burst or an impulse may give.
        private const double MostBurst = 0.2;

        // Over the speed that the speed of sound is made for: this much faster, liquid is compressed by half as much again.
        private const double MostFast = 1.25;

        private readonly FluidSolver solver;
        private readonly FluidStart start;
        private readonly Action<FluidMessage> report;
        private readonly List<ForceZone> now = new List<ForceZone>();
        private readonly List<ZoneState> bursts = new List<ZoneState>();
        private readonly List<ZonePush> pushes = new List<ZonePush>();
        private readonly List<(Vector3 place, float reach, float speed)> blows = new List<(Vector3, float, float)>();
        private ForceZones zones;
        private double expected, fall, fallWith = double.NaN;
        private bool reportedSum;

        public FluidZones(FluidSolver solver, FluidStart start, Action<FluidMessage> report)
        {
            this.solver = solver;
            this.start = start;
            this.report = report;
        }

        /// <summary>Gives the liquid in a sphere a velocity with the next steps.</summary>
        /// <param name="push">Sphere and velocity.</param>
        /// <param name="liquid">Name of the simulation, for the message.</param>
        /// <param name="argument">Name of the caller's argument that gives the velocity.</param>
        /// <exception cref="ArgumentException">The velocity is more than a fifth of the speed of sound, or many wait.</exception>
        public void Push(in ZonePush push, string liquid, string argument)
        {
            RequireGentle("An impulse", push.Speed, liquid, solver, argument);
            if (pushes.Count == ForceZone.Most)
            {
                throw new ArgumentException(
                    $"{ForceZone.Most} impulses wait for the next steps, as many as act on a liquid at a time. Give the others in the " +
                    "next frame.");
            }
            pushes.Add(push);
        }

        /// <summary>Checks a velocity that a liquid is to get at once.</summary>
        /// <param name="what">What gives it, for the message.</param>
        /// <param name="speed">Its magnitude [m/s].</param>
        /// <param name="liquid">Name of the simulation.</param>
        /// <param name="solver">The liquid.</param>
        /// <param name="argument">Name of the caller's argument.</param>
        /// <exception cref="ArgumentException">It is more than a fifth of the speed of sound.</exception>
        public static void RequireGentle(string what, float speed, string liquid, FluidSolver solver, string argument)
        {
            double most = MostBurst * solver.Settings.SoundSpeed;
            if (!(speed <= most))
            {
                throw new ArgumentException(
                    FormattableString.Invariant($"{what} of {speed:0.##} m/s tears the liquid of '{liquid}' apart; {most:0.##} m/s are ") +
                    "the most. Raise its Expected Speed.", argument);
            }
        }

        /// <summary>What pushes the liquid in the next steps.</summary>
        public IReadOnlyList<ForceZone> Acting => now;

        /// <summary>Whether a burst or an impulse waits for the next steps.</summary>
        public bool Waits(in FluidSpec spec)
        {
            if (pushes.Count > 0) return true;
            for (int i = 0; i < (spec.Zones?.Count ?? 0); i++)
                if (spec.Zones[i].State.Burst != Vector3.zero) return true;
            return false;
        }

        /// <summary>Takes over the zones as they are now.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="time">Time that the frame's steps take [s]; 0 where there are none, and bursts wait.</param>
        /// <returns>Whether one changed.</returns>
        public bool Update(in FluidSpec spec, double time)
        {
            if (zones == null && pushes.Count == 0 && !(spec.Zones?.Count > 0) && !HasPumps(spec)) return false;
            if (!FluidMethods.Has(spec.Method, FluidMethodFeatures.ForceZones)) return false; // a check has said so
            zones ??= new ForceZones();
            now.Clear();
            bursts.Clear();
            DomainPose worldToLocal = spec.WorldToLocal;
            for (int i = 0; i < (spec.Zones?.Count ?? 0); i++)
            {
                ZoneSpec zone = spec.Zones[i];
                if ((Check(zone, spec) ?? Torn(zone, spec)) is FluidMessage wrong) report(wrong);
                else
                {
                    ReportFast(zone, spec);
                    Add(zone.Owner, spec, zone.Zone(worldToLocal, spec.Rotation, solver.SimulatedTime));
                }
            }
            for (int i = 0; i < (spec.Emitters?.Count ?? 0); i++)
            {
                EmitterSpec emitter = spec.Emitters[i];
                if (EmitterPipes.TryDrive(emitter, spec, solver.Settings.SoundSpeed, out ForceZone drive)) Add(emitter.Owner, spec, drive);
            }
            if (time > 0.0) AddBlows(spec, worldToLocal, (float)time);
            bool changed = zones.SetZones(now);
            solver.SetZones(zones);
            return changed;
        }

        /// <summary>Writes the bursts and impulses that wait.</summary>
        public void Save(SaveWriter writer, in FluidSpec spec)
        {
            writer.WriteItems(pushes.ToArray(), pushes.Count);
            var waiting = new List<ZoneSpec>();
            for (int i = 0; i < (spec.Zones?.Count ?? 0); i++)
                if (spec.Zones[i].State.Burst != Vector3.zero) waiting.Add(spec.Zones[i]);
            writer.Write(waiting.Count);
            foreach (ZoneSpec zone in waiting)
            {
                writer.WriteKey(zone.Owner);
                writer.Write(zone.State.Burst);
            }
        }

        /// <summary>Goes on from a save.</summary>
        public void Load(SaveReader reader, in FluidSpec spec)
        {
            pushes.Clear();
            pushes.AddRange(reader.ReadItems<ZonePush>());
            Dictionary<string, ZoneSpec> present = SaveReader.ByKey(spec.Zones, z => z.Owner);
            for (int left = reader.Read<int>(); left > 0; left--)
            {
                bool isThere = reader.TryFind(present, out ZoneSpec zone);
                Vector3 burst = reader.Read<Vector3>();
                if (isThere) zone.State.Burst = burst;
            }
        }

        /// <inheritdoc/>
        public void Dispose() => zones?.Dispose();

        /// <summary>Checks the zones of a simulation before it starts.</summary>
        public static void Check(in FluidSpec spec, List<FluidMessage> messages)
        {
            if (!(spec.Zones?.Count > 0)) return;
            if (FluidMethods.Has(spec.Method) && !FluidMethods.Has(spec.Method, FluidMethodFeatures.ForceZones))
            {
                messages.Add(new FluidMessage(FluidSeverity.Warning, FluidIssue.ForceZoneInvalid, spec.Owner,
                    $"The method {spec.Method} has no force zones: those of the scene do nothing to it.",
                    "Set Method to Standard or Robust."));
            }
            for (int i = 0; i < spec.Zones.Count; i++)
                if (Check(spec.Zones[i], spec) is FluidMessage wrong) messages.Add(wrong);
        }

        // Bursts and impulses act for one frame. Where some may act on the same liquid, their sum is held to what one alone may give.
        private void AddBlows(in FluidSpec spec, in DomainPose worldToLocal, float time)
        {
            blows.Clear();
            for (int i = 0; i < (spec.Zones?.Count ?? 0); i++)
            {
                ZoneSpec zone = spec.Zones[i];
                if (HasBurst(zone)) blows.Add((zone.Position, zone.Reach, zone.State.Burst.magnitude));
            }
            foreach (ZonePush push in pushes) blows.Add((push.Place, push.Reach, push.Speed));
            int blow = 0;
            for (int i = 0; i < (spec.Zones?.Count ?? 0); i++)
            {
                ZoneSpec zone = spec.Zones[i];
                if (!HasBurst(zone)) continue;
                Add(zone.Owner, spec, zone.Burst(worldToLocal, spec.Rotation, Share(spec, blow++) / time * zone.State.Burst));
                bursts.Add(zone.State);
            }
            foreach (ZonePush push in pushes) Add(spec.Owner, spec, push.Weakened(Share(spec, blow++)).Zone(worldToLocal, time));
            foreach (ZoneState state in bursts) state.Burst = Vector3.zero;
            pushes.Clear();
        }

        private static bool HasPumps(in FluidSpec spec)
        {
            for (int i = 0; i < (spec.Emitters?.Count ?? 0); i++)
                if (spec.Emitters[i].UnderWater) return true;
            return false;
        }

        private static bool HasBurst(in ZoneSpec zone) => zone.State.Burst != Vector3.zero && zone.Shape != FluidZoneShape.Collider &&
            zone.Fault == null;

        // What is left of a blow, so that no sum is too large: wherever some act, each has at most its part of the most that any of them
        // takes part in.
        private float Share(in FluidSpec spec, int blow)
        {
            double most = MostBurst * solver.Settings.SoundSpeed, largest = 0.0;
            for (int i = 0; i < blows.Count; i++)
            {
                if (!Overlap(blow, i)) continue;
                double sum = 0.0;
                for (int k = 0; k < blows.Count; k++) sum += Overlap(i, k) ? blows[k].speed : 0f;
                largest = Math.Max(largest, sum);
            }
            if (largest <= most * (1.0 + 1e-6)) return 1f;
            if (!reportedSum)
            {
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.ForceZoneInvalid, spec.Owner,
                    FormattableString.Invariant($"Impulses and bursts that reach the same liquid in one frame add up to {largest:0.##} ") +
                    FormattableString.Invariant($"m/s; more than {most:0.##} m/s tears it apart, so they are weakened to that."),
                    "Give some in the next frame, or raise the simulation's Expected Speed."));
            }
            reportedSum = true;
            return (float)(most / largest);
        }

        private bool Overlap(int a, int b) => a == b || (blows[a].place - blows[b].place).magnitude < blows[a].reach + blows[b].reach;

        private void ReportFast(in ZoneSpec zone, in FluidSpec spec)
        {
            expected = Math.Max(expected, solver.Settings.MaxSpeed); // it follows the liquid in some modes
            double speed = zone.SpeedFrom(Fall(spec), spec.DomainSize, spec.Rotation);
            if (zone.State.FastIn == this || !(speed > MostFast * expected)) return;
            zone.State.FastIn = this;
            report(new FluidMessage(FluidSeverity.Warning, FluidIssue.ForceZoneInvalid, zone.Owner,
                FormattableString.Invariant($"The force zone can bring the liquid of '{spec.Name}' to {speed:0.##} m/s, and its time ") +
                FormattableString.Invariant($"step and speed of sound are made for {expected:0.##} m/s: it is compressed more than it ") +
                "should be.",
                FluidConstants.ExpectedSpeedCure(spec, start, speed) + ", or give the zone less strength or size."));
        }

        // What the liquid comes into a zone with, whatever speed is expected.
        private double Fall(FluidSpec spec)
        {
            if (fallWith == spec.ExpectedSpeed) return fall;
            fallWith = spec.ExpectedSpeed;
            spec.ExpectedSpeed = 0f;
            return fall = FluidConstants.Derive(spec, start, start.Gravity).MaxSpeed;
        }

        private void Add(Component owner, in FluidSpec spec, in ForceZone made)
        {
            if (now.Count < ForceZone.Most) now.Add(made);
            else
                report(new FluidMessage(FluidSeverity.Warning, FluidIssue.ForceZoneInvalid, owner,
                    $"'{spec.Name}' has {ForceZone.Most} force zones and bursts, as many as act on a liquid at a time; this one does " +
                    "nothing.", "Disable some."));
        }

        private static FluidMessage? Check(in ZoneSpec zone, in FluidSpec spec)
        {
            if (zone.Shape == FluidZoneShape.Collider)
            {
                return Wrong(zone, FluidSeverity.Error,
                    "The force zone's shape is its object's collider, and the object has no Box, Sphere or Capsule Collider: the zone " +
                    "does nothing.",
                    "Add one of these, as a trigger, or choose another Shape. Put several zones together for the shape of a mesh.");
            }
            if (zone.Fault is string fault)
            {
                return Wrong(zone, FluidSeverity.Error,
                    $"The force zone's {fault} is no number that can be computed with, so the zone does nothing.",
                    "Give its fields finite numbers: sizes greater than zero, rates and times of zero or more.");
            }
            return null;
        }

        // As the speed of sound grows steps by rule shorten in proportion; and the zone brings the liquid to a speed of its own.
        private FluidMessage? Torn(in ZoneSpec zone, in FluidSpec spec)
        {
            FluidSolverSettings settings = solver.Settings;
            double largest = MostInAStep * settings.SoundSpeed / settings.TimeStep, more = Math.Abs(zone.Strength) / largest;
            if (zone.IsDrag || !(more > 1.0)) return null;
            double needed =
                1.02 * Math.Max(settings.MaxSpeed * Math.Sqrt(more), zone.SpeedFrom(Fall(spec), spec.DomainSize, spec.Rotation));
            return Wrong(zone, FluidSeverity.Error,
                    FormattableString.Invariant($"The force zone's strength is {zone.Strength} m/s²; more than {largest:0.#} m/s² tears ") +
                    FormattableString.Invariant($"the liquid of '{spec.Name}' apart within a step."),
                    FluidConstants.ExpectedSpeedCure(spec, start, needed) + ", or use less strength.");
        }

        private static FluidMessage Wrong(in ZoneSpec zone, FluidSeverity severity, string text, string cure) =>
            new FluidMessage(severity, FluidIssue.ForceZoneInvalid, zone.Owner, text, cure);
    }
}
