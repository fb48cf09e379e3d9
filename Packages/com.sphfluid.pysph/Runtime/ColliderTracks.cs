using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The colliders of a liquid and their motion while the scene plays; what of it PySPH cannot follow is reported once.
    /// </summary>
    internal sealed class ColliderTracks : IDisposable
    {
        // Over the spacing: less is no motion.
        private const float StillTolerance = 1e-3f;

        private readonly List<Track> tracks = new List<Track>();
        private readonly Dictionary<object, Track> known = new Dictionary<object, Track>();
        private readonly HashSet<object> late = new HashSet<object>();
        private readonly Action<FluidMessage> report;

        /// <param name="collision">Colliders of the start, gathered; taken over.</param>
        /// <param name="report">Receives what cannot be followed.</param>
        public ColliderTracks(CollisionScene collision, Action<FluidMessage> report)
        {
            Scene = collision;
            this.report = report;
            foreach (FluidObstacle solid in collision.Solids) Begin(solid);
        }

        /// <summary>The colliders as they are now.</summary>
        public CollisionScene Scene { get; }

        /// <summary>Those of the start that stay, in hierarchy order.</summary>
        public IEnumerable<FluidObstacle> Still
        {
            get
            {
                foreach (Track track in tracks)
                    if (!Moves(track)) yield return track.Solid;
            }
        }

        /// <summary>Those of the start that move.</summary>
        public IEnumerable<(FluidObstacle solid, BodyPath path)> Moving
        {
            get
            {
                foreach (Track track in tracks)
                    if (Moves(track)) yield return (track.Solid, track.Path);
            }
        }

        /// <summary>Looks where the colliders are.</summary>
        /// <param name="spec">The simulation as it is now.</param>
        /// <param name="time">Time since the start [s].</param>
        public void Note(in FluidSpec spec, double time)
        {
            if (Scene.Gather(spec.Query()))
                foreach (FluidMessage message in Scene.Messages) report(message);
            foreach (Track track in tracks) track.IsPresent = false;
            foreach (FluidObstacle solid in Scene.Solids)
            {
                if (known.TryGetValue(solid.State.Key, out Track track)) Follow(track, solid, time);
                else if (late.Add(solid.State.Key)) Report(solid, "comes into the domain after the export's start and is not exported.",
                    "Let it be in the domain from the start.");
            }
            foreach (Track track in tracks)
                if (!track.IsPresent) Leave(track, time);
        }

        /// <inheritdoc/>
        public void Dispose() => Scene.Dispose();

        private void Begin(FluidObstacle solid)
        {
            var track = new Track { Solid = solid, Path = new BodyPath(solid.State.ToSimulation), Floats = IsFloating(solid.Collider) };
            tracks.Add(track);
            known[solid.State.Key] = track;
            if (track.Floats)
            {
                Report(solid, "is moved by the liquid, which PySPH's schemes for free surfaces do not do: it stays where it starts.",
                    "Make its Rigidbody kinematic to export the motion that the scene gives it.");
            }
            if (solid.Source is SkinnedMeshRenderer)
            {
                Report(solid, "is a skinned mesh, whose bending is not exported: it moves rigidly, in its shape at the start.", "");
            }
            if (!solid.Mesh.IsClosed)
            {
                Report(solid, "is an open mesh: PySPH gets it as a sheet of particles, which fast liquid can cross.",
                    "Use a closed mesh, or a Box Collider that is thicker than three particle spacings.");
            }
        }

        private void Follow(Track track, FluidObstacle solid, double time)
        {
            track.IsPresent = true;
            if (track.Floats)
            {
                track.Path.Stay(time);
                return;
            }
            bool shaped = solid.State.HasShapeOf(track.Solid.State) || solid.Source is SkinnedMeshRenderer;
            if (track.Path.TryAdd(time, solid.State.ToSimulation) && shaped) return;
            if (track.Path.Poses[track.Path.Poses.Count - 1].Time < time) track.Path.Stay(time);
            if (track.ChangesShape) return;
            track.ChangesShape = true;
            Report(solid, "changes its size or shape, which is not exported: it keeps those of the start.", "");
        }

        private void Leave(Track track, double time)
        {
            track.Path.Stay(time);
            if (track.Left) return;
            track.Left = true;
            Report(track.Solid, "leaves the domain or is switched off, which is not exported: it stays where it was last.", "");
        }

        private static bool Moves(Track track) => track.Path.Moves(StillTolerance * track.Solid.Spacing);

        private static bool IsFloating(Collider collider) => collider != null && RigidbodyFloat.Moves(collider.attachedRigidbody) &&
            !WheelDiscs.IsWheel(collider) &&
            ColliderSettings.Find(collider)?.MovedByLiquid != false;

        // Sentences begin with what the collider is.
        private void Report(FluidObstacle solid, string text, string cure) => report(new FluidMessage(
            FluidSeverity.Warning, FluidIssue.NotExported, solid.Source,
            $"The {(solid.Collider != null ? "collider" : "wall")} {text}", cure));

        private sealed class Track
        {
            public FluidObstacle Solid;
            public BodyPath Path;
            public bool Floats, IsPresent, ChangesShape, Left;
        }
    }
}
