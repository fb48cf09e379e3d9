using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>All that decides a collider's triangles in simulation space, so that equal states need no new triangles.</summary>
    internal readonly struct ColliderState : IEquatable<ColliderState>
    {
        private readonly MeshStamp stamp;
        private readonly int edition; // of the mesh

        private ColliderState(Collider collider, Matrix4x4 toSimulation, float friction, Mesh mesh, Vector3 center, Vector3 size)
        {
            Body = null;
            Key = Collider = collider;
            Triangles = null;
            Friction = friction;
            ToSimulation = toSimulation;
            Mesh = mesh;
            Center = center;
            Size = size;
            stamp = MeshStamp.Read(mesh);
            edition = 0;
        }

        /// <summary>A mesh that no collider has, or that of a terrain.</summary>
        /// <param name="key">What it is known by while it moves; a terrain's collider.</param>
        /// <param name="triangles">Its triangles in a space of its own.</param>
        /// <param name="friction">0 free slip to 1 no slip; negative: as the domain's faces.</param>
        /// <param name="toSimulation">Its own space to simulation space.</param>
        public ColliderState(object key, TriangleMesh triangles, float friction, in Matrix4x4 toSimulation)
        {
            Body = null;
            Key = key;
            Collider = key as Collider;
            Triangles = triangles;
            Friction = friction;
            ToSimulation = toSimulation;
            Mesh = null;
            Center = Vector3.zero;
            Size = Vector3.one;
            stamp = default;
            edition = 0;
        }

        /// <summary>What the obstacle is known by: its collider, where it has one.</summary>
        public object Key { get; }

        /// <summary>The collider; null for a mesh that no collider has.</summary>

        public Collider Collider { get; }
        public Matrix4x4 ToSimulation { get; }

        /// <summary>Triangles of a mesh that no collider has, or of a terrain, in a space of their own; null for other colliders.</summary>
        public TriangleMesh Triangles { get; }

        /// <summary>0 free slip to 1 no slip; negative: as the domain's faces.</summary>
        public float Friction { get; }

        /// <summary>The rigid body that the liquid moves it with; null: it goes where the scene puts it.</summary>
        public FloatingBody Body { get; }

        /// <summary>Mesh of a MeshCollider; null for others.</summary>
        public Mesh Mesh { get; }

        /// <summary>Centre in the collider's space.</summary>
        public Vector3 Center { get; }

        /// <summary>Box: edge lengths. Sphere: radius in x. Capsule, Character Controller: radius, height, axis (0 x, 1 y, 2 z).</summary>
        public Vector3 Size { get; }

        public static ColliderState Read(Collider collider, float friction, in DomainPose worldToSimulation)
        {
            Matrix4x4 toSimulation = worldToSimulation * collider.transform.localToWorldMatrix;
            switch (collider)
            {
                case MeshCollider mesh:
                    return new ColliderState(collider, toSimulation, friction, mesh.sharedMesh, Vector3.zero, Vector3.one);
                case BoxCollider box:
                    return new ColliderState(collider, toSimulation, friction, null, box.center, box.size);
                case SphereCollider sphere:
                    return new ColliderState(collider, toSimulation, friction, null, sphere.center, new Vector3(sphere.radius, 0f, 0f));
                case CapsuleCollider capsule:
                    return new ColliderState(collider, toSimulation, friction, null, capsule.center,
                        new Vector3(capsule.radius, capsule.height, capsule.direction));
                case CharacterController character:
                    return new ColliderState(collider, worldToSimulation * Upright(character), friction, null, Vector3.zero,
                        new Vector3(character.radius, character.height, 1f));
                default:
                    return new ColliderState(collider, toSimulation, friction, null, Vector3.zero, Vector3.zero);
            }
        }

        // Unity turns no Character Controller: its capsule stands along the world's y axis.
        private static Matrix4x4 Upright(CharacterController character)
        {
            Transform transform = character.transform;
            return Matrix4x4.TRS(transform.TransformPoint(character.center), Quaternion.identity, transform.lossyScale);
        }

        /// <summary>The same collider, moved by the liquid.</summary>
        public ColliderState With(FloatingBody body) => new ColliderState(this, body);

        private ColliderState(in ColliderState other, FloatingBody body)
        {
            this = other;
            Body = body;
        }

        /// <summary>The same collider, whose mesh was found changed so many times.</summary>
        public ColliderState With(int edition) => new ColliderState(this, edition);

        private ColliderState(in ColliderState other, int edition)
        {
            this = other;
            this.edition = edition;
        }

        /// <summary>The same collider, elsewhere.</summary>
        public ColliderState At(in Matrix4x4 toSimulation) => new ColliderState(this, toSimulation);

        private ColliderState(in ColliderState other, in Matrix4x4 toSimulation)
        {
            this = other;
            ToSimulation = toSimulation;
        }

        /// <summary>
        /// Whether the states have the same mesh, with the same vertices as far as that is cheap to find out, or both none.
        /// </summary>
        public bool HasMeshOf(in ColliderState other) => ReferenceEquals(Mesh, other.Mesh) && ReferenceEquals(Triangles, other.Triangles) &&
            stamp.Equals(other.stamp) && edition == other.edition;

        /// <summary>Whether the states differ by the transform only.</summary>
        public bool HasShapeOf(in ColliderState other) => HasMeshOf(other) && Center.Equals(other.Center) && Size.Equals(other.Size);

        /// <summary>Whether the states differ by the friction at most.</summary>
        public bool HasTrianglesOf(in ColliderState other) =>
            ReferenceEquals(Key, other.Key) && ToSimulation.Equals(other.ToSimulation) && HasShapeOf(other);

        public bool Equals(ColliderState other) => HasTrianglesOf(other) && Friction.Equals(other.Friction) &&
            ReferenceEquals(Body, other.Body);

        public override bool Equals(object obj) => obj is ColliderState other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(Key, ToSimulation, Mesh);
    }
}
