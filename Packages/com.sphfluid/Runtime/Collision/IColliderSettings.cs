using UnityEngine;

namespace SphFluid
{
    /// <summary>Settings of the colliders of an object and of those below it, given by a component.</summary>
    internal interface IColliderSettings
    {
        /// <summary>Whether the settings count; colliders of switched-off ones act as without any.</summary>
        bool IsActive { get; }

        /// <summary>0 free slip to 1 no slip, or <see cref="ColliderSettings.DomainFriction"/>.</summary>
        float EffectiveFriction { get; }

        /// <summary>Whether the liquid moves the Rigidbody of the colliders.</summary>
        bool MovedByLiquid { get; }

        /// <summary>Width of Wheel Colliders [m]; not above 0: in proportion to their radius.</summary>
        float WheelWidth { get; }

        /// <summary>Whether a simulation collides.</summary>
        /// <param name="owner">The simulation's component; null: any.</param>
        bool AppliesTo(Component owner);
    }

    /// <summary>Finds the settings of a collider.</summary>
    internal static class ColliderSettings
    {
        /// <summary>Stands for the friction of the domain's faces.</summary>
        public const float DomainFriction = -1f;

        /// <summary>The nearest settings upwards of a collider or a renderer; null where there are none or they are switched off.</summary>
        public static IColliderSettings Find(Component collider)
        {
            var nearest = collider.GetComponentInParent<IColliderSettings>();
            return nearest != null && nearest.IsActive ? nearest : null;
        }
    }
}
