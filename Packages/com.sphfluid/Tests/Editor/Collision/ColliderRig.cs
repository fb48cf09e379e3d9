using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using Object = UnityEngine.Object;

namespace SphFluid.Tests
{
    /// <summary>A domain of 4 m on a layer of its own, colliders in it, and what is gathered.</summary>
    internal sealed class ColliderRig : IDisposable
    {
        public const int Layer = 29;

        private readonly List<Object> made = new List<Object>();

        public CollisionScene Scene { get; } = new CollisionScene();
        public Vector3 Position { get; set; }
        public Quaternion Rotation { get; set; } = Quaternion.identity;
        public Vector3 DomainSize { get; set; } = new Vector3(4f, 4f, 4f);
        public float Spacing { get; set; } = 0.1f;
        public FluidSimulation Simulation { get; set; }

        public T Add<T>(string name = "collider") where T : Collider
        {
            var holder = new GameObject(name) { layer = Layer };
            made.Add(holder);
            return holder.AddComponent<T>();
        }

        public MeshCollider AddMesh(Mesh mesh, string name = "collider")
        {
            if (mesh != null) made.Add(mesh);
            MeshCollider collider = Add<MeshCollider>(name);
            collider.sharedMesh = mesh;
            return collider;
        }

        public bool Gather()
        {
            Physics.SyncTransforms();
            CollisionQuery query = Simulation != null ? Simulation.Spec.Query() : default;
            query.Scene = Physics.defaultPhysicsScene;
            query.Position = Position;
            query.Rotation = Rotation;
            query.DomainSize = DomainSize;
            query.Layers = 1 << Layer;
            query.Spacing = Spacing;
            return Scene.Gather(query);
        }

        /// <summary>Gathers, expects one collider and returns its triangles in the domain.</summary>
        public List<CollisionTriangle> GatherOne()
        {
            Gather();
            Assert.That(Scene.Messages.Select(m => m.ToString()), Is.Empty);
            Assert.That(Scene.Colliders.Count, Is.EqualTo(1));
            return Scene.Triangles.ToList();
        }

        /// <summary>Volume enclosed by triangles that face outward [m³].</summary>
        public static double Volume(IEnumerable<CollisionTriangle> triangles) =>
            triangles.Sum(t => Vector3.Dot(t.A, Vector3.Cross(t.B, t.C)) / 6.0);

        /// <summary>Bounds of the triangles' corners.</summary>
        public static Bounds BoundsOf(IEnumerable<CollisionTriangle> triangles)
        {
            var bounds = new Bounds(triangles.First().A, Vector3.zero);
            foreach (CollisionTriangle t in triangles)
            {
                bounds.Encapsulate(t.A);
                bounds.Encapsulate(t.B);
                bounds.Encapsulate(t.C);
            }
            return bounds;
        }

        public void Dispose()
        {
            Scene.Dispose();
            foreach (Object item in made) Object.DestroyImmediate(item);
        }
    }
}
