using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What computes the measured step: a method, its search, κ = R/dx, and whether a mesh stands in the liquid.</summary>
    public sealed class BenchSolver
    {
        // κ of the thesis's tables and of every comparison: the same k for all.
        private const float ComparedRatio = 2f;

        /// <summary>The thesis method with the octant's 8 cells of 2R, as 6.2 has it.</summary>
        public static readonly BenchSolver ThesisOctant =
            new BenchSolver("thesis_8", "Thesis, 8 cells", FluidMethodKind.Thesis) { OctantSearch = true };

        /// <summary>The thesis method with 27 cells of R.</summary>
        public static readonly BenchSolver ThesisCells = new BenchSolver("thesis_27", "Thesis, 27 cells", FluidMethodKind.Thesis);

        /// <summary>The same with its sort fused: <see cref="ThesisSettings.FusedSort"/>.</summary>
        public static readonly BenchSolver ThesisFused =
            new BenchSolver("thesis_27_fused", "Thesis, fused sort", FluidMethodKind.Thesis) { FusedSort = true };

        /// <summary>The Standard method as it is by default but for κ.</summary>
        public static readonly BenchSolver Standard =
            new BenchSolver("standard", "Standard", FluidMethodKind.Standard) { StableOrder = true, NeighbourList = true };

        /// <summary>The same with particles of a cell in the order of thread timing.</summary>
        public static readonly BenchSolver StandardUnordered =
            new BenchSolver("standard_unordered", "Standard, unordered", FluidMethodKind.Standard) { NeighbourList = true };

        /// <summary>The same with forces that search the cells again, without a list of neighbours.</summary>
        public static readonly BenchSolver StandardSearch =
            new BenchSolver("standard_search", "Standard, no list", FluidMethodKind.Standard) { StableOrder = true };

        /// <summary>The Standard method with a mesh in the liquid.</summary>
        public static readonly BenchSolver StandardMesh =
            new BenchSolver("standard_mesh", "Standard, mesh", FluidMethodKind.Standard)
            {
                StableOrder = true, NeighbourList = true,
                HasMesh = true
            };

        /// <summary>The Standard method at κ = 2.25.</summary>
        public static readonly BenchSolver StandardWide =
            new BenchSolver("standard_2.25", "Standard, κ 2.25", FluidMethodKind.Standard)
            {
                StableOrder = true, NeighbourList = true,
                SupportRatio = 2.25f
            };

        /// <summary>The Robust method: a step of two iterations.</summary>
        public static readonly BenchSolver Robust =
            new BenchSolver("robust", "Robust", FluidMethodKind.Robust) { StableOrder = true, NeighbourList = true };

        /// <summary>The Robust method at κ = 2.25.</summary>
        public static readonly BenchSolver RobustWide =
            new BenchSolver("robust_2.25", "Robust, κ 2.25", FluidMethodKind.Robust)
            {
                StableOrder = true, NeighbourList = true,
                SupportRatio = 2.25f
            };

        private BenchSolver(string name, string title, FluidMethodKind method)
        {
            Name = name;
            Title = title;
            Method = method;
        }

        /// <summary>Name in tables.</summary>
        public string Name { get; }

        /// <summary>Name for people.</summary>
        public string Title { get; }

        /// <summary>The method.</summary>
        public FluidMethodKind Method { get; }

        /// <summary>The method's name in tables.</summary>
        public string MethodName => CaseMethod.Of(Method).Name;

        /// <summary>Whether it is the thesis's method.</summary>
        internal bool IsThesis => Method == FluidMethodKind.Thesis;

        /// <summary>κ = R/dx.</summary>
        public float SupportRatio { get; private set; } = ComparedRatio;

        /// <summary>True: the octant's 8 cells of 2R. False: 27 cells of R.</summary>
        public bool OctantSearch { get; private set; }

        /// <summary>Whether the thesis's sort is fused.</summary>
        public bool FusedSort { get; private set; }

        /// <summary>Whether particles of a cell are ordered by their ids.</summary>
        public bool StableOrder { get; private set; }

        /// <summary>Whether density lists the neighbours for the forces, where the device has the memory.</summary>
        public bool NeighbourList { get; private set; }

        /// <summary>Whether <see cref="BenchMesh"/> stands in the liquid.</summary>
        public bool HasMesh { get; private set; }

        /// <summary>The search in words; runs are the 27 cells, three of a row at once.</summary>
        public string Search => OctantSearch ? "8 cells of 2R" : IsThesis ? "27 cells of R" : "9 runs of R";

        internal FluidSolverSettings Settings(float spacing, float height)
        {
            FluidRuleInput rules = FluidRuleInput.Water;
            rules.Method = Method;
            rules.DomainSize = Vector3.one * BenchLiquid.Edge;
            rules.Spacing = spacing;
            rules.SupportRatio = SupportRatio;
            rules.LiquidHeight = height;
            rules.LiquidDepth = height;
            FluidSolverSettings settings = FluidRules.Derive(rules);
            settings.OctantSearch = OctantSearch;
            if (Method == FluidMethodKind.Robust) return settings;
            if (IsThesis) return settings.WithOwn((ref ThesisSettings own) => own.FusedSort = FusedSort);
            return settings.WithOwn((ref StandardSettings own) =>
            {
                own.StableOrder = StableOrder;
                own.NeighbourList = NeighbourList;
            });
        }
    }
}
