using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A box of liquid at the start, centred on this transform and turned and scaled with it. A simulation may have
    /// several; where they overlap, liquid is filled once and the first in the hierarchy gives the velocity.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Volume")]
    public sealed class FluidVolume : MonoBehaviour
    {
        [SerializeField, Tooltip("Edge lengths of the box in this transform's space, in metres where its scale is one.")]
        Vector3 size = new Vector3(0.5f, 0.5f, 0.5f);

        [SerializeField, Tooltip("Velocity of the liquid at the start in m/s, in this transform's axes; scale does not change it.")]
        Vector3 initialVelocity;

        [SerializeField, Tooltip("Simulation that this liquid belongs to. Empty: the simulation among its parents, else the only one " +
            "in the scene, else the one whose domain holds the centre of the box.")]
        FluidSimulation simulation;

        /// <summary>Edge lengths of the box in this transform's space [m at unit scale]. Read when the simulation starts.</summary>
        public Vector3 Size { get => size; set => size = value; }

        /// <summary>Velocity at the start in this transform's axes [m/s].</summary>
        public Vector3 InitialVelocity { get => initialVelocity; set => initialVelocity = value; }

        /// <summary>Simulation that this liquid belongs to; null: found as the tooltip says.</summary>
        public FluidSimulation Simulation { get => simulation; set => simulation = value; }

        void OnEnable()
        {
            // Shows the component's check box in the inspector: a disabled volume holds no liquid.
        }
    }
}
