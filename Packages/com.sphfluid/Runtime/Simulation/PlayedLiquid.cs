using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A liquid that is shown and not stepped: as what it runs, and where it begins.</summary>
    internal static class PlayedLiquid
    {
        /// <summary>The simulation as it runs: with slots for all particles that will be shown, and nothing that moves them.</summary>
        /// <param name="spec">The simulation as its settings have it.</param>
        /// <param name="playback">What is shown.</param>
        public static FluidSpec Of(FluidSpec spec, IFluidPlayback playback)
        {
            spec.Playback = playback;
            spec.Method = FluidMethodKind.Standard; // its number of particles may change, and walls add to its density
            spec.Automatic = default;
            spec.TimeStepMode = FluidTimeStepMode.Automatic;
            spec.StartRelaxation = FluidStartRelaxation.None;
            spec.SleepsAtRest = false;
            spec.VelocityField = null;
            spec.CapacityPolicy = FluidCapacityPolicy.Fixed;
            spec.Capacity = (int)Math.Min(int.MaxValue, Math.Max(1L, playback.MostParticles));
            spec.IdleParts = (spec.Emitters?.Count ?? 0) + (spec.Drains?.Count ?? 0) + (spec.Zones?.Count ?? 0);
            spec.Emitters = null;
            spec.Drains = null;
            spec.Zones = null;
            return spec;
        }

        /// <summary>Where it begins: anywhere in the domain, so that its constants are those of liquid that fills it.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="messages">Receives what is wrong.</param>
        /// <returns>Null when it cannot begin.</returns>
        public static FluidStart Begin(in FluidSpec spec, List<FluidMessage> messages)
        {
            spec.Playback.Check(spec.DomainSize, spec.Spacing, messages);
            long count = spec.Playback.MostParticles, most = LiquidChecks.MostParticles(spec, out string owner);
            if (count > most)
            {
                messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.TooManyParticles, spec.Owner,
                    FormattableString.Invariant($"A frame of the playback has {count} particles, but {owner}."),
                    "Raise Max Particles in the profile, or play a coarser liquid."));
            }
            if (spec.IdleParts > 0)
            {
                messages.Add(new FluidMessage(FluidSeverity.Info, FluidIssue.PlaybackDiffers, spec.Owner,
                    $"The liquid is played back, so {spec.IdleParts} emitters, drains and force zones do nothing.", ""));
            }
            if (messages.Exists(m => m.Severity == FluidSeverity.Error)) return null;
            var whole = new LiquidBox("Playback", Matrix4x4.Scale(spec.DomainSize), Vector3.zero);
            return new FluidStart(new List<FluidParticle>(), count, LiquidExtent.Create(new LiquidShape[] { whole }, spec.DomainSize),
                0f)
            { Gravity = spec.LocalGravity };
        }
    }
}
