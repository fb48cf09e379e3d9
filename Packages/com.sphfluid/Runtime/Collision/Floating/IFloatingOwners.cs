using UnityEngine;

namespace SphFluid
{
    /// <summary>Knows the rigid bodies of colliders.</summary>
    internal interface IFloatingOwners
    {
        /// <summary>Begins a look for colliders.</summary>
        /// <param name="position">World position of the domain's centre [m].</param>
        /// <param name="rotation">World rotation of the domain.</param>
        void Begin(Vector3 position, Quaternion rotation);

        /// <summary>The rigid body that the liquid moves a collider with; null: none.</summary>
        FloatingBody OwnerOf(Collider collider);
    }
}
