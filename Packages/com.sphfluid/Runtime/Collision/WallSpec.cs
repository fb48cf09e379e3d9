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

        /// <summary>Whether a part below its object is this component's, on one of the layers: the nearest one upwards counts.</summary>
        public readonly bool Has(Component part, LayerMask layers) =>
            (layers & (1 << part.gameObject.layer)) != 0 && ReferenceEquals(ColliderSettings.Find(part), Settings);
    }
}
