using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The scene's triangles for methods that prove every motion free: what rests and has the same friction is one body, each collider that
    /// has moved is one of its own. Lists are made anew only when the set of bodies changes; motion changes poses. Only those of bodies
    /// that deform are made anew in each frame in which they do.
    /// </summary>
    internal sealed class CollisionBodies : IDisposable
    {
        private static readonly int BodiesId = Shader.PropertyToID("_Bodies");
        private static readonly int BodiesOutId = Shader.PropertyToID("_BodiesOut");
        private static readonly int PoseStartId = Shader.PropertyToID("_PoseStart");
        private static readonly int PoseEndId = Shader.PropertyToID("_PoseEnd");

        private const string StretchKeyword = "FLUID_STRETCHED_BODIES";

        // Longer than any motion of a frame that a liquid could follow.
        private const float JumpOverReach = 64f;

        // BODY_MOST_PARTS of Shaders/Collision/Bodies.hlsl for stretched bodies.
        private const double MostParts = 256.0;

        private readonly float reach;
        private readonly float longestStep; // of a particle, m
        private readonly Bounds domain; // beyond it no particle is in a step
        private readonly BodyGeometry geometry;
        private readonly List<CollisionBody> bodies = new List<CollisionBody>();
        private readonly List<BodyMotion> motions = new List<BodyMotion>(); // of the bodies; null for those at rest
        private readonly MovingColliders moving = new MovingColliders();
        private int firstDeforming; // of bodies: from it on they deform
        private bool stale;
        private GraphicsBuffer bodyBuffer;

        /// <summary>No bodies yet.</summary>
        /// <param name="settings">The liquid's: cells look as far as its support radius, particles are in its domain.</param>
        public CollisionBodies(in FluidSolverSettings settings)
        {
            reach = settings.SupportRadius;
            longestStep = ContactDistances.LongestDisplacement(settings);
            domain = new Bounds(Vector3.zero, settings.DomainSize + 2f * BeyondFaces(settings));
            geometry = new BodyGeometry(reach);
            Floating = new FloatingBodies(settings);
        }

        /// <summary>Number of bodies.</summary>
        public int Count => bodies.Count;

        /// <summary>
        /// Grows whenever the set of bodies was made anew or one of them jumped: what was found of walls does not hold any more.
        /// </summary>
        public int Version { get; private set; }

        /// <summary>Whether a body has a friction of its own that is not zero.</summary>
        public bool HoldLiquid { get; private set; }

        /// <summary>Those that the liquid moves.</summary>
        public FloatingBodies Floating { get; }

        /// <summary>Number of triangles.</summary>
        public int TriangleCount => geometry.TriangleCount;

        /// <summary>Triangles left out because a corner is not finite.</summary>
        public int LeftOut => geometry.LeftOut;

        /// <summary>Bytes of the GPU buffers.</summary>
        public long Bytes => GpuBuffers.Size(bodyBuffer) + geometry.Bytes + Floating.Bytes;

        /// <summary>
        /// Bytes that colliders at rest take on the GPU, and how many bodies they are; instead of the first update, for a look ahead.
        /// </summary>
        public (long bytes, int bodies) Plan(IReadOnlyList<FluidObstacle> solids)
        {
            Collect(solids);
            return bodies.Count == 0 ? (0L, 0)
                : (geometry.PlannedBytes + GpuBuffers.BytesOf(bodies.Count, CollisionBody.Stride), bodies.Count);
        }

        /// <summary>Whether a body is still moving: the steps have not gone through all of its motion of the frame.</summary>
        public bool IsUnderWay { get; private set; }

        /// <summary>
        /// Farthest that a point of a body goes in the motion of the frame where liquid can be, or of a corner of its box [m].
        /// </summary>
        public float LongestMotion { get; private set; }

        /// <summary>Times a body's motion could not be followed, since the start; it was put at its new place at once.</summary>
        public int Jumps => moving.Jumps;

        /// <summary>Those of the last update.</summary>
        public IReadOnlyList<BodyJump> NewJumps => moving.NewJumps;

        /// <summary>Whether the triangles of a body change in its rigid frame: it is scaled or sheared, or it deforms.</summary>
        public bool HasStretch { get; private set; }

        /// <summary>
        /// Takes over where the colliders are now, once a frame. The motion from where the last steps left them is the next steps';
        /// frames without a step join into one motion.
        /// </summary>
        /// <param name="solids">Colliders that take part.</param>
        public void Update(IReadOnlyList<FluidObstacle> solids)
        {
            bool outgrown = moving.Track(solids) | moving.Settle();
            stale |= moving.FrictionChanged;
            if (outgrown) Rebuild(solids);
            else if (motions.Exists(m => m?.Deformation != null && m.Deformation.IsChanged)) Deform(solids);
            bool wasUnderWay = IsUnderWay;
            IsUnderWay = HasStretch = false;
            LongestMotion = 0f;
            bool deformed = false;
            for (int i = 0; i < bodies.Count; i++)
            {
                if (motions[i] == null) continue;
                if (IsTooFar(motions[i], bodies[i]))
                {
                    moving.Jump(motions[i].Source, BodyFollowing.TooFar);
                    motions[i].Arrive();
                    motions[i].Floats?.Seed();
                    deformed |= motions[i].Deformation != null;
                    stale = true;
                    Version++;
                }
                IsUnderWay |= !motions[i].IsAtRest;
                if (!motions[i].IsAtRest)
                {
                    LongestMotion = Mathf.Max(LongestMotion,
                        Mathf.Min(motions[i].LongestDisplacement(bodies[i].BoundsMin, bodies[i].BoundsMax),
                            motions[i].LongestWithin(domain, reach)));
                }
                HasStretch |= motions[i].IsStretched || motions[i].Deformation != null;
            }
            if (deformed) Deform(solids); // the steps of other bodies must not take it there
            Floating.Update(motions);
            IsUnderWay |= Floating.Count > 0; // where they go only the GPU knows
            if (IsUnderWay || wasUnderWay || stale) UploadBodies();
        }

        /// <summary>The motion was stepped through: bodies rest at its end.</summary>
        public void Arrive()
        {
            if (!IsUnderWay) return;
            IsUnderWay = false;
            stale = true; // the buffer is read by commands yet to run; at fraction 1 it is right
            foreach (BodyMotion motion in motions) motion?.Arrive();
            Floating.Arrive();
        }

        /// <summary>A body in a message.</summary>
        /// <param name="number">Its number from 1 on; 0: none.</param>
        public string NameOf(uint number)
        {
            if (number == 0u) return "itself or a face of the domain";
            BodyMotion motion = number <= motions.Count ? motions[(int)number - 1] : null;
            return motion == null ? "a collider at rest" : $"'{motion.Name}'";
        }

        /// <summary>Place among the bodies of a collider's motion; −1: it has no triangles in the domain.</summary>
        public int PlaceOf(BodyMotion motion) => motions.IndexOf(motion);

        /// <summary>The motion of a collider that moves; null: it rests, or there is none.</summary>
        /// <param name="key">Of the collider's state.</param>
        public BodyMotion MotionOf(object key) => moving.MotionOf(key);

        /// <summary>Records the bodies for a kernel that moves them.</summary>
        public void SetOut(CommandBuffer cmd, ComputeKernel kernel) => kernel.SetBuffer(cmd, BodiesOutId, bodyBuffer);

        /// <summary>Records the globals of Shaders/Collision/Bodies.hlsl.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">Kernel.</param>
        /// <param name="start">Where the step begins in the frame's motion, 0 to 1.</param>
        /// <param name="end">Where it ends.</param>
        public void Bind(CommandBuffer cmd, ComputeKernel kernel, float start, float end)
        {
            kernel.SetFloat(cmd, PoseStartId, start);
            kernel.SetFloat(cmd, PoseEndId, end);
            if (kernel.HasKeyword(StretchKeyword)) kernel.SetKeyword(cmd, StretchKeyword, HasStretch); // others take all as stretched
            kernel.SetBuffer(cmd, BodiesId, bodyBuffer);
            geometry.Bind(cmd, kernel);
        }

        public void Dispose()
        {
            GpuBuffers.Dispose(ref bodyBuffer);
            geometry.Dispose();
            Floating.Dispose();
        }

        /// <summary>
        /// Writes where the last steps left each collider, which of them are bodies of their own, and the corners of those that deform.
        /// </summary>
        public void Save(SaveWriter writer) => moving.Save(writer);

        /// <summary>
        /// Goes on from a save: colliders move from where they were then to where they are. Triangles rest where they were then.
        /// </summary>
        /// <param name="reader">The save.</param>
        /// <param name="scene">The colliders as they are now.</param>
        public void Load(SaveReader reader, CollisionScene scene)
        {
            moving.Load(reader, scene);
            Rebuild(moving.LastSolids);
        }

        // Also where a particle's line in the frame of the triangles bends more than the parts follow that it is looked up in.
        private bool IsTooFar(BodyMotion motion, in CollisionBody body)
        {
            float displacement = motion.LongestDisplacement(body.BoundsMin, body.BoundsMax);
            if (displacement > JumpOverReach * reach) return true;
            if (!motion.IsStretched) return false;
            return (displacement + longestStep) / motion.FrameRange().least * PartsPerMetre(motion) > MostParts - 1.0;
        }

        private void Rebuild(IReadOnlyList<FluidObstacle> solids)
        {
            Collect(solids);
            stale = true;
            Version++;
            if (bodies.Count > 0) geometry.Upload();
        }

        private void Collect(IReadOnlyList<FluidObstacle> solids)
        {
            bodies.Clear();
            motions.Clear();
            geometry.Clear();
            foreach (IGrouping<float, FluidObstacle> alike in moving.TakeResting(solids))
            {
                foreach (FluidObstacle solid in alike) geometry.Add(solid.Mesh, domain);
                AddBody(null, alike.Key);
            }
            foreach (BodyMotion motion in moving.GetMotions(solids, false))
            {
                geometry.Add(motion.Mesh, null);
                AddBody(motion, motion.Friction);
            }
            firstDeforming = bodies.Count;
            geometry.BeginDeforming();
            AddDeforming(solids);
        }

        // Triangles and lists of what deforms, where there is room for them in the buffers.
        private void Deform(IReadOnlyList<FluidObstacle> solids)
        {
            bodies.RemoveRange(firstDeforming, bodies.Count - firstDeforming);
            motions.RemoveRange(firstDeforming, motions.Count - firstDeforming);
            geometry.RestartDeforming();
            AddDeforming(solids);
            stale = true;
            if (!geometry.TryUploadDeforming()) Rebuild(solids);
        }

        private void AddDeforming(IReadOnlyList<FluidObstacle> solids)
        {
            foreach (BodyMotion motion in moving.GetMotions(solids, true))
            {
                geometry.AddDeforming(motion.Deformation.Start, motion.Deformation.End);
                motion.Deformation.IsChanged = false;
                AddBody(motion, motion.Friction);
            }
        }

        private void AddBody(BodyMotion motion, float friction)
        {
            float least = (float)(motion?.CellStretch ?? 1.0);
            if (!geometry.TryEndBody(motion == null ? domain : (Bounds?)null, least, out CollisionBody body)) return;
            body.Flags = motion != null ? CollisionBody.Moves : 0u;
            body.Friction = friction;
            bodies.Add(body);
            motions.Add(motion);
        }

        private void UploadBodies()
        {
            stale = false;
            for (int i = 0; i < bodies.Count; i++)
            {
                CollisionBody body = bodies[i];
                body.BodyCount = (uint)bodies.Count;
                if (motions[i] != null)
                {
                    body.Friction = motions[i].Friction;
                    body.Rotation0 = motions[i].Rotation0;
                    body.Position0 = motions[i].Position0;
                    body.Rotation1 = motions[i].Rotation1;
                    body.Position1 = motions[i].Position1;
                    body.StretchDiagonal0 = motions[i].Stretch0.Diagonal;
                    body.StretchShear0 = motions[i].Stretch0.Shear;
                    body.StretchDiagonal1 = motions[i].Stretch1.Diagonal;
                    body.StretchShear1 = motions[i].Stretch1.Shear;
                    body.PartsPerMetre = PartsPerMetre(motions[i]);
                    body.Flags = CollisionBody.Moves | (motions[i].IsStretched ? CollisionBody.Stretches : 0u) |
                        Floating.NumberOf(motions[i].Floats) << CollisionBody.NumberShift;
                }
                bodies[i] = body;
            }
            HoldLiquid = bodies.Exists(b => b.Friction > 0f);
            if (bodies.Count == 0) return;
            GpuBuffers.Reserve(ref bodyBuffer, "Bodies", bodies.Count, CollisionBody.Stride);
            bodyBuffer.SetData(bodies);
        }

        // A cell looks a distance beyond itself, and a part of a displacement is looked up from its middle.
        private float PartsPerMetre(BodyMotion motion) => (float)motion.SpanRatio / (1.7f * (reach / (float)motion.CellStretch));

        // A step may leave a periodic face before it is brought in at the other.
        private static Vector3 BeyondFaces(in FluidSolverSettings settings)
        {
            Vector3 period = settings.PeriodLength;
            float displacement = ContactDistances.LongestDisplacement(settings);
            return new Vector3(period.x > 0f ? displacement : 0f, period.y > 0f ? displacement : 0f, period.z > 0f ? displacement : 0f);
        }
    }
}
