using UnityEngine;

namespace SphFluid
{
    /// <summary>A component that makes walls of what Unity's overlap queries do not find below its object.</summary>
    internal struct WallSpec
    {
        public Component Owner;

        /// <summary>How the walls act.</summary>
        public IColliderSettings Settings;

        /// <summary>Whether Skinned Mesh Renderers are walls.</summary>
        public bool Skins;

        /// <summary>Whether Wheel Colliders are walls.</summary>
        public bool Wheels;
    }
}
