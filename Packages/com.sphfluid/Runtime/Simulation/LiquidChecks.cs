using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Rules about the liquid volumes.</summary>
    internal static class LiquidChecks
    {
        /// <summary>Share of a volume outside the domain below which nothing is said.</summary>
        private const double OutsideTolerance = 0.001;

        // As rocks in a river take. Beyond it the liquid was meant to be elsewhere.
        private const double MostCarved = 0.25;

        /// <summary>The shapes of the volumes that can be filled, among the colliders gathered in <paramref name="collision"/>.</summary>
        public static List<(VolumeSpec volume, LiquidShape shape)> Shapes(
            in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes, CollisionScene collision, List<FluidMessage> messages)
        {
            var shapes = new List<(VolumeSpec, LiquidShape)>();
            foreach (VolumeSpec volume in volumes)
                if (VolumeChecks.Check(volume, spec, collision, messages) is LiquidShape shape) shapes.Add((volume, shape));
            if (volumes.Count == 0 && IsDry(spec))
            {
                messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.NoLiquid, spec.Owner, "The domain holds no liquid.",
                    "Add a Fluid Volume or a Fluid Emitter, for instance as a child: GameObject > Fluid > Volume."));
            }
            return shapes;
        }

        /// <summary>Whether nothing can pour into a simulation.</summary>
        public static bool IsDry(in FluidSpec spec) =>
            !(spec.Emitters?.Count > 0) || !FluidMethods.Has(spec.Method, FluidMethodFeatures.ChangingCount);

        /// <summary>Checks what became of the shapes when they were filled or counted.</summary>
        public static void Check(in FluidSpec spec, IReadOnlyList<(VolumeSpec volume, LiquidShape shape)> shapes, SpawnResult spawn,
            CollisionScene collision, List<FluidMessage> messages)
        {
            for (int i = 0; i < shapes.Count; i++)
                if (!(shapes[i].shape is LiquidVessel vessel) || VolumeChecks.CheckVessel(shapes[i].volume, vessel, spec, messages))
                {
                    CheckTally(spec, shapes[i].volume, spawn.Tallies[i], collision, messages);
                }
            if (!AffineMath.IsFinite(spawn.Fastest))
            {
                messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.StartFailed, spec.Owner,
                    "The velocity field gives a velocity that is not a finite number.",
                    "Give VelocityField a function with finite numbers everywhere in the liquid."));
            }
        }

        /// <summary>Most particles that a simulation may have.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="owner">Whose limit it is, for messages.</param>
        internal static long MostParticles(in FluidSpec spec, out string owner)
        {
            int profile = spec.HasProfile ? spec.Profile.MaxParticles : int.MaxValue;
            long device = DeviceLimit;
            owner = device < profile || !spec.HasProfile ? $"this device's buffers hold {device} particles"
                : $"the profile '{spec.Profile.Name}' allows {profile} particles, and this device's buffers hold {device}";
            return MostParticles(spec);
        }

        /// <summary>Most particles that a simulation may have.</summary>
        internal static long MostParticles(in FluidSpec spec) =>
            Math.Min(spec.HasProfile ? spec.Profile.MaxParticles : int.MaxValue, DeviceLimit);

        private static long DeviceLimit => SystemInfo.maxGraphicsBufferSize / FluidParticle.Stride;

        /// <summary>Checks that a simulation may have the particles that were filled or counted.</summary>
        /// <returns>False when they are too many to go on with.</returns>
        public static bool CheckCount(in FluidSpec spec, SpawnResult spawn, List<FluidMessage> messages)
        {
            long limit = MostParticles(spec, out string owner);
            if (spawn.Needed <= limit) return true;
            double spacing = spec.Spacing * Math.Pow(spawn.Needed / (double)limit, 1.0 / 3.0) * 1.01;
            messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.TooManyParticles, spec.Owner,
                FormattableString.Invariant($"The liquid needs {spawn.Needed} particles at a spacing of {spec.Spacing} m, but {owner}."),
                FormattableString.Invariant($"Use a Particle Spacing of {spacing:G3} m or more, less liquid") +
                (limit == DeviceLimit ? "." : ", or raise Max Particles in the profile.")));
            return false;
        }

        private static void CheckTally(in FluidSpec spec, in VolumeSpec volume, in SpawnTally tally, CollisionScene collision,
            List<FluidMessage> messages)
        {
            if (tally.OutsideShare >= 1.0)
            {
                Add(messages, FluidSeverity.Error, FluidIssue.VolumeOutsideDomain, volume,
                    $"The liquid volume lies outside the domain of '{spec.Name}'.",
                    "Move it into the domain box, or enlarge the simulation's Domain Size.");
                return;
            }
            if (tally.OutsideShare > OutsideTolerance)
            {
                Add(messages, FluidSeverity.Warning, FluidIssue.VolumeOutsideDomain, volume,
                    FormattableString.Invariant($"{100.0 * tally.OutsideShare:0.#} % of the liquid volume lies outside the domain of ") +
                    FormattableString.Invariant($"'{spec.Name}' and is left out."),
                    "Move or shrink the volume, or enlarge the simulation's Domain Size.");
            }
            if (tally.Carved > 0) ReportCarved(volume, tally, collision, messages);
            if (tally.Shared > 0)
            {
                Add(messages, FluidSeverity.Info, FluidIssue.VolumesOverlap, volume,
                    $"{tally.Shared} particles' worth of the liquid volume overlaps an earlier one and is filled once.", "");
            }
            if (tally.Filled + tally.Carved + tally.Shared == 0)
            {
                Add(messages, FluidSeverity.Error, FluidIssue.VolumeSizeInvalid, volume,
                    FormattableString.Invariant($"The liquid volume is too small to hold a particle at a spacing of {spec.Spacing} m."),
                    "Enlarge the volume or use a smaller Particle Spacing.");
            }
        }

        private static void ReportCarved(in VolumeSpec volume, in SpawnTally tally, CollisionScene collision, List<FluidMessage> messages)
        {
            string collider = collision.NameOf(tally.LastObstacle);
            if (tally.Filled == 0)
                Add(messages, FluidSeverity.Error, FluidIssue.VolumeInsideCollider, volume,
                    $"The liquid volume lies wholly inside colliders, the last one {collider}, so no particle is left.",
                    "Move the volume out of the collider, or take the collider's layer out of the simulation's Collider Layers.");
            else
                Add(messages, tally.Carved > MostCarved * (tally.Carved + tally.Filled) ? FluidSeverity.Warning : FluidSeverity.Info,
                    FluidIssue.VolumeInsideCollider, volume,
                    $"{tally.Carved} of {tally.Carved + tally.Filled} particles would start inside colliders or against their faces, the " +
                    $"last one {collider}, and are left out.",
                    "If more liquid was meant, move the volume and the collider apart, or fill the hollow between colliders with the " +
                    "shape Vessel.");
        }

        private static void Add(List<FluidMessage> messages, FluidSeverity severity, FluidIssue issue, in VolumeSpec volume, string text,
            string cure) =>
                messages.Add(new FluidMessage(severity, issue, volume.Owner, text, cure));
    }
}
