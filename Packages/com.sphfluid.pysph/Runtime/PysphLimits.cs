using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// What of a simulation PySPH's schemes for free surfaces cannot express: a message each, about its object. Colliders are
    /// <see cref="ColliderTracks"/>' matter.
    /// </summary>
    internal static class PysphLimits
    {
        private const string Schemes = "PySPH's WCSPH and EDAC schemes";

        /// <summary>Reports it.</summary>
        /// <param name="spec">The simulation, with a profile.</param>
        /// <param name="report">Receives the messages.</param>
        public static void Report(in FluidSpec spec, Action<FluidMessage> report)
        {
            for (int i = 0; i < (spec.Emitters?.Count ?? 0); i++)
            {
                Say(report, spec.Emitters[i].Owner,
                    $"The emitter is not exported: {Schemes} for free surfaces have no inlet that begins dry.",
                    "Let it pour before, and export the running liquid.");
            }
            for (int i = 0; i < (spec.Drains?.Count ?? 0); i++)
            {
                Say(report, spec.Drains[i].Owner, $"The drain is not exported: {Schemes} remove no particles.", "");
            }
            for (int i = 0; i < (spec.Zones?.Count ?? 0); i++)
            {
                Say(report, spec.Zones[i].Owner, $"The force zone is not exported: {Schemes} know gravity only.", "");
            }
            ReportLiquid(spec, report);
            ReportFaces(spec, report);
        }

        private static void ReportLiquid(in FluidSpec spec, Action<FluidMessage> report)
        {
            if (spec.BodyForce.IsOn) Say(report, spec.Owner, $"The body force is not exported: {Schemes} know gravity only.", "");
            FluidMethodFeatures asked = Asked(spec);
            if ((asked & FluidMethodFeatures.SurfaceTension) != 0)
            {
                Say(report, spec.Profile.Asset, $"Surface tension is not exported: {Schemes} have none.", "");
            }
            if ((asked & FluidMethodFeatures.ImplicitViscosity) != 0)
            {
                Say(report, spec.Profile.Asset,
                    $"Implicit viscosity is not exported: {Schemes} take viscosity explicitly, in steps that it makes short.", "");
            }
            if (spec.Boundaries.Friction < 1f)
            {
                report(new FluidMessage(FluidSeverity.Info, FluidIssue.NotExported, spec.Owner, FormattableString.Invariant(
                    $"Friction of {spec.Boundaries.Friction:G3} is not exported: walls in PySPH hold the liquid by its full viscosity, ") +
                    "and artificial viscosity brakes it besides.", ""));
            }
            report(new FluidMessage(FluidSeverity.Info, FluidIssue.NotExported, spec.Owner,
                "Contact is not proved in PySPH: walls are layers of particles that push, and very fast liquid can cross them. " +
                "to_sequence.py counts what leaves the box.", ""));
        }

        // What a liquid as high as the domain asks for.
        private static FluidMethodFeatures Asked(in FluidSpec spec)
        {
            FluidRuleInput input = spec.Profile.Rules;
            Vector3 gravity = spec.LocalGravity, up = gravity.normalized, size = spec.DomainSize;
            (input.Method, input.DomainSize, input.Spacing, input.Gravity) = (FluidMethodKind.Standard, size, spec.Spacing, gravity);
            input.LiquidHeight = input.LiquidDepth = Mathf.Abs(up.x) * size.x + Mathf.Abs(up.y) * size.y + Mathf.Abs(up.z) * size.z;
            return MethodObstacles.AskedBy(input);
        }

        private static void ReportFaces(in FluidSpec spec, Action<FluidMessage> report)
        {
            if (spec.Boundaries.Open != FluidFaces.None)
            {
                Say(report, spec.Owner,
                    $"Open faces ({spec.Boundaries.Open}) remove nothing in PySPH: liquid beyond them is computed on, and to_sequence.py " +
                    "leaves it out.", "");
            }
            if (spec.Boundaries.Periodic != FluidAxes.None)
            {
                Say(report, spec.Owner,
                    $"The periodic axes ({spec.Boundaries.Periodic}) are exported, but PySPH has none across MPI processes.",
                    "Run the case as one process: RANKS=1 bash run.sh.");
            }
        }

        private static void Say(Action<FluidMessage> report, UnityEngine.Object about, string text, string cure) =>
            report(new FluidMessage(FluidSeverity.Warning, FluidIssue.NotExported, about, text, cure));
    }
}
