using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Rules about the faces of the domain and the body force.</summary>
    internal static class BoundaryChecks
    {
        /// <summary>Checks a simulation whose domain size and spacing are positive numbers.</summary>
        public static void Check(in FluidSpec spec, List<FluidMessage> messages)
        {
            FluidSpec faces = spec;
            if (spec.IsOpen && Fault(() => CheckFaces(faces)) != null)
            {
                bool mayBe = FluidMethods.Has(spec.Method, FluidMethodFeatures.OpenFaces);
                messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.BoundariesInvalid, spec.Owner, mayBe
                        ? "The domain is open, and has neither periodic axes nor walls that move."
                        : $"The domain is open, but the method {spec.Method} keeps the liquid in a box.",
                    "Set Domain to Box, or " + (mayBe ? "take Periodic and all velocities out of Boundaries."
                        : $"use the method {FluidMethodKind.Standard} or {FluidMethodKind.Robust}.")));
            }
            else if (Fault(spec) is string fault)
            {
                int end = fault.IndexOf(". ", StringComparison.Ordinal) + 1;
                messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.BoundariesInvalid, spec.Owner,
                    end > 0 ? fault.Substring(0, end) : fault,
                    end > 0 ? fault.Substring(end + 1) : "Correct it under Boundaries, or reset that field."));
            }
        }

        /// <summary>Whether the faces alone are at fault, not what acts between them.</summary>
        public static bool FacesAreWrong(FluidSpec spec) => Fault(() => CheckFaces(spec)) != null;

        /// <summary>Whether the simulation, with a profile, searches cells of 2R.</summary>
        public static bool SearchesOctants(in FluidSpec spec) => FluidMethods.Has(spec.Method) &&
            FluidMethods.Get(spec.Method).SearchesOctants(spec.Profile.Rules);

        private static string Fault(FluidSpec spec) =>
            Fault(() => CheckFaces(spec)) ?? Fault(() => spec.BodyForce.Validate(spec.Boundaries.Periodic));

        private static string Fault(Action check)
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

        private static void CheckFaces(in FluidSpec spec)
        {
            FluidMethods.Get(spec.Method).CheckFaces(spec.Boundaries);
            if (spec.Boundaries.Periodic == FluidAxes.None || !spec.HasProfile) return;
            FluidGrid.For(new FluidSolverSettings
            {
                DomainSize = spec.DomainSize,
                SupportRadius = spec.Profile.Rules.SupportRatio * spec.Spacing,
                OctantSearch = SearchesOctants(spec),
                Boundaries = spec.Boundaries,
            });
        }
    }
}
