using System;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid
{
    /// <summary>How bad a <see cref="FluidMessage"/> is.</summary>
    public enum FluidSeverity
    {
        /// <summary>Something worth knowing; nothing is wrong.</summary>
        Info,

        /// <summary>The simulation runs, but not as its settings say.</summary>
        Warning,

        /// <summary>The simulation cannot run.</summary>
        Error,
    }

    /// <summary>What a <see cref="FluidMessage"/> is about: stable names for tests, tools and the inspector's fix buttons.</summary>
    public enum FluidIssue
    {
        /// <summary>No profile is assigned.</summary>
        ProfileMissing,
        /// <summary>The profile has no shader set, or the set has empty entries.</summary>
        ShadersMissing,
        /// <summary>The device does not offer something that the simulation needs.</summary>
        DeviceUnsupported,
        /// <summary>The domain size is zero, negative or not a number.</summary>
        DomainSizeInvalid,
        /// <summary>The particle spacing is zero, negative, not a number or too coarse for the domain.</summary>
        SpacingInvalid,
        /// <summary>The fixed time step is zero, negative, not a number or above the stability limit.</summary>
        TimeStepInvalid,
        /// <summary>Gravity is not a number.</summary>
        GravityInvalid,
        /// <summary>The simulation's transform has a scale other than one.</summary>
        TransformScaled,
        /// <summary>No liquid volume belongs to the domain.</summary>
        NoLiquid,
        /// <summary>A liquid volume has a zero, negative or non-finite size, or a transform that flattens it.</summary>
        VolumeSizeInvalid,
        /// <summary>A liquid volume lies wholly or partly outside its domain.</summary>
        VolumeOutsideDomain,
        /// <summary>A liquid volume overlaps a collider.</summary>
        VolumeInsideCollider,
        /// <summary>Liquid volumes overlap each other.</summary>
        VolumesOverlap,
        /// <summary>The volumes hold more particles than allowed.</summary>
        TooManyParticles,
        /// <summary>The domain has more cells of the neighbour search than allowed.</summary>
        TooManyCells,
        /// <summary>A MeshCollider's mesh cannot be read.</summary>
        MeshNotReadable,
        /// <summary>A MeshCollider has no mesh, or one without triangles.</summary>
        MeshEmpty,
        /// <summary>A collider's transform flattens it.</summary>
        ColliderTransformSingular,
        /// <summary>A collider's mesh holds triangles without area.</summary>
        DegenerateTriangles,
        /// <summary>A collider of a kind that has no triangles.</summary>
        ColliderUnsupported,
        /// <summary>A collider has a friction of its own, which the method does not know.</summary>
        ColliderFrictionUnused,
        /// <summary>A collider ends at a periodic face, behind which it is not repeated.</summary>
        ColliderAtPeriodicFace,
        /// <summary>The colliders hold more triangles than the device's buffer.</summary>
        TooManyTriangles,
        /// <summary>The simulation falls behind real time: it reached the substep cap.</summary>
        SubstepCap,
        /// <summary>The solver's guards acted: accelerations limited, particles put back, or non-finite values.</summary>
        GuardActed,
        /// <summary>
        /// The faces of the domain are set to something that cannot be: a periodic axis that is too short, a wall that moves across its
        /// plane.
        /// </summary>
        BoundariesInvalid,
        /// <summary>A detector of the diagnostics saw a failure.</summary>
        Diagnosis,
        /// <summary>The simulation could not start for a reason that only the attempt showed.</summary>
        StartFailed,
        /// <summary>A liquid volume's mesh is missing, open or cannot be read.</summary>
        VolumeMeshInvalid,
        /// <summary>Liquid runs out of the vessel that a liquid volume fills.</summary>
        VesselLeaks,
        /// <summary>How the liquid was brought to rest before the start, or that it was not.</summary>
        StartRelaxation,
        /// <summary>The simulation is a prefab asset, so its liquid and its colliders cannot be checked.</summary>
        PrefabAsset,
        /// <summary>No component draws the liquid.</summary>
        NotDrawn,
        /// <summary>A collider changed its place or shape so that liquid could not follow, and was put at its new place at once.</summary>
        ColliderJumped,
        /// <summary>The method is none that this version of the package has.</summary>
        MethodUnknown,
        /// <summary>A force zone cannot do what it is set to.</summary>
        ForceZoneInvalid,
        /// <summary>An emitter or a drain cannot do what it is set to.</summary>
        EmitterInvalid,
        /// <summary>Liquid, or a face of the domain, is where an emitter would put particles.</summary>
        EmitterBlocked,
        /// <summary>The liquid has as many particles as it may have, so that the oldest leave or nothing more comes in.</summary>
        CapacityReached,
        /// <summary>The liquid's buffers were made larger for more particles.</summary>
        CapacityGrown,
        /// <summary>The time scale of a simulation is negative or not a number.</summary>
        TimeScaleInvalid,
        /// <summary>The device or the shader set cannot answer queries; the liquid runs without.</summary>
        QueriesUnavailable,
        /// <summary>More rigid bodies are in the liquid than it can move.</summary>
        TooManyBodies,
        /// <summary>A save cannot be restored.</summary>
        SaveInvalid,
        /// <summary>A restored save was made on another device, or in a scene with other objects.</summary>
        SaveDiffers,
        /// <summary>
        /// A liquid volume was enabled, disabled, moved or changed while the liquid runs, and that adds or moves no liquid.
        /// </summary>
        VolumeChanged,

        /// <summary>The liquid makes more whitewater than its limit.</summary>
        WhitewaterFull,

        /// <summary>An instrument cannot read what it is set to.</summary>
        InstrumentInvalid,

        /// <summary>Which method Automatic picked and why, or what keeps it from picking one that fits.</summary>
        MethodChoice,

        /// <summary>Something of a liquid that the engine which it is exported to cannot express.</summary>
        NotExported,

        /// <summary>A sequence of particle files cannot be played.</summary>
        PlaybackInvalid,

        /// <summary>A file of a sequence is missing, cut or altered, so that its frame is not shown.</summary>
        PlaybackFrame,

        /// <summary>
        /// A sequence is of another liquid than the simulation's settings say, or something in the scene does nothing while it is played.
        /// </summary>
        PlaybackDiffers,

        /// <summary>A rigid body is smaller or lighter than the liquid's particles can move as it should float.</summary>
        BodyTooSmall,

        /// <summary>Particles of a sequence are outside of the domain, or not numbers, and are left out.</summary>
        PlaybackOutside,

        /// <summary>A clip of a Timeline has no playback whose time it could set.</summary>
        PlaybackClipUnbound,

        /// <summary>Something drives or presses the liquid more than its constants are made for.</summary>
        LiquidTooSoft,

        /// <summary>An emitter is to give another liquid than its simulation holds.</summary>
        LiquidsDiffer,

        /// <summary>A simulation moves or looks otherwise than its liquid does.</summary>
        LiquidOverridden,

        /// <summary>A liquid volume is drawn out to walls of its domain that it nearly reaches.</summary>
        VolumeDrawnOut,

        /// <summary>Liquid of an open domain went farther than its farthest distance, and was removed.</summary>
        FarthestReached,

        /// <summary>Parts of a liquid are to sleep, and its method, its forces or another setting keep all of it awake.</summary>
        PartsStayAwake,

        /// <summary>Levels of detail have numbers that cannot be used, or no camera to count distances from.</summary>
        DetailInvalid,

        /// <summary>A level of detail asks for more than the method, the steps or the surface can take.</summary>
        DetailLimited,
    }

    /// <summary>
    /// One message to the user: which object, what is wrong and what to do about it. Shown by the inspector, the console and tests.
    /// </summary>
    public readonly struct FluidMessage : IEquatable<FluidMessage>
    {
        /// <summary>Prefix of every console line of this package.</summary>
        public const string Prefix = "[SPH Fluid]";

        private const int LongestName = 100, LongestText = 2000;

        /// <summary>A message about <paramref name="context"/>.</summary>
        /// <param name="severity">How bad it is.</param>
        /// <param name="issue">What it is about.</param>
        /// <param name="context">Object it is about; may be null.</param>
        /// <param name="text">What is wrong, without the object's name, as a full sentence.</param>
        /// <param name="cure">What to do, as a full sentence; may be empty.</param>
        public FluidMessage(FluidSeverity severity, FluidIssue issue, Object context, string text, string cure)
        {
            Severity = severity;
            Issue = issue;
            Context = context;
            Source = context != null ? context.name : "SPH Fluid";
            Text = text ?? throw new ArgumentNullException(nameof(text));
            Cure = cure ?? "";
        }

        /// <summary>How bad it is.</summary>
        public FluidSeverity Severity { get; }

        /// <summary>What it is about.</summary>
        public FluidIssue Issue { get; }

        /// <summary>Object it is about; null when there is none or it was destroyed since.</summary>
        public Object Context { get; }

        /// <summary>Name of the object at the time of the message.</summary>
        public string Source { get; }

        /// <summary>What is wrong.</summary>
        public string Text { get; }

        /// <summary>What to do about it; empty when nothing needs doing.</summary>
        public string Cure { get; }

        /// <summary>Writes the message to Unity's console under its severity, with the object selectable.</summary>
        public void Log()
        {
            switch (Severity)
            {
                case FluidSeverity.Error: Debug.LogError(ToString(), Context); break;
                case FluidSeverity.Warning: Debug.LogWarning(ToString(), Context); break;
                default: Debug.Log(ToString(), Context); break;
            }
        }

        /// <summary>The console line: prefix, object's name, what is wrong, cure. It stays one line whatever names it has in it.</summary>
        public override string ToString() =>
            $"{Prefix} '{OneLine(Source, LongestName)}': " +
            $"{OneLine(Text, LongestText)}{(Cure.Length == 0 ? "" : " ")}{OneLine(Cure, LongestText)}";

        private static string OneLine(string text, int most)
        {
            char[] letters = text.ToCharArray(0, Math.Min(text.Length, most));
            for (int i = 0; i < letters.Length; i++)
                if (char.IsControl(letters[i])) letters[i] = ' ';
            return new string(letters) + (text.Length > most ? "…" : "");
        }

        /// <summary>Edge lengths as messages show them.</summary>
        internal static string Lengths(Vector3 v) => FormattableString.Invariant($"{v.x:0.####} × {v.y:0.####} × {v.z:0.####}");

        /// <inheritdoc/>
        public bool Equals(FluidMessage other) =>
            Severity == other.Severity && Issue == other.Issue && ReferenceEquals(Context, other.Context) &&
            Source == other.Source && Text == other.Text && Cure == other.Cure;

        /// <inheritdoc/>
        public override bool Equals(object obj) => obj is FluidMessage other && Equals(other);

        /// <inheritdoc/>
        public override int GetHashCode() => HashCode.Combine(Severity, Issue, Source, Text);
    }
}
