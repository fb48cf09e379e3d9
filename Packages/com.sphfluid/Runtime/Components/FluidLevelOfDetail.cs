using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Events;

namespace SphFluid
{
    /// <summary>
    /// Less work for the liquid of the simulation on the same GameObject where it is far from every camera: longer steps, a coarser surface
    /// or none, no whitewater, or a stop. The liquid then depends on the cameras, except while it is recorded or replayed.
    /// </summary>
    [AddComponentMenu("SPH Fluid/Fluid Level Of Detail")]
    [ManualPage("performance", "level-of-detail")]
    [RequireComponent(typeof(FluidSimulation))]
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(45)]
    public sealed class FluidLevelOfDetail : MonoBehaviour, IFluidDetailSource
    {
        /// <summary>An event with the number of the level.</summary>
        [Serializable]
        public sealed class LevelEvent : UnityEvent<int>
        {
        }

        // Frames: cameras that are switched leave none for one.
        private const int Patience = 30;

        [SerializeField, Min(0f),
            Tooltip("Multiplies the distances: 2 keeps the liquid's detail twice as far. Greater than 0.")]
        private float importance = 1f;

        [SerializeField, Tooltip("What is given up from which distance on, the nearest first. Nearer than the first: nothing.")]
        private List<FluidDetailLevel> levels = new List<FluidDetailLevel>
        {
            new FluidDetailLevel { Distance = 30f, StepFactor = 1.5f, CellFactor = 1.5f },
            new FluidDetailLevel { Distance = 80f, StepFactor = 2f, CellFactor = 2f, Whitewater = false, Caustics = false },
        };

        [SerializeField, Tooltip("LOD Bias of the quality settings multiplies the distances as well, as those of a LOD Group.")]
        private bool useLodBias = true;

        [SerializeField,
            Tooltip("Cameras that count, while their objects are active. Empty: all enabled ones that draw this object's layer.")]
        private List<Camera> cameras = new List<Camera>();

        [SerializeField, Unit("m"),
            Tooltip("Edge lengths of the box about this object that distances count to, in metres; 0 inside. Zeros: the domain, of an " +
            "open domain as far as its liquid may go.")]
        private Vector3 size;

        [SerializeField, Tooltip("Raised with the number of the level when another one begins to act; 0: all detail.")]
        private LevelEvent levelChanged = new LevelEvent();

        [OutlivesPlay("it is filled anew, and used at once, by whoever asks")] private static Camera[] found = new Camera[4];

        private FluidSimulation simulation;
        private float seenFrom;
        private int without;

        /// <summary>Multiplies the distances, greater than 0.</summary>
        public float Importance { get => importance; set => importance = value; }

        /// <summary>What is given up from which distance on, by ascending distances; a change acts at once.</summary>
        public List<FluidDetailLevel> Levels => levels;

        /// <summary>Whether QualitySettings.lodBias multiplies the distances as well.</summary>
        public bool UseLodBias { get => useLodBias; set => useLodBias = value; }

        /// <summary>
        /// Cameras that count, while their objects are active; none: all enabled ones that draw this object's layer. Those of the Scene
        /// view never do.
        /// </summary>
        public List<Camera> Cameras => cameras;

        /// <summary>
        /// Edge lengths of the box about this object that distances count to [m]; zero: the domain's, of an open domain as far as its
        /// liquid may go.
        /// </summary>
        public Vector3 Size { get => size; set => size = value; }

        /// <summary>Raised with the number of the level when another one begins to act; 0: all detail.</summary>
        public LevelEvent LevelChanged => levelChanged;

        /// <summary>Number of the level that acts; 0: all detail.</summary>
        public int CurrentLevel { get; private set; }

        /// <summary>Distance of the nearest camera from the liquid's box [m]; infinite before there is one.</summary>
        public float Distance { get; private set; } = float.PositiveInfinity;

        /// <summary>The nearest camera, as large as it shows the liquid; null before there is one.</summary>
        public Camera NearestCamera { get; private set; }

        /// <summary>What multiplies the distances.</summary>
        internal float Reach => importance * (useLodBias ? QualitySettings.lodBias : 1f);

        /// <summary>Edge lengths of the box that distances count to [m].</summary>
        internal Vector3 BoxSize => size != Vector3.zero ? size : Simulation.DomainSize;

        /// <summary>What is wrong with the fields; null: nothing.</summary>
        internal (string text, string cure)? Problem => DetailRule.Problem(levels, importance, size);

        bool IFluidDetailSource.IsOn => isActiveAndEnabled;

        FluidDetail IFluidDetailSource.Detail =>
            isActiveAndEnabled ? new FluidDetail(this, levels, Math.Min(CurrentLevel, levels.Count)) : default;

        private FluidSimulation Simulation
        {
            get
            {
                if (simulation == null) TryGetComponent(out simulation);
                return simulation;
            }
        }

        /// <summary>The level and why: "detail 2 of 3: 48 m from Main Camera".</summary>
        public string Describe()
        {
            string level = CurrentLevel == 0 ? "all detail" : $"detail {CurrentLevel} of {levels.Count}";
            if (Problem != null) return level + ": its levels cannot be used";
            if (NearestCamera == null) return level + ": no camera";
            bool same = Mathf.Abs(seenFrom - Distance) <= 0.01f * Distance;
            return FormattableString.Invariant($"{level}: {Distance:0.#} m from {NearestCamera.name}") +
                (same ? "" : FormattableString.Invariant($", as large as at {seenFrom:0.#} m"));
        }

        private void OnDisable() => Take(0);

        private void LateUpdate()
        {
            if (Problem is (string text, string cure))
            {
                Report(FluidSeverity.Warning, FluidIssue.DetailInvalid, text + ", so the liquid has all its detail.", cure);
                Take(0);
                return;
            }
            if (TryMeasure()) Take(DetailRule.LevelFor(levels, seenFrom / Reach, CurrentLevel));
            else if (without == Patience) Take(0);
            if (Simulation.IsWatched && ((IFluidDetailSource)this).Detail.Slows)
            {
                Report(FluidSeverity.Info, FluidIssue.DetailLimited,
                    "The liquid is recorded or replayed: meanwhile its level of detail changes only how it is drawn.", "");
            }
            if (Simulation.Domain == FluidDomain.Open && size == Vector3.zero)
            {
                Report(FluidSeverity.Info, FluidIssue.DetailInvalid,
                    "The domain is open and Size is zero, so distances count to the box of its Farthest Distance.",
                    "Give Size the edge lengths of the box where the liquid stays.");
            }
        }

        private bool TryMeasure()
        {
            (Camera nearest, float least) = (null, float.PositiveInfinity);
            DomainPose pose = DomainSpace.FromWorld(transform.position, transform.rotation);
            if (cameras.Count == 0)
            {
                if (found.Length < Camera.allCamerasCount) found = new Camera[Camera.allCamerasCount];
                int count = Camera.GetAllCameras(found);
                for (int i = 0; i < count; i++)
                    if ((found[i].cullingMask & (1 << gameObject.layer)) != 0) Compare(found[i], pose, ref nearest, ref least);
                Array.Clear(found, 0, count);
            }
            foreach (Camera camera in cameras)
                if (camera != null && camera.gameObject.activeInHierarchy) Compare(camera, pose, ref nearest, ref least);
            NearestCamera = nearest;
            without = nearest != null ? 0 : Math.Min(without + 1, Patience);
            if (without == Patience)
            {
                Report(FluidSeverity.Warning, FluidIssue.DetailInvalid, cameras.Count > 0
                    ? "No camera of Cameras is active, so the liquid has all its detail."
                    : "No enabled camera draws the layer of this object, so the liquid has all its detail.",
                    "Enable a camera whose Culling Mask has the layer, or name one in Cameras.");
            }
            if (nearest == null) return false;
            (seenFrom, Distance) = (least, DetailRule.ToBox(pose, BoxSize, nearest.transform.position));
            return true;
        }

        private void Compare(Camera camera, DomainPose pose, ref Camera nearest, ref float least)
        {
            float seen = DetailRule.SeenFrom(camera, DetailRule.ToBox(pose, BoxSize, camera.transform.position));
            if (nearest == null || seen < least) (nearest, least) = (camera, seen);
        }

        private void Take(int level)
        {
            if (level == CurrentLevel) return;
            CurrentLevel = level;
            levelChanged.Invoke(level);
        }

        private void Report(FluidSeverity severity, FluidIssue issue, string text, string cure) =>
            Simulation.Report(new FluidMessage(severity, issue, this, text, cure));
    }
}
