using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>How much detail a liquid has at a moment; the default: all.</summary>
    internal readonly struct FluidDetail
    {
        private readonly FluidDetailLevel level;

        /// <summary>A level of some.</summary>
        /// <param name="owner">Component that messages name.</param>
        /// <param name="levels">All of them, the nearest first.</param>
        /// <param name="number">Which one acts, from 1 on; 0: none.</param>
        public FluidDetail(Component owner, IReadOnlyList<FluidDetailLevel> levels, int number)
        {
            (Owner, Levels, Number) = (owner, levels, number);
            level = number > 0 ? levels[number - 1] : null;
        }

        private FluidDetail(in FluidDetail other, FluidDetailLevel motion)
        {
            this = other;
            level = motion;
        }

        /// <summary>Component that messages name; null: the liquid has all detail always.</summary>
        public Component Owner { get; }

        /// <summary>All levels; null: none.</summary>
        public IReadOnlyList<FluidDetailLevel> Levels { get; }

        /// <summary>Number of the level that acts; 0: none.</summary>
        public int Number { get; }

        /// <summary>How many times longer steps are to be, 1 or more.</summary>
        public double StepFactor => level == null ? 1.0 : Math.Max(1.0, level.StepFactor);

        public bool Paused => level != null && level.Paused;
        public bool Drawn => level == null || level.Drawn;
        public float CellFactor => level == null ? 1f : Math.Max(1f, level.CellFactor);
        public bool Whitewater => level == null || level.Whitewater;
        public bool Caustics => level == null || level.Caustics;

        /// <summary>Whether the level changes the liquid's motion.</summary>
        public bool Slows => StepFactor > 1.0 || Paused;

        /// <summary>The same to look at, with all of the motion: for liquid that is recorded or replayed.</summary>
        public FluidDetail WithAllMotion => !Slows ? this : new FluidDetail(this, new FluidDetailLevel
        {
            Drawn = Drawn, CellFactor = CellFactor, Whitewater = Whitewater, Caustics = Caustics,
        });
    }
}
