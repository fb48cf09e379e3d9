using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>First particles of a simulation and how far and fast its liquid can fall.</summary>
    internal sealed class FluidStart
    {
        public FluidStart(List<FluidParticle> particles, long count, LiquidExtent extent, float initialSpeed)
        {
            InitialSpeed = initialSpeed;
            Particles = particles;
            Count = count;
            Extent = extent;
        }

        /// <summary>The particles; empty when only a check was asked for.</summary>
        public List<FluidParticle> Particles { get; }

        /// <summary>Their number.</summary>
        public long Count { get; }

        public LiquidExtent Extent { get; }

        /// <summary>Largest speed of a particle at the start [m/s].</summary>
        public float InitialSpeed { get; }

        /// <summary>The solver's constants with the present settings.</summary>
        public FluidSolverSettings Constants { get; set; }
    }

    /// <summary>Rules about the liquid volumes.</summary>
    internal static class LiquidRules
    {
        /// <summary>Share of a volume outside the domain below which nothing is said.</summary>
        const double OutsideTolerance = 0.001;

        /// <summary>Checks the volumes and counts, or with <paramref name="fill"/> makes, their particles.</summary>
        public static FluidStart Check(FluidSimulation simulation, CollisionScene collision, bool fill, List<FluidMessage> messages)
        {
            List<FluidVolume> volumes = FluidScene.FindVolumes(simulation);
            var shapes = new List<LiquidShape>();
            var sources = new List<FluidVolume>();
            foreach (FluidVolume volume in volumes)
            {
                LiquidShape shape = VolumeRules.Check(volume, simulation, collision, messages);
                if (shape == null) continue;
                shapes.Add(shape);
                sources.Add(volume);
            }
            if (volumes.Count == 0)
                messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.NoLiquid, simulation, "The domain holds no liquid.",
                    "Add a Fluid Volume, for instance as a child: GameObject > Fluid > Fluid Volume."));
            if (shapes.Count == 0) return null;

            SpawnRequest request = FluidScene.Request(simulation, shapes, collision);
            SpawnResult spawn = fill ? FluidSpawner.Fill(request) : FluidSpawner.Measure(request);
            if (!CheckCount(simulation, spawn, messages)) return null; // far more than that are not gone through
            for (int i = 0; i < shapes.Count; i++)
                if (!(shapes[i] is LiquidVessel vessel) || VolumeRules.CheckVessel(sources[i], vessel, simulation, messages))
                    CheckTally(simulation, sources[i], spawn.Tallies[i], collision, messages);
            if (!AffineMath.IsFinite(spawn.Fastest))
                messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.StartFailed, simulation,
                    "The velocity field gives a velocity that is not a finite number.", "Give VelocityField a function with finite numbers everywhere in the liquid."));
            return new FluidStart(spawn.Particles, spawn.Needed, LiquidExtent.Of(shapes, simulation.DomainSize), spawn.Fastest);
        }

        /// <summary>Most particles that a simulation may have.</summary>
        /// <param name="simulation">The simulation.</param>
        /// <param name="owner">Whose limit it is, for messages.</param>
        internal static long MostParticles(FluidSimulation simulation, out string owner)
        {
            int profile = simulation.Profile != null ? simulation.Profile.MaxParticles : int.MaxValue;
            long device = DeviceLimit;
            owner = device < profile || simulation.Profile == null ? $"this device's buffers hold {device} particles"
                : $"the profile '{simulation.Profile.name}' allows {profile} particles, and this device's buffers hold {device}";
            return Math.Min(profile, device);
        }

        static long DeviceLimit => SystemInfo.maxGraphicsBufferSize / FluidParticle.Stride;

        static bool CheckCount(FluidSimulation simulation, SpawnResult spawn, List<FluidMessage> messages)
        {
            long limit = MostParticles(simulation, out string owner);
            if (spawn.Needed <= limit) return true;
            double spacing = simulation.Spacing * Math.Pow(spawn.Needed / (double)limit, 1.0 / 3.0) * 1.01;
            messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.TooManyParticles, simulation,
                FormattableString.Invariant($"The liquid needs {spawn.Needed} particles at a spacing of {simulation.Spacing} m, but {owner}."),
                FormattableString.Invariant($"Use a Particle Spacing of {spacing:G3} m or more, less liquid") +
                (limit == DeviceLimit ? "." : ", or raise Max Particles in the profile.")));
            return false;
        }

        static void CheckTally(FluidSimulation simulation, FluidVolume volume, in SpawnTally tally, CollisionScene collision, List<FluidMessage> messages)
        {
            if (tally.OutsideShare >= 1.0)
            {
                Add(messages, FluidSeverity.Error, FluidIssue.VolumeOutsideDomain, volume,
                    $"The liquid volume lies outside the domain of '{simulation.name}'.",
                    "Move it into the domain box, or enlarge the simulation's Domain Size.");
                return;
            }
            if (tally.OutsideShare > OutsideTolerance)
                Add(messages, FluidSeverity.Warning, FluidIssue.VolumeOutsideDomain, volume,
                    FormattableString.Invariant($"{100.0 * tally.OutsideShare:0.#} % of the liquid volume lies outside the domain of '{simulation.name}' and is left out."),
                    "Move or shrink the volume, or enlarge the simulation's Domain Size.");
            if (tally.Carved > 0) ReportCarved(volume, tally, collision, messages);
            if (tally.Shared > 0)
                Add(messages, FluidSeverity.Info, FluidIssue.VolumesOverlap, volume,
                    $"{tally.Shared} particles' worth of the liquid volume overlaps an earlier one and is filled once.", "");
            if (tally.Filled + tally.Carved + tally.Shared == 0)
                Add(messages, FluidSeverity.Error, FluidIssue.VolumeSizeInvalid, volume,
                    FormattableString.Invariant($"The liquid volume is too small to hold a particle at a spacing of {simulation.Spacing} m."),
                    "Enlarge the volume or use a smaller Particle Spacing.");
        }

        static void ReportCarved(FluidVolume volume, in SpawnTally tally, CollisionScene collision, List<FluidMessage> messages)
        {
            string collider = collision.Solids[tally.LastObstacle].Name;
            if (tally.Filled == 0)
                Add(messages, FluidSeverity.Error, FluidIssue.VolumeInsideCollider, volume,
                    $"The liquid volume lies wholly inside colliders, the last one '{collider}', so no particle is left.",
                    "Move the volume out of the collider, or take the collider's layer out of the simulation's Collider Layers.");
            else
                Add(messages, FluidSeverity.Warning, FluidIssue.VolumeInsideCollider, volume,
                    $"{tally.Carved} of {tally.Carved + tally.Filled} particles would start inside colliders or against their faces, the last one '{collider}', and are left out.",
                    "Move the volume or the collider apart if more liquid was meant.");
        }

        static void Add(List<FluidMessage> messages, FluidSeverity severity, FluidIssue issue, FluidVolume volume, string text, string cure) =>
            messages.Add(new FluidMessage(severity, issue, volume, text, cure));
    }
}
