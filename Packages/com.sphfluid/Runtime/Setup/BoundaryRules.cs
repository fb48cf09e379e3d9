using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Rules about the faces of the domain and the body force.</summary>
    internal static class BoundaryRules
    {
        /// <summary>Checks a simulation whose domain size and spacing are positive numbers.</summary>
        public static void Check(FluidSimulation simulation, List<FluidMessage> messages)
        {
            if (Fault(simulation) is string fault)
            {
                int end = fault.IndexOf(". ", StringComparison.Ordinal) + 1;
                messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.BoundariesInvalid, simulation,
                    end > 0 ? fault.Substring(0, end) : fault,
                    end > 0 ? fault.Substring(end + 1) : "Correct it under Boundaries, or reset that field."));
            }
        }

        /// <summary>Whether the faces alone are at fault, not what acts between them.</summary>
        public static bool FacesAreWrong(FluidSimulation simulation) => Fault(() => CheckFaces(simulation)) != null;

        /// <summary>Whether the simulation, with a profile, searches cells of 2R.</summary>
        public static bool SearchesOctants(FluidSimulation simulation) => simulation.Method == FluidMethodKind.ThesisPrinted ||
            simulation.Method == FluidMethodKind.Thesis && simulation.Profile.ThesisSwitches.OctantSearch;

        static string Fault(FluidSimulation simulation) =>
            Fault(() => CheckFaces(simulation)) ?? Fault(() => simulation.BodyForce.Validate(simulation.Boundaries.Periodic));

        static string Fault(Action check)
        {
            try
            {
                check();
                return null;
            }
            catch (ArgumentException exception)
            {
                return exception.Message;
            }
        }

        static void CheckFaces(FluidSimulation simulation)
        {
            simulation.Boundaries.Validate(simulation.Method);
            FluidProfile profile = simulation.Profile;
            if (simulation.Boundaries.Periodic == FluidAxes.None || profile == null) return;
            FluidGrid.For(new FluidSolverSettings
            {
                DomainSize = simulation.DomainSize,
                SupportRadius = profile.SupportRatio * simulation.Spacing,
                OctantSearch = SearchesOctants(simulation),
                Boundaries = simulation.Boundaries,
            });
        }
    }
}
