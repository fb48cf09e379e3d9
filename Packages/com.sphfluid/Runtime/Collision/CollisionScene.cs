using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The scene's colliders as triangles in simulation space, on the CPU and the GPU. Colliders need no wiring: those in
    /// the domain are found by layer, and triangles are made and uploaded again only when one came, went, moved or changed.
    /// </summary>
    internal sealed class CollisionScene : IDisposable
    {
        private const int MostNames = 3;

        private readonly ColliderFinder finder;
        private readonly SkinnedWalls skins = new SkinnedWalls();
        private readonly ColliderTriangles maker;
        private readonly List<FluidMessage> messages = new List<FluidMessage>();
        private readonly List<FluidObstacle> solids = new List<FluidObstacle>();
        private readonly Dictionary<object, FluidObstacle> known = new Dictionary<object, FluidObstacle>();
        private readonly List<CollisionTriangle> triangles = new List<CollisionTriangle>();
        private readonly List<CollisionCollider> colliders = new List<CollisionCollider>();
        private readonly CollisionBuffers buffers = new CollisionBuffers();

        private JoinedSolids joined; // made when it is asked for

        /// <summary>Nothing found yet.</summary>
        public CollisionScene()
        {
            finder = new ColliderFinder(States, skins);
            maker = new ColliderTriangles(States.Meshes);
        }

        /// <summary>Whose rigid bodies the liquid moves; null: nobody's.</summary>
        public IFloatingOwners Owners { set => finder.Owners = value; }

        /// <summary>Makes the states of colliders.</summary>
        public ColliderStates States { get; } = new ColliderStates();

        /// <summary>Why colliders were left out or changed, as of the last update.</summary>
        public IReadOnlyList<FluidMessage> Messages => messages;

        /// <summary>Colliders that take part, with all their triangles.</summary>
        public IReadOnlyList<FluidObstacle> Solids => solids;

        /// <summary>Triangles that intersect the domain, in the order of the GPU buffer.</summary>
        public IReadOnlyList<CollisionTriangle> Triangles => triangles;

        /// <summary>Ranges of <see cref="Triangles"/>, one a collider.</summary>
        public IReadOnlyList<CollisionCollider> Colliders => colliders;

        /// <summary>GPU copy of <see cref="Triangles"/>; null before <see cref="Upload"/>.</summary>
        public GraphicsBuffer TriangleBuffer => buffers.Triangles;

        /// <summary>GPU copy of <see cref="Colliders"/>; null before <see cref="Upload"/>.</summary>
        public GraphicsBuffer ColliderBuffer => buffers.Colliders;

        /// <summary>Times that <see cref="Gather"/> found a change.</summary>
        public long Changes { get; private set; }

        /// <summary>Bytes of the GPU buffers.</summary>
        public long GpuBytes => buffers.Bytes;

        /// <summary>Bytes that the GPU buffers take once the triangles are copied.</summary>
        public long PlannedBytes => CollisionBuffers.PlannedBytes(triangles.Count, colliders.Count);

        /// <summary>Looks for colliders and, when any changed, makes their triangles again.</summary>
        /// <returns>Whether anything changed, so that <see cref="Upload"/> is due.</returns>
        public bool Gather(in CollisionQuery query)
        {
            if (!finder.Find(query)) return false;
            SetColliders(finder.States, query);
            return true;
        }

        /// <summary>Makes the triangles of obstacles, again only of those that changed; <see cref="Upload"/> is due then.</summary>
        public void SetColliders(IReadOnlyList<ColliderState> states, in CollisionQuery query)
        {
            Changes++;
            messages.Clear();
            joined = null;
            known.Clear();
            foreach (FluidObstacle solid in solids)
                if (solid.Spacing == query.Spacing) known[solid.State.Key] = solid;
            solids.Clear();
            triangles.Clear();
            colliders.Clear();
            long limit = Math.Min(SystemInfo.maxGraphicsBufferSize / CollisionTriangle.Stride, CollisionCollider.CountMask);
            foreach (ColliderState state in states) Add(state, query, limit);
        }

        /// <summary>Copies the triangles to the GPU; the buffers are replaced only when they grow.</summary>
        public void Upload() => buffers.Upload(triangles, colliders);

        /// <summary>
        /// Reads all meshes and terrains again with the next <see cref="Gather"/>, which counts as a change; what did not change keeps its
        /// triangles.
        /// </summary>
        public void Invalidate()
        {
            finder.Clear();
            States.Meshes.Refresh();
            States.Terrains.Refresh();
            skins.Refresh();
        }

        /// <summary>A collider of <see cref="Solids"/> as it was at another place; itself where it is there.</summary>
        public FluidObstacle At(FluidObstacle solid, in Matrix4x4 toSimulation)
        {
            if (solid.State.ToSimulation.Equals(toSimulation)) return solid;
            ColliderState state = solid.State.At(toSimulation);
            TriangleMesh made = maker.Make(state, solid.Spacing, new List<FluidMessage>());
            return made == null ? solid : new FluidObstacle(state, solid.Spacing, made);
        }

        /// <summary>
        /// Number of the collider that covers a point of simulation space, or of the solid that several enclose together, for
        /// <see cref="NameOf"/>; −1: none.
        /// </summary>
        /// <param name="point">Point [m].</param>
        /// <param name="clearance">Distance from a triangle below which a point counts as covered [m].</param>
        public int FindCovering(Vector3 point, float clearance)
        {
            if (solids.Count == 0) return -1;
            for (int i = 0; i < solids.Count; i++)
                if (solids[i].Mesh.Covers(point, clearance)) return i;
            joined ??= new JoinedSolids(solids, solids[0].Spacing);
            int solid = joined.Find(point);
            return solid < 0 ? -1 : solids.Count + solid;
        }

        /// <summary>The place on a collider that is nearest to a point, nearer than a distance [m]; null where there is none.</summary>
        public Vector3? Nearest(Vector3 point, float within)
        {
            Vector3? nearest = null;
            foreach (FluidObstacle solid in solids)
                if (solid.Mesh.Nearest(point, nearest == null ? within : Vector3.Distance(nearest.Value, point)) is Vector3 place)
                {
                    nearest = place;
                }
            return nearest;
        }

        /// <summary>What <see cref="FindCovering"/> found, for messages.</summary>
        public string NameOf(int covering)
        {
            if (covering < solids.Count) return $"'{solids[covering].Name}'";
            IReadOnlyList<FluidObstacle> members = joined.Members(covering - solids.Count);
            int named = Math.Min(members.Count, MostNames);
            var names = new string[named];
            for (int i = 0; i < named; i++) names[i] = $"'{members[i].Name}'";
            return string.Join(", ", names) + (named < members.Count ? $" and {members.Count - named} more" : "");
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            skins.Dispose();
            buffers.Dispose();
        }

        private void Add(in ColliderState state, in CollisionQuery query, long limit)
        {
            if (!known.TryGetValue(state.Key, out FluidObstacle solid) || !solid.State.Equals(state))
            {
                TriangleMesh made = maker.Make(state, query.Spacing, messages);
                if (made == null) return;
                solid = new FluidObstacle(state, query.Spacing, made);
            }
            TriangleMesh mesh = solid.Mesh;
            int first = triangles.Count, degenerate = 0;
            Vector3 half = query.HalfExtents;
            for (int t = 0; t < mesh.TriangleCount; t++)
            {
                mesh.GetTriangle(t, out Vector3 a, out Vector3 b, out Vector3 c);
                if (TriangleMesh.IsDegenerate(a, b, c)) degenerate++;
                else if (TriangleMath.MayOverlap(Vector3.zero, half, a, b, c)) triangles.Add(new CollisionTriangle { A = a, B = b, C = c });
            }
            if (degenerate > 0) ReportDegenerate(solid.Source, degenerate, mesh.TriangleCount);
            if (degenerate == mesh.TriangleCount) return;
            if (triangles.Count > limit)
            {
                ReportTooMany(solid.Source, limit);
                triangles.RemoveRange(first, triangles.Count - first);
                return;
            }
            solids.Add(solid);
            ColliderChecks.Check(query, solid, messages);
            if (triangles.Count > first) colliders.Add(RangeOf(first, mesh.IsClosed));
        }

        private CollisionCollider RangeOf(int first, bool closed)
        {
            Vector3 min = Vector3.positiveInfinity, max = Vector3.negativeInfinity;
            for (int t = first; t < triangles.Count; t++)
            {
                CollisionTriangle triangle = triangles[t];
                min = Vector3.Min(min, Vector3.Min(triangle.A, Vector3.Min(triangle.B, triangle.C)));
                max = Vector3.Max(max, Vector3.Max(triangle.A, Vector3.Max(triangle.B, triangle.C)));
            }
            return new CollisionCollider
            {
                BoundsMin = min,
                BoundsMax = max,
                FirstTriangle = (uint)first,
                TriangleCount = (uint)(triangles.Count - first) | (closed ? CollisionCollider.ClosedBit : 0u),
            };
        }

        private void ReportDegenerate(Component source, int count, int of) => messages.Add(count < of
            ? new FluidMessage(FluidSeverity.Info, FluidIssue.DegenerateTriangles, source,
                $"{count} of {of} triangles have no area and were left out.", "")
            : new FluidMessage(FluidSeverity.Warning, FluidIssue.DegenerateTriangles, source,
                "None of its triangles has an area, so the fluid cannot collide with it.", "Use a mesh with triangles that have an area."));

        private void ReportTooMany(Component source, long limit) => messages.Add(new FluidMessage(
            FluidSeverity.Warning, FluidIssue.TooManyTriangles, source,
            $"The colliders in the domain hold more than {limit} triangles, the most this device takes in a buffer, so the fluid passes " +
            "through this one.",
            "Use simpler collision meshes or a smaller domain."));
    }
}
