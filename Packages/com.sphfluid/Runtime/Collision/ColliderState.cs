using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>All that decides a collider's triangles in simulation space, so that equal states need no new triangles.</summary>
    internal readonly struct ColliderState : IEquatable<ColliderState>
    {
        readonly MeshStamp stamp;

        ColliderState(Collider collider, Matrix4x4 toSimulation, Mesh mesh, Vector3 center, Vector3 size)
        {
            Collider = collider;
            ToSimulation = toSimulation;
            Mesh = mesh;
            Center = center;
            Size = size;
            stamp = MeshStamp.Of(mesh);
        }

        public Collider Collider { get; }
        public Matrix4x4 ToSimulation { get; }

        /// <summary>Mesh of a MeshCollider; null for others.</summary>
        public Mesh Mesh { get; }

        /// <summary>Centre in the collider's space.</summary>
        public Vector3 Center { get; }

        /// <summary>Box: edge lengths. Sphere: radius in x. Capsule: radius, height, axis (0 x, 1 y, 2 z).</summary>
        public Vector3 Size { get; }

        public static ColliderState Of(Collider collider, in Matrix4x4 worldToSimulation)
        {
            Matrix4x4 toSimulation = worldToSimulation * collider.transform.localToWorldMatrix;
            switch (collider)
            {
                case MeshCollider mesh:
                    return new ColliderState(collider, toSimulation, mesh.sharedMesh, Vector3.zero, Vector3.one);
                case BoxCollider box:
                    return new ColliderState(collider, toSimulation, null, box.center, box.size);
                case SphereCollider sphere:
                    return new ColliderState(collider, toSimulation, null, sphere.center, new Vector3(sphere.radius, 0f, 0f));
                case CapsuleCollider capsule:
                    return new ColliderState(collider, toSimulation, null, capsule.center,
                        new Vector3(capsule.radius, capsule.height, capsule.direction));
                default:
                    return new ColliderState(collider, toSimulation, null, Vector3.zero, Vector3.zero);
            }
        }

        /// <summary>Whether the states differ by the transform only.</summary>
        public bool HasShapeOf(in ColliderState other) =>
            ReferenceEquals(Mesh, other.Mesh) && Center.Equals(other.Center) && Size.Equals(other.Size) && stamp.Equals(other.stamp);

        public bool Equals(ColliderState other) =>
            ReferenceEquals(Collider, other.Collider) && ReferenceEquals(Mesh, other.Mesh) &&
            ToSimulation.Equals(other.ToSimulation) && Center.Equals(other.Center) && Size.Equals(other.Size) &&
            stamp.Equals(other.stamp);

        public override bool Equals(object obj) => obj is ColliderState other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(Collider, ToSimulation, Mesh);
    }
}
