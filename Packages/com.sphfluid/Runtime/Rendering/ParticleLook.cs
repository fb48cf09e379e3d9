using UnityEngine;

namespace SphFluid
{
    /// <summary>How particles look when they are drawn as squares.</summary>
    internal struct ParticleLook
    {
        /// <summary>Edge of a square [m].</summary>
        public float Size;

        /// <summary>Colour at rest.</summary>
        public Color Color;

        /// <summary>Colour at <see cref="FastSpeed"/> and above.</summary>
        public Color FastColor;

        /// <summary>Speed of the fast colour [m/s]; 0: all particles have <see cref="Color"/>.</summary>
        public float FastSpeed;

        /// <summary>Smoothness of the highlight, 0 to 1.</summary>
        public float Smoothness;

        /// <summary>Sprite of a square, or null for the round one.</summary>
        public Texture2D Sprite;
    }
}
