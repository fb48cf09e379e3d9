using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>A map: two axes, a scene for each cell and the borders that theory draws.</summary>
    public sealed class StabilityMap
    {
        readonly Func<StabilityRun, StabilityScenario> build;

        internal StabilityMap(string name, string title, StabilityAxis x, StabilityAxis y, Func<StabilityRun, StabilityScenario> build,
            params StabilityBorder[] borders)
        {
            Name = name;
            Title = title;
            X = x;
            Y = y;
            this.build = build;
            Borders = borders;
        }

        /// <summary>Name on the command line: M1 to M5.</summary>
        public string Name { get; }

        /// <summary>What it shows.</summary>
        public string Title { get; }

        /// <summary>Horizontal axis.</summary>
        public StabilityAxis X { get; }

        /// <summary>Vertical axis.</summary>
        public StabilityAxis Y { get; }

        /// <summary>Borders by theory.</summary>
        public IReadOnlyList<StabilityBorder> Borders { get; }

        /// <summary>The scene of a cell.</summary>
        /// <param name="run">Cell, method, seed, clamps and most steps.</param>
        public StabilityScenario Build(StabilityRun run) => build(run).Cut(run.MostSteps);
    }
}
