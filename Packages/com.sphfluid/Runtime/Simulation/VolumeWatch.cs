using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The liquid volumes of a running liquid: those that come bring their liquid, and of those that change it can say so.
    /// </summary>
    internal sealed class VolumeWatch
    {
        // Of the spacing: where a volume begins and ends for its liquid.
        private const float Tolerance = 0.01f;

        // to simulation space in place of the world's
        private readonly Dictionary<Component, VolumeSpec> filled = new Dictionary<Component, VolumeSpec>();
        private readonly HashSet<Component> present = new HashSet<Component>();
        private readonly HashSet<Component> before = new HashSet<Component>();

        /// <summary>Takes over what a liquid started with.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="volumes">Its enabled volumes.</param>
        public void Begin(in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes)
        {
            filled.Clear();
            present.Clear();
            for (int i = 0; i < volumes.Count; i++) Remember(spec, volumes[i]);
        }

        /// <summary>A volume's liquid was filled, or is about to be.</summary>
        public void Remember(in FluidSpec spec, VolumeSpec volume)
        {
            present.Add(volume.Owner);
            volume.LocalToWorld = spec.WorldToLocal * volume.LocalToWorld;
            filled[volume.Owner] = volume;
        }

        /// <summary>Fills the volumes that were enabled since the last look.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="run">Its liquid.</param>
        /// <param name="volumes">Its enabled volumes now.</param>
        /// <param name="report">Receives why one is not filled, or not wholly.</param>
        public void Update(in FluidSpec spec, FluidRun run, IReadOnlyList<VolumeSpec> volumes, Action<FluidMessage> report)
        {
            before.Clear();
            before.UnionWith(present);
            present.Clear();
            for (int i = 0; i < volumes.Count; i++)
            {
                present.Add(volumes[i].Owner);
                if (before.Contains(volumes[i].Owner)) continue;
                Remember(spec, volumes[i]);
                if (run.Solver.Exchanges) Fill(spec, run, volumes[i], report);
                else report(Fixed(spec, volumes[i]));
            }
        }

        /// <summary>Fills a volume because a script asks for it.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="run">Its liquid.</param>
        /// <param name="volume">The volume, enabled or not.</param>
        /// <returns>Number of particles that are tried.</returns>
        /// <exception cref="InvalidOperationException">The volume cannot be filled.</exception>
        public int Add(in FluidSpec spec, FluidRun run, in VolumeSpec volume)
        {
            var found = new List<FluidMessage>();
            LiquidShape shape = VolumeChecks.Check(volume, spec, run.Collision, found);
            if (shape == null) throw new InvalidOperationException(FluidReports.Worst(found));
            Remember(spec, volume);
            return run.AddLiquid(spec, shape);
        }

        /// <summary>What a volume is besides what it has filled; null where it is the same, or has filled nothing.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="volume">The volume now.</param>
        /// <param name="isEnabled">Whether it and its object are active.</param>
        public FluidMessage? Difference(in FluidSpec spec, in VolumeSpec volume, bool isEnabled)
        {
            if (!filled.TryGetValue(volume.Owner, out VolumeSpec then)) return null;
            if (!isEnabled)
            {
                return new FluidMessage(FluidSeverity.Info, FluidIssue.VolumeChanged, volume.Owner,
                    "The liquid volume was disabled while the liquid runs: the liquid that it filled stays.",
                    "Restart the liquid to start without it, or enable the volume to add its liquid once more.");
            }
            if (IsSame(then, volume, spec)) return null;
            return new FluidMessage(FluidSeverity.Info, FluidIssue.VolumeChanged, volume.Owner,
                "The liquid volume was moved or changed while the liquid runs: it fills at the start and when it is enabled, and does " +
                "not carry liquid along.",
                "Restart the liquid to start with the volume as it is now.");
        }

        private static void Fill(in FluidSpec spec, FluidRun run, in VolumeSpec volume, Action<FluidMessage> report)
        {
            var messages = new List<FluidMessage>();
            LiquidShape shape = VolumeChecks.Check(volume, spec, run.Collision, messages);
            if (shape != null)
            {
                SpawnResult counted = FluidSpawner.Measure(SpawnRequests.For(spec, new[] { shape }, run.Collision));
                if (LiquidChecks.CheckCount(spec, counted, messages))
                {
                    LiquidChecks.Check(spec, new[] { (volume, shape) }, counted, run.Collision, messages);
                }
            }
            foreach (FluidMessage message in messages) report(message.Severity == FluidSeverity.Error ? Unfilled(message) : message);
            if (!FluidChecks.HasErrors(messages)) run.AddLiquid(spec, shape);
        }

        // The liquid runs on.
        private static FluidMessage Unfilled(in FluidMessage message) => new FluidMessage(
            FluidSeverity.Warning, message.Issue, message.Context, message.Text + " It adds no liquid.", message.Cure);

        private static FluidMessage Fixed(in FluidSpec spec, in VolumeSpec volume) => new FluidMessage(
            FluidSeverity.Warning, FluidIssue.VolumeChanged, volume.Owner,
            $"The liquid volume was enabled while '{spec.Name}' runs by the method {spec.Method}, which has a fixed number of particles: " +
            "it adds no liquid.",
            "Restart the liquid to start with the volume, or set Method to Standard or Robust.");

        private static bool IsSame(in VolumeSpec then, in VolumeSpec now, in FluidSpec spec)
        {
            Matrix4x4 toSimulation = spec.WorldToLocal * now.LocalToWorld;
            float tolerance = Tolerance * spec.Spacing;
            for (int i = 0; i < 16; i++)
                if (Mathf.Abs(toSimulation[i] - then.LocalToWorld[i]) > tolerance) return false;
            return now.Shape == then.Shape && AffineMath.Same(now.Size, then.Size) && now.FilledMesh == then.FilledMesh &&
                now.Level.Equals(then.Level) &&
                now.DomainHolds == then.DomainHolds && AffineMath.Same(now.InitialVelocity, then.InitialVelocity);
        }
    }
}
