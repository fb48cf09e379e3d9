using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Where to look for colliders: the domain's pose, its physics scene and the layers.</summary>
    internal struct CollisionQuery
    {
        /// <summary>Component of the simulation that looks; null: any, whose settings are not checked.</summary>
        public Component Owner;

        /// <summary>Physics scene that the simulation's GameObject is in.</summary>
        public PhysicsScene Scene;

        /// <summary>World position of the domain's centre [m].</summary>
        public Vector3 Position;

        /// <summary>World rotation of the domain.</summary>
        public Quaternion Rotation;

        /// <summary>Edge lengths of the domain [m].</summary>
        public Vector3 DomainSize;

        /// <summary>Layers whose colliders count.</summary>
        public LayerMask Layers;

        /// <summary>
        /// Particle spacing dx [m]: triangles as near as that to the domain are kept, curved colliders follow their shape to 0.1 dx.
        /// </summary>
        public float Spacing;

        /// <summary>Whether each collider has a friction of its own.</summary>
        public bool ColliderFriction;

        /// <summary>Periodic axes of the domain.</summary>
        public FluidAxes Periodic;

        /// <summary>Support radius over the spacing.</summary>
        public float SupportRatio;

        /// <summary>Walls besides the scene's colliders, to be used at once; null for none.</summary>
        public IReadOnlyList<ColliderState> Others;

        /// <summary>Who makes walls of skinned meshes and wheels; null for none.</summary>
        public IReadOnlyList<WallSpec> Walls;

        /// <summary>World space to simulation space.</summary>
        public DomainPose WorldToSimulation => DomainSpace.FromWorld(Position, Rotation);

        /// <summary>Half the domain's size with the margin for nearby triangles [m].</summary>
        public Vector3 HalfExtents => DomainSize * 0.5f + Vector3.one * Spacing;
    }

    /// <summary>Finds the colliders in a domain and reports whether anything changed since the last look.</summary>
    internal sealed class ColliderFinder
    {
        private readonly ColliderStates kinds;
        private readonly SkinnedWalls skins;
        private Collider[] hits = new Collider[32];
        private Collider[] lastHits = Array.Empty<Collider>();
        private readonly List<Collider> ordered = new List<Collider>();
        private List<ColliderState> states = new List<ColliderState>();
        private List<ColliderState> previous = new List<ColliderState>();

        /// <param name="kinds">Makes the states of colliders.</param>
        /// <param name="skins">What is read of skins.</param>
        public ColliderFinder(ColliderStates kinds, SkinnedWalls skins)
        {
            this.kinds = kinds;
            this.skins = skins;
        }

        /// <summary>Whose rigid bodies the liquid moves; null: nobody's.</summary>
        public IFloatingOwners Owners { get; set; }

        /// <summary>Solid colliders found last, in hierarchy order.</summary>
        public IReadOnlyList<ColliderState> States => states;

        /// <summary>Looks again.</summary>
        /// <returns>Whether a collider came, went, moved or changed its shape.</returns>
        public bool Find(in CollisionQuery query)
        {
            // Queries see the transforms of the last physics step unless they are synchronised first.
            Physics.SyncTransforms();
            int count = Overlap(query);
            if (!SameHits(count)) Order(count);

            (states, previous) = (previous, states);
            states.Clear();
            DomainPose worldToSimulation = query.WorldToSimulation;
            Owners?.Begin(query.Position, query.Rotation);
            foreach (Collider collider in ordered)
            {
                IColliderSettings own = ColliderSettings.Find(collider);
                if (own != null && !own.AppliesTo(query.Owner)) continue;
                float friction = own?.EffectiveFriction ?? ColliderSettings.DomainFriction;
                ColliderState state = kinds.Get(collider, own, friction, worldToSimulation, query.DomainSize, query.Spacing);
                // A wheel turns and springs beside its Rigidbody, which therefore does not carry it.
                bool floats = Owners != null && (own == null || own.MovedByLiquid) && !WheelDiscs.IsWheel(collider);
                states.Add(floats ? state.With(Owners.OwnerOf(collider)) : state);
            }
            kinds.Wheels.AddStates(query, ordered, states);
            skins.AddStates(query, states);
            for (int i = 0; i < (query.Others?.Count ?? 0); i++) states.Add(query.Others[i]);
            return !SameStates();
        }

        /// <summary>Forgets what was found, so that the next look counts as a change.</summary>
        public void Clear()
        {
            states.Clear();
            previous.Clear();
            ordered.Clear();
            lastHits = Array.Empty<Collider>();
        }

        // The results array is not resized by Unity: a full one may have missed colliders.
        private int Overlap(in CollisionQuery query)
        {
            while (true)
            {
                int count = query.Scene.OverlapBox(query.Position, query.HalfExtents, hits, query.Rotation, query.Layers,
                    QueryTriggerInteraction.Ignore);
                if (count < hits.Length) return count;
                Array.Resize(ref hits, hits.Length * 2);
            }
        }

        private bool SameHits(int count)
        {
            if (count != lastHits.Length) return false;
            for (int i = 0; i < count; i++)
                if (!ReferenceEquals(hits[i], lastHits[i])) return false;
            return true;
        }

        // Unity gives no order; the sum of forces from several triangles depends on it in the last bits.
        private void Order(int count)
        {
            lastHits = new Collider[count];
            Array.Copy(hits, lastHits, count);
            ordered.Clear();
            ordered.AddRange(lastHits);
            ordered.Sort(HierarchyOrder.Compare);
            Array.Clear(hits, 0, hits.Length);
        }

        private bool SameStates()
        {
            if (states.Count != previous.Count) return false;
            for (int i = 0; i < states.Count; i++)
                if (!states[i].Equals(previous[i])) return false;
            return true;
        }
    }
}
