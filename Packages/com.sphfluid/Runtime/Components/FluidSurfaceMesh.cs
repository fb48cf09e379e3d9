using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Hands the surface of a simulation's liquid on as an ordinary mesh, for materials and effects of your own: fills
    /// the mesh of the Mesh Filter on this GameObject each frame, on the GPU. A Mesh Renderer with any material draws
    /// it, with shadows, in every render pipeline.
    /// </summary>
    /// <remarks>
    /// The mesh's vertices lie in this object's space, whatever its transform; positions and normals only. Its bounds
    /// are the domain's. The content is on the GPU alone: for triangles on the CPU, e.g. to save them, use
    /// <see cref="FluidSurfaceMesher"/>.
    /// </remarks>
    [AddComponentMenu("SPH Fluid/Fluid Surface Mesh")]
    [RequireComponent(typeof(MeshFilter))]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(100)]
    [ManualPage("drawing", "any-material-fluid-surface-mesh")]
    public sealed class FluidSurfaceMesh : FluidView
    {
        [SerializeField, Tooltip("How the surface is made.")]
        private FluidSurfaceOptions surface = new FluidSurfaceOptions();

        private SurfaceSource source;
        private FilledMesh target;
        private CommandBuffer cmd;
        private bool unseenReported;
        private bool flatReported;
        private Matrix4x4 filledBy;

        /// <summary>How the surface is made.</summary>
        public FluidSurfaceOptions Surface => surface;

        /// <summary>
        /// The mesh that the GPU fills; null while no simulation runs. It holds more triangles than the surface has:
        /// those left have no area.
        /// </summary>
        public Mesh Mesh => target?.Mesh;

        /// <summary>Bytes of GPU memory of the surface and its mesh; 0 while no simulation runs.</summary>
        public long GpuBytes => target == null ? 0 : source.Surface.GpuBytes + target.GpuBytes;

        /// <summary>
        /// What became of the last surface that the GPU reported, a few frames late; all zero while no simulation runs.
        /// </summary>
        public SurfaceStatus Status => source?.Surface.Status ?? default;

        internal SparseSurface Sparse => source?.Surface;

        /// <summary>
        /// Why nobody sees the mesh, and the cure, as sentences; null where a renderer with a material draws it.
        /// </summary>
        internal string WhyUnseen()
        {
            if (!TryGetComponent(out MeshRenderer seen))
            {
                return $"Nothing draws the mesh of {nameof(FluidSurfaceMesh)}. Add a Mesh Renderer with a material.";
            }
            return seen.sharedMaterial == null ? $"The Mesh Renderer of {nameof(FluidSurfaceMesh)} has no material. Assign one." : null;
        }

        /// <inheritdoc/>
        protected override void OnEnable()
        {
            base.OnEnable();
            unseenReported = false;
            flatReported = false;
        }

        /// <inheritdoc/>
        protected override void CreateResources(FluidShaderSet shaders)
        {
            source = new SurfaceSource(shaders);
            target = new FilledMesh(shaders, name + " Surface");
            cmd = new CommandBuffer { name = "Fluid Surface Mesh" };
        }

        /// <inheritdoc/>
        protected override void ReleaseResources()
        {
            DrawNothing();
            source?.Dispose();
            target?.Dispose();
            cmd?.Dispose();
            source = null;
            target = null;
            cmd = null;
        }

        /// <inheritdoc/>
        protected override void Draw(FluidSimulation drawn)
        {
            ReportUnseen();
            ReportCells(drawn, surface);
            source.CellFactor = drawn.Detail.CellFactor;
            if (IsFlat() || !source.Request(drawn.Solver, surface, 0, this, out SurfaceBuffers buffers))
            {
                DrawNothing();
                return;
            }
            Matrix4x4 toMesh = transform.worldToLocalMatrix * drawn.LocalToWorld;
            if (source.Make() || toMesh != filledBy)
            {
                target.Fill(cmd, buffers, toMesh, drawn.Solver.Settings.DomainSize);
                filledBy = toMesh;
            }
            GetComponent<MeshFilter>().sharedMesh = target.Mesh;
            FluidProfiler.AddSurface(Status.Triangles, 0, GpuBytes);
        }

        /// <inheritdoc/>
        protected override void DrawNothing()
        {
            if (target != null && TryGetComponent(out MeshFilter filter) && filter.sharedMesh == target.Mesh) filter.sharedMesh = null;
        }

        // The inverse of a transform that flattens holds no usable numbers.
        private bool IsFlat()
        {
            Vector3 scale = transform.lossyScale;
            bool flat = scale.x == 0f || scale.y == 0f || scale.z == 0f;
            if (flat && !flatReported)
            {
                Debug.LogWarning(
                    $"{FluidMessage.Prefix} '{name}': The transform flattens the object: its scale is {scale}, and no mesh fits into it. " +
                    "Give it a scale other than 0.", this);
            }
            flatReported = flat;
            return flat;
        }

        private void ReportUnseen()
        {
            if (unseenReported) return;
            unseenReported = true;
            string reason = WhyUnseen();
            if (reason != null) Debug.LogWarning($"{FluidMessage.Prefix} '{name}': {reason}", this);
        }
    }
}
