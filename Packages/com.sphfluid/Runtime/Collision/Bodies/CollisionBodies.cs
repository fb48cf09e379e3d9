using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The scene's triangles for methods that prove every motion free: what rests is one body, each collider that has moved is one
    /// of its own. Lists are made anew only when the set of bodies changes; motion changes poses.
    /// </summary>
    internal sealed class CollisionBodies : IDisposable
    {
        static readonly int BodiesId = Shader.PropertyToID("_Bodies");
        static readonly int TrianglesId = Shader.PropertyToID("_BodyTriangles");
        static readonly int CellsId = Shader.PropertyToID("_BodyCells");
        static readonly int ReferencesId = Shader.PropertyToID("_CellTriangles");
        static readonly int PoseStartId = Shader.PropertyToID("_PoseStart");
        static readonly int PartsId = Shader.PropertyToID("_BodyPartsPerMetre");
        static readonly int PoseEndId = Shader.PropertyToID("_PoseEnd");

        // Longer than any motion of a frame that a liquid could follow.
        const float JumpOverReach = 64f;

        readonly float reach;
        readonly Bounds domain;
        readonly Dictionary<Collider, BodyMotion> movers = new Dictionary<Collider, BodyMotion>();
        readonly List<CollisionBody> bodies = new List<CollisionBody>();
        readonly List<BodyMotion> motions = new List<BodyMotion>(); // of the bodies; null for the one at rest
        readonly List<BodyTriangle> triangles = new List<BodyTriangle>();
        readonly List<uint> cells = new List<uint>();
        readonly List<uint> references = new List<uint>();
        readonly HashSet<ColliderState> resting = new HashSet<ColliderState>();
        readonly List<ColliderSolid> lastSolids = new List<ColliderSolid>();
        bool stale;
        GraphicsBuffer bodyBuffer, triangleBuffer, cellBuffer, referenceBuffer;

        /// <param name="supportRadius">R: how far a cell looks [m].</param>
        /// <param name="domainSize">Beyond this no particle is [m].</param>
        public CollisionBodies(float supportRadius, Vector3 domainSize)
        {
            reach = supportRadius;
            domain = new Bounds(Vector3.zero, domainSize);
        }

        /// <summary>Number of bodies.</summary>
        public int Count => bodies.Count;

        /// <summary>Grows whenever the set of bodies was made anew.</summary>
        public int Version { get; private set; }

        /// <summary>Number of triangles.</summary>
        public int TriangleCount => triangles.Count;

        /// <summary>Triangles left out because a corner is not finite. Those without area stay: as edges they close cracks.</summary>
        public int LeftOut { get; private set; }

        /// <summary>Bytes of the GPU buffers.</summary>
        public long Bytes => bodyBuffer == null ? 0 : GpuBuffers.Size(bodyBuffer, triangleBuffer, cellBuffer, referenceBuffer);

        /// <summary>Whether a body still has a way to go: its motion of the frame was not stepped through.</summary>
        public bool IsUnderWay { get; private set; }

        /// <summary>Times a body jumped farther than a motion is followed, since the start; it was put there at once.</summary>
        public int Jumps { get; private set; }

        /// <summary>
        /// Takes over where the colliders are now, once a frame. The motion from where the last steps left them is the next steps';
        /// frames without a step join into one motion.
        /// </summary>
        /// <param name="solids">Colliders that take part.</param>
        public void Update(IReadOnlyList<ColliderSolid> solids)
        {
            if (Follow(solids)) Rebuild(solids);
            bool wasUnderWay = IsUnderWay;
            IsUnderWay = false;
            for (int i = 0; i < bodies.Count; i++)
            {
                if (motions[i] == null) continue;
                if (motions[i].LongestWay(bodies[i].BoundsMin, bodies[i].BoundsMax) > JumpOverReach * reach)
                {
                    Jumps++;
                    motions[i].Arrive();
                }
                IsUnderWay |= !motions[i].IsAtRest;
            }
            if (IsUnderWay || wasUnderWay || stale) UploadBodies();
        }

        /// <summary>The motion was stepped through: bodies rest at its end.</summary>
        public void Arrive()
        {
            if (!IsUnderWay) return;
            IsUnderWay = false;
            stale = true; // the buffer is read by commands yet to run; at fraction 1 it is right
            foreach (BodyMotion motion in motions) motion?.Arrive();
        }

        /// <summary>Records the globals of Shaders/Collision/Bodies.hlsl.</summary>
        /// <param name="cmd">Command buffer.</param>
        /// <param name="kernel">Kernel.</param>
        /// <param name="start">Where the step begins in the frame's motion, 0 to 1.</param>
        /// <param name="end">Where it ends.</param>
        public void Bind(CommandBuffer cmd, ComputeKernel kernel, float start, float end)
        {
            kernel.SetFloat(cmd, PoseStartId, start);
            kernel.SetFloat(cmd, PoseEndId, end);
            kernel.SetFloat(cmd, PartsId, 1f / (1.7f * reach));
            kernel.SetBuffer(cmd, BodiesId, bodyBuffer);
            kernel.SetBuffer(cmd, TrianglesId, triangleBuffer);
            kernel.SetBuffer(cmd, CellsId, cellBuffer);
            kernel.SetBuffer(cmd, ReferencesId, referenceBuffer);
        }

        public void Dispose()
        {
            GpuBuffers.Dispose(ref bodyBuffer);
            GpuBuffers.Dispose(ref triangleBuffer);
            GpuBuffers.Dispose(ref cellBuffer);
            GpuBuffers.Dispose(ref referenceBuffer);
        }

        // Whether the set of bodies changed. A collider that rested and is elsewhere now becomes a body of its own for good.
        bool Follow(IReadOnlyList<ColliderSolid> solids)
        {
            if (IsSame(solids)) return false;
            bool changed = false;
            var present = new HashSet<Collider>();
            foreach (ColliderSolid solid in solids)
            {
                Collider collider = solid.State.Collider;
                present.Add(collider);
                if (movers.TryGetValue(collider, out BodyMotion motion))
                {
                    if (motion.MoveTo(solid.State)) continue;
                    movers[collider] = new BodyMotion(solid);
                    changed = true;
                }
                else if (!resting.Contains(solid.State))
                {
                    changed = true;
                    ColliderSolid before = lastSolids.Find(s => ReferenceEquals(s.State.Collider, collider));
                    if (before == null) continue;
                    motion = new BodyMotion(before);
                    movers[collider] = motion.MoveTo(solid.State) ? motion : new BodyMotion(solid);
                }
            }
            foreach (ColliderSolid solid in lastSolids)
            {
                if (present.Contains(solid.State.Collider)) continue;
                movers.Remove(solid.State.Collider);
                changed = true;
            }
            lastSolids.Clear();
            lastSolids.AddRange(solids);
            return changed;
        }

        bool IsSame(IReadOnlyList<ColliderSolid> solids)
        {
            if (solids.Count != lastSolids.Count) return false;
            for (int i = 0; i < solids.Count; i++)
                if (!ReferenceEquals(solids[i], lastSolids[i])) return false;
            return true;
        }

        void Rebuild(IReadOnlyList<ColliderSolid> solids)
        {
            bodies.Clear();
            motions.Clear();
            triangles.Clear();
            cells.Clear();
            references.Clear();
            resting.Clear();
            LeftOut = 0;
            int first = 0;
            foreach (ColliderSolid solid in solids)
            {
                if (movers.ContainsKey(solid.State.Collider)) continue;
                resting.Add(solid.State);
                AddTriangles(solid.Mesh, true);
            }
            AddBody(first, null);
            foreach (ColliderSolid solid in solids)
            {
                if (!movers.TryGetValue(solid.State.Collider, out BodyMotion motion)) continue;
                first = triangles.Count;
                AddTriangles(motion.Solid.Mesh, false);
                AddBody(first, motion);
            }
            stale = true;
            Version++;
            if (bodies.Count == 0) return;
            Upload(ref triangleBuffer, "BodyTriangles", triangles.ToArray(), BodyTriangle.Stride);
            Upload(ref cellBuffer, "BodyCells", cells.ToArray(), sizeof(uint));
            Upload(ref referenceBuffer, "CellTriangles", references.ToArray(), sizeof(uint));
        }

        void AddTriangles(TriangleMesh mesh, bool atRest)
        {
            Vector3 half = domain.extents + reach * Vector3.one;
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                if (!AffineMath.IsFinite(a) || !AffineMath.IsFinite(b) || !AffineMath.IsFinite(c)) LeftOut++;
                else if (!atRest || TriangleMath.MayOverlap(Vector3.zero, half, a, b, c)) triangles.Add(BodyTriangle.Of(a, b, c));
            }
        }

        void AddBody(int first, BodyMotion motion)
        {
            int count = triangles.Count - first;
            if (count == 0) return;
            var grid = new BodyGrid(triangles, first, count, reach, motion == null ? domain : (Bounds?)null);
            bodies.Add(new CollisionBody
            {
                Rotation0 = Quaternion.identity,
                Rotation1 = Quaternion.identity,
                FirstCell = (uint)cells.Count,
                Flags = motion != null ? CollisionBody.Moves : 0u,
                GridOrigin = grid.Origin,
                CellSide = grid.Side,
                GridCounts = grid.Counts,
                BoundsMin = grid.BoundsMin,
                BoundsMax = grid.BoundsMax,
            });
            motions.Add(motion);
            uint offset = (uint)references.Count;
            foreach (uint start in grid.Starts) cells.Add(start + offset);
            references.AddRange(grid.References);
        }

        void UploadBodies()
        {
            stale = false;
            for (int i = 0; i < bodies.Count; i++)
            {
                CollisionBody body = bodies[i];
                body.BodyCount = (uint)bodies.Count;
                if (motions[i] != null)
                {
                    body.Rotation0 = motions[i].Rotation0;
                    body.Position0 = motions[i].Position0;
                    body.Rotation1 = motions[i].Rotation1;
                    body.Position1 = motions[i].Position1;
                }
                bodies[i] = body;
            }
            if (bodies.Count > 0) Upload(ref bodyBuffer, "Bodies", bodies.ToArray(), CollisionBody.Stride);
        }

        static void Upload<T>(ref GraphicsBuffer buffer, string name, T[] data, int stride) where T : struct
        {
            if (buffer == null || buffer.count < data.Length)
            {
                GpuBuffers.Dispose(ref buffer);
                buffer = GpuBuffers.Create(name, data.Length, stride);
            }
            if (data.Length > 0) buffer.SetData(data);
        }
    }
}
