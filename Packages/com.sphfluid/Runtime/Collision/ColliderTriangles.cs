using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Turns colliders into triangles in simulation space, or says why that cannot be done.</summary>
    internal sealed class ColliderTriangles
    {
        /// <summary>
        /// Largest distance of a sphere's or capsule's triangles from its true surface, as a fraction of the particle spacing.
        /// </summary>
        public const float ChordError = 0.1f;

        private const string MeshKind = "Mesh Collider";

        private readonly MeshReader reader;

        /// <param name="reader">Reads meshes.</param>
        public ColliderTriangles(MeshReader reader)
        {
            this.reader = reader;
        }

        /// <summary>Triangles of a collider.</summary>
        /// <param name="state">The collider.</param>
        /// <param name="spacing">Particle spacing dx [m].</param>
        /// <param name="messages">Receives the reason when there are none.</param>
        /// <returns>Null when the collider has to be left out.</returns>
        public TriangleMesh Make(in ColliderState state, float spacing, List<FluidMessage> messages)
        {
            if (AffineMath.IsSingular(state.ToSimulation))
            {
                messages.Add(Warn(state, FluidIssue.ColliderTransformSingular,
                    $"The {Kind(state)}'s transform has a zero or non-finite scale, so the fluid cannot collide with it.",
                    "Give the object and its parents a scale without zeros."));
                return null;
            }
            if (state.Key is SkinnedMeshRenderer skin && SkinnedWalls.Problem(skin) is FluidMessage problem)
            {
                messages.Add(problem);
                return null;
            }
            if (WheelDiscs.IsWheel(state.Collider) && state.Triangles?.TriangleCount == 0) return Shapeless(state, messages);
            if (state.Key is SkinnedMeshRenderer bare && state.Triangles.TriangleCount == 0)
            {
                messages.Add(Empty(bare, "Skinned Mesh Renderer", bare.sharedMesh));
                return null;
            }
            if (state.Triangles != null) return state.Triangles.Transformed(state.ToSimulation);
            switch (state.Collider)
            {
                case MeshCollider _: return FromMesh(state, messages);
                case BoxCollider _: return FromBox(state, messages);
                case SphereCollider _:
                case CapsuleCollider _:
                case CharacterController _: return FromRound(state, spacing, messages);
                case Collider terrain when TerrainPatches.IsTerrain(terrain):
                    messages.Add(TerrainProblem(state));
                    return null;
                default:
                    messages.Add(Warn(state, FluidIssue.ColliderUnsupported,
                        $"The fluid does not collide with a {Kind(state)}.",
                        "Use a Mesh, Box, Sphere, Capsule, Terrain or Wheel Collider or a Character Controller, or take its layer out of " +
                        "the simulation's Collider Layers."));
                    return null;
            }
        }

        private TriangleMesh FromMesh(in ColliderState state, List<FluidMessage> messages)
        {
            FluidMessage? problem = Problem(state.Collider as MeshCollider);
            if (problem.HasValue)
            {
                messages.Add(problem.Value);
                return null;
            }
            TriangleMesh mesh = reader.Read(state.Mesh);
            if (mesh.TriangleCount > 0) return mesh.Transformed(state.ToSimulation);
            messages.Add(Empty(state.Collider, MeshKind, state.Mesh));
            return null;
        }

        /// <summary>Why a MeshCollider's mesh cannot serve, without reading its triangles; null when nothing speaks against it.</summary>
        public static FluidMessage? Problem(MeshCollider collider)
        {
            Mesh mesh = collider.sharedMesh;
            if (mesh == null)
            {
                return new FluidMessage(FluidSeverity.Warning, FluidIssue.MeshEmpty, collider,
                    "The Mesh Collider has no mesh, so the fluid cannot collide with it.",
                    "Assign a mesh to the Mesh Collider or remove it.");
            }
            if (!mesh.isReadable)
            {
                return new FluidMessage(FluidSeverity.Warning, FluidIssue.MeshNotReadable, collider,
                    $"The mesh '{mesh.name}' of the Mesh Collider is not readable, so the fluid cannot collide with it.",
                    "Tick Read/Write in the mesh's import settings.");
            }
            return mesh.vertexCount == 0 ? Empty(collider, MeshKind, mesh) : (FluidMessage?)null;
        }

        private static FluidMessage Empty(Component part, string kind, Mesh mesh) => new FluidMessage(
            FluidSeverity.Warning, FluidIssue.MeshEmpty, part,
            $"The mesh '{mesh.name}' of the {kind} has no triangles, so the fluid cannot collide with it.",
            $"Assign a mesh with triangles to the {kind} or remove it.");

        private static FluidMessage TerrainProblem(in ColliderState state) => TerrainPatches.HasData(state.Collider)
            ? Warn(state, FluidIssue.TooManyTriangles,
                $"More than {TerrainPatches.MaxCells} cells of the terrain lie over the domain, so the fluid passes through it.",
                "Use a smaller domain, or a lower Heightmap Resolution for the terrain.")
            : Warn(state, FluidIssue.MeshEmpty,
                "The Terrain Collider has no terrain data, or data without a size, so the fluid cannot collide with it.",
                "Assign terrain data with a size greater than zero to the Terrain Collider or remove it.");

        private static TriangleMesh FromBox(in ColliderState state, List<FluidMessage> messages)
        {
            Matrix4x4 box = state.ToSimulation * Matrix4x4.TRS(state.Center, Quaternion.identity, state.Size);
            return AffineMath.IsSingular(box) ? Shapeless(state, messages) : PrimitiveTessellator.Box(box);
        }

        private static TriangleMesh FromRound(in ColliderState state, float spacing, List<FluidMessage> messages)
        {
            RoundShape round = RoundShape.FromCollider(state);
            if (!(round.Radius > 0f) || !AffineMath.IsFinite(round.Radius)) return Shapeless(state, messages);
            Quaternion turn = Quaternion.FromToRotation(Vector3.up, AxisOf(state.ToSimulation, round.Axis));
            Matrix4x4 pose = Matrix4x4.TRS(state.ToSimulation.MultiplyPoint3x4(state.Center), turn, Vector3.one);
            return PrimitiveTessellator.Capsule(pose, round.Radius, round.HalfLength, ChordError * spacing);
        }

        private static TriangleMesh Shapeless(in ColliderState state, List<FluidMessage> messages)
        {
            messages.Add(Warn(state, FluidIssue.ColliderTransformSingular,
                $"The {Kind(state)} has a zero or non-finite size, so the fluid cannot collide with it.",
                "Give the collider a size greater than zero or remove it."));
            return null;
        }

        private static Vector3 AxisOf(in Matrix4x4 m, int column) => m.GetColumn(column);

        private static string Kind(in ColliderState state) => state.Key is Component component &&
            component != null ? component.GetType().Name : "mesh";

        private static FluidMessage Warn(in ColliderState state, FluidIssue issue, string text, string cure) =>
            new FluidMessage(FluidSeverity.Warning, issue, state.Key as Component, text, cure);
    }
}
