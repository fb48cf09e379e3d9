using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Rules about what a collider and the simulation's settings ask of each other. Messages of a moving collider stay the same.
    /// </summary>
    internal static class ColliderChecks
    {
        /// <summary>Checks a collider that takes part.</summary>
        /// <param name="query">Where it was found; without an owner nothing is checked.</param>
        /// <param name="solid">The collider.</param>
        /// <param name="messages">Receives what is worth knowing.</param>
        public static void Check(in CollisionQuery query, FluidObstacle solid, List<FluidMessage> messages)
        {
            Component owner = query.Owner;
            if (owner == null) return;
            Collider collider = solid.State.Collider;
            if (solid.State.Friction >= 0f && !query.ColliderFriction)
            {
                messages.Add(new FluidMessage(FluidSeverity.Warning, FluidIssue.ColliderFrictionUnused, solid.Source,
                    $"Its Fluid Collider has a friction of its own, but '{owner.name}' computes by the thesis's method, where all " +
                    "colliders have the friction of the faces.",
                    "Set the simulation's Method to Standard or Robust, or turn Own Friction off."));
            }
            if (TerrainPatches.IsTerrain(collider) &&
                (collider.transform.rotation != Quaternion.identity || collider.transform.lossyScale != Vector3.one))
            {
                messages.Add(new FluidMessage(FluidSeverity.Warning, FluidIssue.ColliderUnsupported, collider,
                    "The terrain's object is turned or scaled, but Unity draws terrains upright and in their own size: liquid collides " +
                    "with what is drawn.",
                    "Set the rotation of the object and its parents to 0 and their scales to 1."));
            }
            if (query.Periodic == FluidAxes.None) return;
            Component source = solid.Source;
            Bounds bounds = solid.Mesh.Bounds;
            float reach = query.SupportRatio * query.Spacing;
            for (int axis = 0; axis < 3; axis++)
            {
                var name = (FluidAxes)(1 << axis);
                if ((query.Periodic & name) != 0 && EndsAtAFace(bounds, 0.5f * query.DomainSize[axis], reach, axis))
                {
                    messages.Add(new FluidMessage(FluidSeverity.Warning, FluidIssue.ColliderAtPeriodicFace, source,
                        $"The {(source == null ? "mesh" : source.GetType().Name)} ends at a periodic face of '{owner.name}' along " +
                        $"{name}. Colliders are not repeated behind such faces: " +
                        "liquid that leaves through it does not touch this one from the other side.",
                        $"Keep it {reach:0.###} m or more inside the faces, or let it reach as far beyond both and look the same at " +
                        $"both, or take {name} out of Boundaries.Periodic."));
                }
            }
        }

        // What goes on beyond both faces may be the same wall everywhere; what is well inside is touched from one side only.
        private static bool EndsAtAFace(in Bounds bounds, float half, float reach, int axis)
        {
            float low = bounds.min[axis], high = bounds.max[axis];
            bool inside = low >= reach - half && high <= half - reach;
            bool across = low <= -half - reach && high >= half + reach;
            return !inside && !across;
        }
    }
}
