using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Skinned meshes as walls: each is baked as it is drawn when colliders are looked for, and keeps its triangles while no corner moved.
    /// </summary>
    internal sealed class SkinnedWalls : IDisposable
    {
        /// <summary>Most vertices of a skin: all of them are skinned on the CPU and their triangles listed anew every frame.</summary>
        public const int MostVertices = 20000;

        private static readonly TriangleMesh None = new TriangleMesh(Array.Empty<Vector3>(), Array.Empty<int>());

        private readonly Dictionary<SkinnedMeshRenderer, Skin> skins = new Dictionary<SkinnedMeshRenderer, Skin>();
        private readonly List<SkinnedMeshRenderer> found = new List<SkinnedMeshRenderer>();

        /// <summary>Adds the skins near a domain.</summary>
        /// <param name="query">The domain, and the objects that have skins.</param>
        /// <param name="states">Receives them.</param>
        public void AddStates(in CollisionQuery query, List<ColliderState> states)
        {
            if ((query.Walls?.Count ?? 0) == 0 && skins.Count == 0) return;
            DomainPose worldToSimulation = query.WorldToSimulation;
            var domain = new Bounds(query.Position, 2f * AffineMath.Extents(Matrix4x4.Rotate(query.Rotation), query.HalfExtents));
            for (int i = 0; i < (query.Walls?.Count ?? 0); i++)
            {
                WallSpec spec = query.Walls[i];
                if (!spec.Skins || !spec.Settings.AppliesTo(query.Owner)) continue;
                spec.Owner.GetComponentsInChildren(false, found);
                foreach (SkinnedMeshRenderer renderer in found)
                {
                    bool counts = renderer.enabled && renderer.sharedMesh != null && renderer.bounds.Intersects(domain);
                    if (!counts || !spec.Has(renderer, query.Layers)) continue;
                    TriangleMesh mesh = Problem(renderer) == null ? SkinOf(renderer).Bake(renderer) : None;
                    states
                        .Add(new ColliderState(renderer, mesh, spec.Settings.EffectiveFriction,
                            worldToSimulation * renderer.transform.localToWorldMatrix));
                }
            }
            GoneKeys.Forget(skins, skin => skin.Dispose());
        }

        /// <summary>Why a skin is no wall; null where it can be one.</summary>
        public static FluidMessage? Problem(SkinnedMeshRenderer renderer)
        {
            Mesh mesh = renderer.sharedMesh;
            if (!mesh.isReadable)
            {
                return new FluidMessage(FluidSeverity.Warning, FluidIssue.MeshNotReadable, renderer,
                    $"The mesh '{mesh.name}' of the Skinned Mesh Renderer is not readable, so the fluid cannot collide with it.",
                    "Tick Read/Write in the mesh's import settings.");
            }
            if (mesh.vertexCount > MostVertices)
            {
                return new FluidMessage(FluidSeverity.Warning, FluidIssue.TooManyTriangles, renderer,
                    $"The mesh '{mesh.name}' of the Skinned Mesh Renderer has {mesh.vertexCount} vertices, more than the {MostVertices} " +
                    "that are skinned for the fluid every frame, so the fluid passes through it.",
                    "Collide with a simpler skin on the same bones whose renderer draws nothing, or with Capsule Colliders on the bones.");
            }
            return null;
        }

        /// <summary>Reads all skins' triangles again; those that did not change stay.</summary>
        public void Refresh()
        {
            foreach (Skin skin in skins.Values) skin.IsStale = true;
        }

        public void Dispose()
        {
            foreach (Skin skin in skins.Values) skin.Dispose();
            skins.Clear();
        }

        private Skin SkinOf(SkinnedMeshRenderer renderer)
        {
            if (!skins.TryGetValue(renderer, out Skin skin)) skins.Add(renderer, skin = new Skin());
            return skin;
        }

        private sealed class Skin : IDisposable
        {
            private readonly Mesh baked = new Mesh { name = "SPH Fluid Skin", hideFlags = HideFlags.HideAndDontSave };
            private readonly List<Vector3> vertices = new List<Vector3>();
            private TriangleMesh mesh;
            private Mesh source;
            private MeshStamp stamp;

            /// <summary>Whether the triangles may be others, of as many corners.</summary>
            public bool IsStale { get; set; }

            /// <summary>The triangles now, in the renderer's space; the same ones while no corner moved.</summary>
            public TriangleMesh Bake(SkinnedMeshRenderer renderer)
            {
                renderer.BakeMesh(baked, true);
                MeshStamp now = MeshStamp.Read(renderer.sharedMesh);
                if (mesh == null || !ReferenceEquals(source, renderer.sharedMesh) || !stamp.Equals(now) || IsStale)
                {
                    (source, stamp, IsStale) = (renderer.sharedMesh, now, false);
                    TriangleMesh read = new MeshReader().Read(baked);
                    if (mesh == null || !read.HasTrianglesOf(mesh)) return mesh = read;
                }
                baked.GetVertices(vertices);
                return IsSame() ? mesh : mesh = mesh.Deformed(vertices.ToArray());
            }

            private bool IsSame()
            {
                Vector3[] before = mesh.Vertices;
                for (int i = 0; i < before.Length; i++)
                    if (!before[i].Equals(vertices[i])) return false;
                return true;
            }

            public void Dispose()
            {
                if (Application.isPlaying) UnityEngine.Object.Destroy(baked);
                else UnityEngine.Object.DestroyImmediate(baked);
            }
        }
    }
}
