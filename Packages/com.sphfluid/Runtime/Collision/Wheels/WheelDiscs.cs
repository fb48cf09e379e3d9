using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Wheel Colliders as cylinders that roll, steer and spring as their wheels do. In projects without Unity's vehicles module no collider
    /// is a wheel.
    /// </summary>
    internal sealed class WheelDiscs
    {
        /// <summary>Width over radius of a wheel that no Fluid Collider gives one: that of a 205/55 R16 tyre, 205 mm over 316 mm.</summary>
        public const float DefaultAspect = 0.65f;

#if SPHFLUID_VEHICLES
        private readonly Dictionary<Collider, Disc> discs = new Dictionary<Collider, Disc>();
        private readonly List<WheelCollider> found = new List<WheelCollider>();
#endif

        /// <summary>Whether a collider is a wheel's.</summary>
        public static bool IsWheel(Collider collider)
        {
#if SPHFLUID_VEHICLES
            return collider is WheelCollider;
#else
            return false;
#endif
        }

        /// <summary>The state of a wheel; without triangles where it has no size.</summary>
        /// <param name="collider">The Wheel Collider.</param>
        /// <param name="settings">Its Fluid Collider's; null for none.</param>
        /// <param name="friction">0 free slip to 1 no slip; negative: as the domain's faces.</param>
        /// <param name="worldToSimulation">World space to simulation space.</param>
        /// <param name="spacing">Particle spacing dx [m].</param>
        public ColliderState StateOf(Collider collider, IColliderSettings settings, float friction, in DomainPose worldToSimulation,
            float spacing)
        {
#if SPHFLUID_VEHICLES
            if (collider is WheelCollider wheel)
            {
                if (!discs.TryGetValue(wheel, out Disc disc)) disc = Add(wheel);
                disc.Set(RadiusOf(wheel), WidthOf(wheel, settings), spacing);
                return new ColliderState(wheel, disc.Mesh, friction, worldToSimulation * PoseOf(wheel));
            }
#endif
            return ColliderState.Read(collider, friction, worldToSimulation);
        }

        /// <summary>Adds the wheels near a domain that Unity's overlap query did not find.</summary>
        /// <param name="query">The domain, and the objects that have wheels.</param>
        /// <param name="hits">What the query found.</param>
        /// <param name="states">Receives them.</param>
        public void AddStates(in CollisionQuery query, List<Collider> hits, List<ColliderState> states)
        {
#if SPHFLUID_VEHICLES
            DomainPose worldToSimulation = query.WorldToSimulation;
            for (int i = 0; i < (query.Walls?.Count ?? 0); i++)
            {
                WallSpec spec = query.Walls[i];
                if (!spec.Wheels || !spec.Settings.AppliesTo(query.Owner)) continue;
                spec.Owner.GetComponentsInChildren(false, found);
                foreach (WheelCollider wheel in found)
                {
                    if (!wheel.enabled || hits.Contains(wheel) || !spec.Has(wheel, query.Layers)) continue;
                    ColliderState state = StateOf(wheel, spec.Settings, spec.Settings.EffectiveFriction, worldToSimulation, query.Spacing);
                    if (IsNear(state.ToSimulation.GetPosition(), RadiusOf(wheel) + WidthOf(wheel, spec.Settings), query.HalfExtents))
                    {
                        states.Add(state);
                    }
                }
            }
#endif
        }

#if SPHFLUID_VEHICLES
        private static bool IsNear(Vector3 centre, float reach, Vector3 half)
        {
            var nearest = new Vector3(Mathf.Clamp(centre.x, -half.x, half.x), Mathf.Clamp(centre.y, -half.y, half.y),
                Mathf.Clamp(centre.z, -half.z, half.z));
            return (centre - nearest).sqrMagnitude <= reach * reach;
        }

        // Suspension and radius follow the scale of y, along which the wheel springs.
        private static float RadiusOf(WheelCollider wheel) => Mathf.Abs(wheel.radius * wheel.transform.lossyScale.y);

        private static float WidthOf(WheelCollider wheel, IColliderSettings settings) =>
            settings != null && settings.WheelWidth > 0f ? settings.WheelWidth : DefaultAspect * RadiusOf(wheel);

        // The axle is the pose's x axis. Without a Rigidbody Unity's physics has no wheel: it is at the collider's centre.
        private static Matrix4x4 PoseOf(WheelCollider wheel)
        {
            Vector3 position = wheel.transform.TransformPoint(wheel.center);
            Quaternion rotation = wheel.transform.rotation;
            if (wheel.attachedRigidbody != null) wheel.GetWorldPose(out position, out rotation);
            return Matrix4x4.TRS(position, rotation, Vector3.one);
        }

        private Disc Add(WheelCollider wheel)
        {
            GoneKeys.Forget(discs);
            var disc = new Disc();
            discs.Add(wheel, disc);
            return disc;
        }

        private sealed class Disc
        {
            private static readonly TriangleMesh None = new TriangleMesh(new Vector3[0], new int[0]);

            // Of its size: what rounding may change as the object turns.
            private const float Tolerance = 1e-4f;

            private Vector3 made;

            /// <summary>The triangles about the origin, the axle along x; none where the wheel has no size.</summary>
            public TriangleMesh Mesh { get; private set; } = None;

            public void Set(float radius, float width, float spacing)
            {
                var asked = new Vector3(radius, width, spacing);
                if ((asked - made).magnitude <= Tolerance * made.magnitude && made.z == asked.z) return;
                made = asked;
                bool hasSize = radius > 0f && width > 0f && AffineMath.IsFinite(radius) && AffineMath.IsFinite(width);
                Matrix4x4 axle = Matrix4x4.Rotate(Quaternion.FromToRotation(Vector3.up, Vector3.right));
                Mesh = hasSize ? PrimitiveTessellator.Cylinder(axle, radius, 0.5f * width, ColliderTriangles.ChordError * spacing) : None;
            }
        }
#endif
    }
}
