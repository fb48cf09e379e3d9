using UnityEngine;

namespace SphFluid
{
    /// <summary>A collider that was put at its new place at once, since no motion there could be followed.</summary>
    internal readonly struct BodyJump
    {
        public BodyJump(Component source, BodyFollowing reason)
        {
            Source = source;
            Reason = reason;
        }

        /// <summary>The collider, or the renderer of a skin; null for a mesh that a script gave.</summary>
        public Component Source { get; }

        public BodyFollowing Reason { get; }

        /// <summary>What is reported, the same for each jump of a collider for the same reason.</summary>
        public FluidMessage Message
        {
            get
            {
                (string what, string cure) = Texts();
                return new FluidMessage(FluidSeverity.Warning, FluidIssue.ColliderJumped, Source,
                    $"The {(Source != null ? Source.GetType().Name : "mesh")} {what}. Liquid cannot follow that: the collider was put at " +
                    "its new place at once, " +
                    "and liquid in between is now on its other side.", cure);
            }
        }

        private (string what, string cure) Texts()
        {
            switch (Reason)
            {
                case BodyFollowing.Mirrored:
                    return ("was mirrored: the scale of the object or a parent changed its sign", "Keep the signs of scales during play.");
                case BodyFollowing.Scaled:
                    return ("was scaled more than tenfold within a frame, or to nothing", "Scale it over more frames, and not to zero.");
                case BodyFollowing.Reshaped:
                    return Source is CapsuleCollider || Source is CharacterController
                        ? ("changed its length over its radius", "Scale it evenly, or use a Mesh Collider in the shape of a capsule.")
                        : TerrainPatches.IsTerrain(Source as Collider)
                        ? ("has other heights or holes, or the domain went on to another part of it",
                            "Edit terrain where no liquid is, and keep the domain over one part of it.")
                        : ("has a mesh of other triangles",
                            "Give it a mesh with the same triangles, of which only the corners moved, or change it where no " +
                            "liquid is.");
                default:
                    return ("moved too far within a frame", "Move it over more frames, or reset the simulation after it was moved.");
            }
        }
    }
}
