using UnityEngine;

namespace SphFluid
{
    /// <summary>A component that makes walls of the Skinned Mesh Renderers of its object and of those below it.</summary>
    internal struct SkinSpec
    {
        public Component Owner;

        /// <summary>How they act; null: they do not.</summary>
        public IColliderSettings Settings;
    }
}
