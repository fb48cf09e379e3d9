using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Shows the walls of a simulation's domain as a glass tank: panes, and bars along the edges, round the domain's box, which follow its
    /// size in the Editor and in play. Only a picture: the faces of the domain hold the liquid, and the tank has no colliders. The object
    /// is a child of the simulation's, without a displacement of its own. The first material of its Mesh Renderer is the glass, the second
    /// the frame.
    /// </summary>
    [ManualPage("getting-started", "from-the-menu")]
    [AddComponentMenu("SPH Fluid/Fluid Tank")]
    [ExecuteAlways]
    [DisallowMultipleComponent]
    [RequireComponent(typeof(MeshFilter), typeof(MeshRenderer))]
    public sealed class FluidTank : MonoBehaviour
    {
        [SerializeField, Tooltip("Simulation whose domain is shown. Empty: the one among this object's parents.")]
        private FluidSimulation simulation;

        [SerializeField, Unit("m"), Min(0f), Tooltip("Thickness of the bars along the edges in metres. 0: no bars.")]
        private float edge = 0.02f;

        [SerializeField, Tooltip("Add a pane above the liquid.")]
        private bool lid;

        private Mesh mesh;
        private (Vector3 size, float edge, bool lid) shown;
        private bool reported;

        /// <summary>Simulation whose domain is shown; where none is assigned, the one among the object's parents, or null.</summary>
        public FluidSimulation Simulation
        {
            get => simulation != null ? simulation : GetComponentInParent<FluidSimulation>();
            set
            {
                simulation = value;
                Refresh();
            }
        }

        /// <summary>Thickness of the bars along the edges [m], 0 or more; 0: no bars.</summary>
        public float Edge
        {
            get => Limits.Clamp(edge, 0f);
            set
            {
                edge = value;
                Refresh();
            }
        }

        /// <summary>Whether there is a pane above the liquid.</summary>
        public bool Lid
        {
            get => lid;
            set
            {
                lid = value;
                Refresh();
            }
        }

        private void OnEnable()
        {
            mesh = new Mesh { name = "SPH Fluid Tank", hideFlags = HideFlags.HideAndDontSave };
            GetComponent<MeshFilter>().sharedMesh = mesh;
            shown = default;
            reported = false;
            Refresh();
        }

        private void OnDisable()
        {
            if (TryGetComponent(out MeshFilter filter) && filter.sharedMesh == mesh) filter.sharedMesh = null;
            DestroyImmediate(mesh);
            mesh = null;
        }

        private void OnTransformParentChanged() => Refresh();

        private void Update()
        {
            if (Simulation == null) ReportMissing();
            Refresh();
        }

        private void Refresh()
        {
            if (mesh == null) return; // it is disabled
            FluidSimulation owner = Simulation;
            bool hasWalls = owner != null && owner.Domain == FluidDomain.Box && AffineMath.IsFinite(owner.DomainSize);
            Vector3 size = hasWalls ? Vector3.Max(owner.DomainSize, Vector3.zero) : Vector3.zero;
            if (shown == (size, Edge, lid)) return;
            shown = (size, Edge, lid);
            if (size == Vector3.zero) mesh.Clear();
            else TankMesh.Fill(mesh, size, Edge, lid);
        }

        private void ReportMissing()
        {
            if (reported || !Application.isPlaying) return;
            reported = true;
            Debug.LogWarning(
                $"{FluidMessage.Prefix} '{name}': Fluid Tank has no simulation to show. Assign one, or make the object a child of the " +
                "Fluid Simulation.", this);
        }
    }
}
