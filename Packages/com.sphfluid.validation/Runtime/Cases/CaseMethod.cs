using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A method under its name on the command line and in tables.</summary>
    public sealed class CaseMethod
    {
        private CaseMethod(string name, string title, FluidMethodKind kind, double supportRatio, bool feelsWalls = false,
            bool hasTension = false, bool correctsGradient = false, bool isReference = false)
        {
            Name = name;
            Title = title;
            Kind = kind;
            SupportRatio = supportRatio;
            FeelsWalls = feelsWalls;
            HasTension = hasTension;
            CorrectsGradient = correctsGradient;
            IsReference = isReference;
        }

        /// <summary>Name, for instance "thesis".</summary>
        public string Name { get; }

        /// <summary>Name in legends.</summary>
        public string Title { get; }

        /// <summary>What the solver is given.</summary>
        public FluidMethodKind Kind { get; }

        /// <summary>κ = R/dx that cases sweep about: what the method is best run with.</summary>
        public double SupportRatio { get; }

        /// <summary>Whether the method sums the force on walls: <see cref="FluidSolver.MeasuresWallForces"/>.</summary>
        public bool FeelsWalls { get; }

        /// <summary>Whether surface tension acts in the method.</summary>
        public bool HasTension { get; }

        /// <summary>Whether the pressure's gradient is corrected: <see cref="FluidRuleInput.GradientCorrection"/>.</summary>
        public bool CorrectsGradient { get; }

        /// <summary>Whether it is measured only for others to be held against: fewer points, and no choice of users.</summary>
        public bool IsReference { get; }

        /// <summary>All methods, the best last.</summary>
        public static IReadOnlyList<CaseMethod> All { get; } = new[]
        {
            new CaseMethod("thesis-printed", "thesis, as printed", FluidMethodKind.ThesisPrinted, 2.0, isReference: true),
            new CaseMethod("thesis", "thesis, corrected", FluidMethodKind.Thesis, 2.0),
            new CaseMethod("robust", "robust", FluidMethodKind.Robust, 2.25),
            new CaseMethod("standard-corrected", "standard, gradient corrected", FluidMethodKind.Standard, 2.25, feelsWalls: true,
                hasTension: true, correctsGradient: true, isReference: true),
            new CaseMethod("standard", "standard", FluidMethodKind.Standard, 2.25, feelsWalls: true, hasTension: true),
        };

        /// <summary>Whether settings are of one of the thesis's methods.</summary>
        internal static bool IsThesis(in FluidSolverSettings settings) =>
            settings.Method == FluidMethodKind.Thesis || settings.Method == FluidMethodKind.ThesisPrinted;

        /// <summary>The best method of a kind.</summary>
        public static CaseMethod Of(FluidMethodKind kind) => All.LastOrDefault(m => m.Kind == kind) ??
            throw new ArgumentException($"There is no method {kind}.", nameof(kind));

        /// <summary>The method of a name.</summary>
        /// <exception cref="ArgumentException">There is none.</exception>
        public static CaseMethod Find(string name) => All.FirstOrDefault(m => m.Name == name) ??
            throw new ArgumentException($"There is no method '{name}'.", nameof(name));
    }
}
