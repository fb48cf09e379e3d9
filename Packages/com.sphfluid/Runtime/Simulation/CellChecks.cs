using System;
using System.Collections.Generic;
using UnityEngine;
using static System.FormattableString;

namespace SphFluid
{
    /// <summary>
    /// Rules about the size of the neighbour grid. Up to <see cref="SparseCells.MostDense"/> its memory goes with the domain's volume over
    /// R³, whether there is liquid or not, and with some methods beyond that as well.
    /// </summary>
    internal static class CellChecks
    {
        // What a cure's spacing is enlarged by, so that its rounding to three digits does not undo it.
        private const double Margin = 1.01;

        /// <summary>Checks a simulation whose domain size and spacing are positive numbers.</summary>
        public static void Check(in FluidSpec spec, List<FluidMessage> messages)
        {
            if (!spec.HasProfile) return;
            FluidSolverSettings settings = Settings(spec, spec.Spacing);
            double needed = Needed(settings);
            long most = Most(settings.Method);
            if (needed <= most) return;
            string owner = most < FluidMethods.Get(settings.Method).MaxCells
                ? $"a buffer of this device ({SystemInfo.graphicsDeviceName}) holds" : $"the method {settings.Method} holds";
            messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.TooManyCells, spec.Owner,
                Invariant($"The domain of {FluidMessage.Lengths(spec.DomainSize)} m needs {needed:N0} cells for the neighbour search at ") +
                Invariant($"a spacing of {spec.Spacing} m, but {owner} {most:N0}."),
                Invariant($"Use a smaller {spec.SizeField}, or a Particle Spacing of {FittingSpacing(spec):G3} m or more.")));
        }

        /// <summary>Cells that a solver of these settings has; along periodic axes that are too short none.</summary>
        public static double Needed(in FluidSolverSettings settings) =>
            FluidMethods.Get(settings.Method).CellCount(settings);

        /// <summary>Most cells that a method may have on this device.</summary>
        public static long Most(FluidMethodKind method) =>
            !FluidMethods.Get(method).StoresEmptyCells ? FluidMethods.Get(method).MaxCells
                : Math.Min(FluidMethods.Get(method).MaxCells, (long)(SystemInfo.maxGraphicsBufferSize / CellRows.BytesPerCell));

        /// <summary>Least spacing at which the domain's cells are few enough [m].</summary>
        public static float FittingSpacing(in FluidSpec spec)
        {
            double spacing = spec.Spacing, most = Most(spec.Method), needed;
            while ((needed = Needed(Settings(spec, (float)spacing))) > most)
            {
                spacing *= Math.Max(Margin, Math.Pow(needed / most, 1.0 / 3.0));
            }
            return (float)(spacing * Margin);
        }

        // What the grid depends on.
        private static FluidSolverSettings Settings(in FluidSpec spec, float spacing) => new FluidSolverSettings
        {
            Method = spec.Method,
            DomainSize = spec.DomainSize,
            SupportRadius = spec.Profile.Rules.SupportRatio * spacing,
            OctantSearch = BoundaryChecks.SearchesOctants(spec),
            Boundaries = spec.Boundaries,
        };
    }
}
