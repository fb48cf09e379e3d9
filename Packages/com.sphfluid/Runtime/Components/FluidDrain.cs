using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A place where liquid leaves: this object's Box, Sphere or Capsule Collider, or without one a box of a size. Make the collider a
    /// trigger, or the liquid collides with it. Thicker than the liquid goes between two sorts, about half a particle spacing. Methods
    /// Standard and Robust.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Drain")]
    [ManualPage("pouring", "drain")]
    public sealed class FluidDrain : MonoBehaviour, IFluidPart<DrainSpec>
    {
        private readonly DrainState state = new DrainState();

        [SerializeField, Unit("m"),
            Tooltip(
                "Edge lengths of the drain in this transform's space, in metres where its scale is one. Not used where this object has a " +
                "Box, Sphere or Capsule Collider.")]
        private Vector3 size = new Vector3(0.25f, 0.25f, 0.25f);

        [SerializeField, Tooltip("Simulation whose liquid leaves. Empty: the simulation among its parents, else the only one " +
            "in the scene, else the one whose domain holds this object.")]
        private FluidSimulation simulation;

        /// <summary>
        /// Edge lengths of the box in this transform's space [m at unit scale], where the object has no collider that serves; 0 or more.
        /// Without a volume nothing leaves, and a message says so.
        /// </summary>
        public Vector3 Size { get => Limits.NotNegative(size); set => size = value; }

        /// <summary>Simulation whose liquid leaves; null: found as the tooltip says.</summary>
        public FluidSimulation Simulation { get => simulation; set => simulation = value; }

        /// <summary>Volume that has left here [m³], as of a few frames ago.</summary>
        public double DrainedVolume => state.Drained;

        /// <summary>The drain as of now.</summary>
        internal DrainSpec Spec
        {
            get
            {
                var spec = new DrainSpec { Owner = this, State = state };
                TryGetComponent(out Collider collider);
                Vector3 scale = transform.lossyScale;
                switch (collider)
                {
                    case SphereCollider sphere:
                        float largest = Mathf.Max(Mathf.Abs(scale.x), Mathf.Max(Mathf.Abs(scale.y), Mathf.Abs(scale.z)));
                        spec.Frame = Placed(sphere.center, Quaternion.identity, largest * sphere.radius * Vector3.one);
                        break;
                    case CapsuleCollider capsule:
                        SetCapsule(ref spec, capsule, scale);
                        break;
                    case BoxCollider box:
                        spec.IsBox = true;
                        spec.Frame = transform.localToWorldMatrix * Matrix4x4.TRS(box.center, Quaternion.identity, 0.5f * box.size);
                        break;
                    default:
                        spec.IsBox = true;
                        spec.IgnoresCollider = collider != null;
                        spec.Frame = transform.localToWorldMatrix * Matrix4x4.Scale(0.5f * Size);
                        break;
                }
                return spec;
            }
        }

        // As PhysX scales it: the radius by the larger scale across, the height by that along the axis.
        private void SetCapsule(ref DrainSpec spec, CapsuleCollider capsule, Vector3 scale)
        {
            int axis = capsule.direction;
            float radius = capsule.radius * Mathf.Max(Mathf.Abs(scale[(axis + 1) % 3]), Mathf.Abs(scale[(axis + 2) % 3]));
            float half = Mathf.Max(0f, 0.5f * capsule.height * Mathf.Abs(scale[axis]) - radius);
            Quaternion turn = axis == 0 ? Quaternion.Euler(0f, 0f, 90f) : axis == 2 ? Quaternion.Euler(90f, 0f, 0f) : Quaternion.identity;
            spec.Frame = Placed(capsule.center, turn, radius * Vector3.one);
            spec.Length = radius > 0f ? half / radius : 0f;
        }

        private Matrix4x4 Placed(Vector3 centre, Quaternion turn, Vector3 scale) =>
            Matrix4x4.TRS(transform.TransformPoint(centre), transform.rotation * turn, scale);

        DrainSpec IFluidPart<DrainSpec>.Spec => Spec;

        Component IFluidPart<DrainSpec>.Named => simulation;

        private void OnEnable() => FluidParts<DrainSpec>.Add(this);

        private void OnDisable() => FluidParts<DrainSpec>.Remove(this);

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        internal static void ResetStatics() => FluidParts<DrainSpec>.Clear();
    }
}
