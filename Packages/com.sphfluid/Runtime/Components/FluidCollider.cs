using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// How a liquid interacts with the colliders of this object and of those below it, where that differs from the simulation's settings.
    /// Colliders need no such component to act; Skinned Mesh Renderers do, and Wheel Colliders may. The nearest one upwards counts; a
    /// disabled one leaves them to the simulation's settings.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Collider")]
    [DisallowMultipleComponent]
    [ManualPage("colliders", "friction")]
    public sealed class FluidCollider : MonoBehaviour, IColliderSettings, IFluidPart<WallSpec>
    {
        [SerializeField, Tooltip("Use the friction given here. Off: the friction of the simulation's faces.")]
        private bool ownFriction = true;

        [SerializeField, Range(0f, 1f),
            Tooltip("How much these colliders hold the liquid next to them: 0 lets it slip freely, 1 holds it by its own " +
            "viscosity (no slip). The thesis's method knows the faces' friction only.")]
        private float friction = 1f;

        [SerializeField,
            Tooltip(
                "The liquid moves the Rigidbody of these colliders, unless it is kinematic. Off: they push the liquid and do not feel " +
                "it. " +
            "The thesis's method moves none.")]
        private bool movedByLiquid = true;

        [SerializeField,
            Tooltip(
                "The liquid collides with the Skinned Mesh Renderers of this object and of those below it as they are drawn. Each is " +
                "skinned on the " +
            "CPU every frame; use characters with few vertices.")]
        private bool skinnedMeshes;

        [SerializeField,
            Tooltip(
                "The liquid collides with the Wheel Colliders of this object and of those below it even where Unity's overlap queries do " +
                "not " +
            "report them. The car does not feel the liquid through them.")]
        private bool wheelColliders;

        [SerializeField, Min(0f),
            Tooltip("Width of the Wheel Colliders [m], which have none of their own. 0: 0.65 of the radius, like a car's tyre.")]
        private float wheelWidth;

        [SerializeField, Tooltip("Simulations that collide with these colliders. Empty: all that find them.")]
        private List<FluidSimulation> simulations = new List<FluidSimulation>();

        /// <summary>Whether <see cref="Friction"/> counts instead of that of the simulation's faces.</summary>
        public bool OwnFriction { get => ownFriction; set => ownFriction = value; }

        /// <summary>0 free slip to 1 no slip.</summary>
        public float Friction { get => Limits.Clamp(friction, 0f, 1f); set => friction = value; }

        /// <summary>Whether the liquid moves the Rigidbody of these colliders, unless it is kinematic.</summary>
        public bool MovedByLiquid { get => movedByLiquid; set => movedByLiquid = value; }

        /// <summary>
        /// Whether the Skinned Mesh Renderers of this object and of those below it are walls, up to 20,000 vertices each.
        /// </summary>
        public bool SkinnedMeshes { get => skinnedMeshes; set => skinnedMeshes = value; }

        /// <summary>
        /// Whether the Wheel Colliders of this object and of those below it are looked for besides those that Unity's overlap queries
        /// report.
        /// </summary>
        public bool WheelColliders { get => wheelColliders; set => wheelColliders = value; }

        /// <summary>Width of the Wheel Colliders [m], 0 or more; 0: 0.65 of the radius.</summary>
        public float WheelWidth { get => Limits.Clamp(wheelWidth, 0f); set => wheelWidth = value; }

        /// <summary>Simulations that collide; empty: all that find the colliders.</summary>
        public List<FluidSimulation> Simulations => simulations;

        bool IColliderSettings.IsActive => enabled;

        float IColliderSettings.EffectiveFriction => ownFriction ? Friction : ColliderSettings.DomainFriction;

        bool IColliderSettings.MovedByLiquid => movedByLiquid;

        float IColliderSettings.WheelWidth => WheelWidth;

        bool IColliderSettings.AppliesTo(Component owner) =>
            owner == null || simulations.Count == 0 || simulations.Contains(owner as FluidSimulation);

        WallSpec IFluidPart<WallSpec>.Spec =>
            new WallSpec { Owner = this, Settings = this, Skins = skinnedMeshes, Wheels = wheelColliders };

        Component IFluidPart<WallSpec>.Named => null;

        private void OnEnable() => FluidParts<WallSpec>.Add(this);

        private void OnDisable() => FluidParts<WallSpec>.Remove(this);

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        internal static void ResetStatics() => FluidParts<WallSpec>.Clear();
    }
}
