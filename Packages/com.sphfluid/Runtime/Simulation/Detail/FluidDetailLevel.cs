using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>What is given up of a liquid from a distance on.</summary>
    [Serializable]
    public sealed class FluidDetailLevel
    {
        /// <summary>Distance from the nearest camera to the liquid's box from which on the level acts [m], greater than 0.</summary>
        [Unit("m"), Min(0f),
            Tooltip("Distance from the nearest camera to the liquid's box from which on the level acts, in metres, for a camera of 60°.")]
        public float Distance = 30f;

        /// <summary>How many times longer steps may be, as far as the method can; 1 or more.</summary>
        [Range(1f, 4f),
            Tooltip("How many times longer steps may be. Standard: the speed of sound is so many times lower, and the liquid is " +
            "compressed by the square of it more. Robust: so many times fewer Substeps.")]
        public float StepFactor = 1f;

        /// <summary>Whether the liquid stands still, as by <see cref="FluidSimulationSettings.Paused"/>.</summary>
        [Tooltip("The liquid stands still, as by Paused of the simulation; its time stops.")]
        public bool Paused;

        /// <summary>Whether it is drawn. Where it is not, no surface is made.</summary>
        [Tooltip("Whether the liquid is drawn. Off: no surface is made, and nothing of it is seen.")]
        public bool Drawn = true;

        /// <summary>Edge of a cell of the surface over what it is as set up; 1 or more.</summary>
        [Range(1f, 4f), Tooltip("How many times larger cells of the surface are; no cell is larger than two particle spacings.")]
        public float CellFactor = 1f;

        /// <summary>Whether spray, foam and bubbles are made.</summary>
        [Tooltip("Whether Fluid Whitewater acts. Off: it makes none, and what there is goes.")]
        public bool Whitewater = true;

        /// <summary>Whether water casts caustics.</summary>
        [Tooltip("Whether water has its Caustics.")]
        public bool Caustics = true;
    }
}
