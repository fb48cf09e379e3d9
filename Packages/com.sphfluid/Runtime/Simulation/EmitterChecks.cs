using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Rules about emitters and drains.</summary>
    internal static class EmitterChecks
    {
        // Over the speed of sound: faster liquid is compressed by what it hits.
        private const double FastestShare = 0.25;

        /// <summary>What keeps an emitter from working; null when nothing does.</summary>
        /// <param name="emitter">The emitter.</param>
        /// <param name="spec">The simulation.</param>
        public static FluidMessage? Check(in EmitterSpec emitter, in FluidSpec spec)
        {
            if (emitter.Shape == FluidEmitterShape.Mesh)
            {
                if (CheckMesh(emitter, spec.Spacing) is FluidMessage wrong) return wrong;
            }
            else if (!AffineMath.IsFinite(emitter.Size.x) || !AffineMath.IsFinite(emitter.Size.y) ||
                !(emitter.Size.x > 0f && emitter.Size.y > 0f))
                return Wrong(emitter, FormattableString.Invariant($"The nozzle's size is {emitter.Size.x} x {emitter.Size.y} m."),
                    "Give Size two numbers greater than zero.");
            if (!AffineMath.IsFinite(emitter.Amount) || emitter.Amount < 0f)
            {
                return Wrong(emitter, FormattableString.Invariant($"The emitter's flow is {emitter.Amount}."),
                    "Give its speed or volume rate zero or a greater number.");
            }
            if (!AffineMath.IsFinite(emitter.Lifetime) || emitter.Lifetime < 0f)
            {
                return Wrong(emitter, FormattableString.Invariant($"The lifetime of the emitter's liquid is {emitter.Lifetime} s."),
                    "Give Lifetime zero, for ever, or a number of seconds.");
            }
            double speed = emitter.Speed(spec.Spacing), sites = emitter.Area(spec.Spacing) / ((double)spec.Spacing * spec.Spacing);
            if (sites > EmitterSites.Most)
            {
                return Wrong(emitter,
                    FormattableString.Invariant($"The nozzle needs {sites:0} particles a layer at a spacing of {spec.Spacing} m; ") +
                    FormattableString.Invariant($"{EmitterSites.Most} are allowed."),
                    "Use a smaller Size or a larger Particle Spacing.");
            }
            if (speed > FluidSpec.MostSpeed)
            {
                return Wrong(emitter,
                    FormattableString.Invariant($"The emitter gives liquid of {speed:0.###} m/s; {FluidSpec.MostSpeed} m/s are the most."),
                    "Use a larger Size, or less Speed or Volume Rate.");
            }
            return null;
        }

        /// <summary>That an emitter is to give another liquid than there is; null where it is not.</summary>
        public static FluidMessage? CheckLiquid(in EmitterSpec emitter, in FluidSpec spec)
        {
            if (emitter.Liquid == null || emitter.Liquid == spec.Liquid) return null;
            return new FluidMessage(FluidSeverity.Warning, FluidIssue.LiquidsDiffer, emitter.Owner,
                $"The emitter gives '{emitter.Liquid.name}', but '{spec.Name}' holds '{spec.Liquid.name}', and that flows: a simulation " +
                "has one liquid.",
                "Give both the same Liquid, or leave the emitter's empty; for two liquids use two simulations.");
        }

        /// <summary>Whether an emitter's liquid is too fast for a speed of sound [m/s].</summary>
        public static bool IsTooFast(in EmitterSpec emitter, in FluidSpec spec, double soundSpeed) =>
            emitter.Speed(spec.Spacing) > FastestShare * soundSpeed;

        /// <summary>What keeps a drain from working as it is set to; null when nothing does.</summary>
        public static FluidMessage? Check(in DrainSpec drain)
        {
            if (AffineMath.IsSingular(drain.Frame))
            {
                return new FluidMessage(FluidSeverity.Warning, FluidIssue.EmitterInvalid, drain.Owner,
                    "The drain has no volume, so nothing leaves there.",
                    "Give Size, or the drain's collider, and the scale of its object numbers greater than zero.");
            }
            if (drain.IgnoresCollider)
            {
                return new FluidMessage(FluidSeverity.Warning, FluidIssue.EmitterInvalid, drain.Owner,
                    "The drain's object has a collider that is no Box, Sphere or Capsule Collider: the box of Size is the drain.",
                    "Use one of these colliders, or move the drain to an object without a collider.");
            }
            return null;
        }

        /// <summary>Checks the emitters and drains of a simulation before it starts.</summary>
        public static void Check(in FluidSpec spec, List<FluidMessage> messages)
        {
            int count = (spec.Emitters?.Count ?? 0) + (spec.Drains?.Count ?? 0);
            if (count > 0 && FluidMethods.Has(spec.Method) && !FluidMethods.Has(spec.Method, FluidMethodFeatures.ChangingCount))
            {
                messages.Add(new FluidMessage(FluidSeverity.Warning, FluidIssue.EmitterInvalid, spec.Owner,
                    $"The method {spec.Method} has a fixed number of particles: its emitters and drains do nothing.",
                    "Set Method to Standard or Robust."));
            }
            for (int i = 0; i < (spec.Emitters?.Count ?? 0); i++)
            {
                if (Check(spec.Emitters[i], spec) is FluidMessage wrong) messages.Add(wrong);
                if (CheckLiquid(spec.Emitters[i], spec) is FluidMessage other) messages.Add(other);
            }
            for (int i = 0; i < (spec.Drains?.Count ?? 0); i++)
                if (Check(spec.Drains[i]) is FluidMessage wrong) messages.Add(wrong);
            if (spec.CapacityPolicy != FluidCapacityPolicy.Grow && spec.Capacity < 0)
            {
                messages
                    .Add(new FluidMessage(FluidSeverity.Error, FluidIssue.TooManyParticles, spec.Owner,
                        $"The capacity is {spec.Capacity} particles.",
                    "Give Capacity a number greater than zero, or zero for Max Particles of the profile."));
            }
        }

        /// <summary>Checks where the emitters of a simulation are before it starts; they may move later.</summary>
        public static void CheckPlaces(in FluidSpec spec, CollisionScene collision, List<FluidMessage> messages)
        {
            DomainPose worldToLocal = spec.WorldToLocal;
            for (int i = 0; i < (spec.Emitters?.Count ?? 0); i++)
            {
                EmitterSpec emitter = spec.Emitters[i];
                Vector3 place = worldToLocal.MultiplyPoint3x4(emitter.Position);
                if (!DomainSpace.Holds(place, spec.DomainSize))
                    messages.Add(new FluidMessage(FluidSeverity.Warning, FluidIssue.EmitterInvalid, emitter.Owner,
                        $"The emitter is outside the domain of '{spec.Name}': nothing flows while it is there.",
                        $"Move it into the domain, or enlarge {spec.SizeField}."));
                else if (collision.FindCovering(place, 0f) is int covering && covering >= 0)
                    messages.Add(new FluidMessage(FluidSeverity.Warning, FluidIssue.EmitterInvalid, emitter.Owner,
                        $"The emitter is inside the collider of {collision.NameOf(covering)}: its liquid starts inside and is squeezed.",
                        "Move the emitter to the opening, or take the collider's layer out of Collider Layers."));
            }
        }

        private static FluidMessage? CheckMesh(in EmitterSpec emitter, float spacing)
        {
            if (emitter.Mesh == null)
            {
                return Wrong(emitter, "The emitter's nozzle has the shape of a mesh, but it has no mesh.",
                    "Assign a mesh, or choose another Shape.");
            }
            if (!emitter.Mesh.isReadable)
            {
                return Wrong(emitter, $"The mesh '{emitter.Mesh.name}' of the emitter's nozzle is not readable.",
                    "Tick Read/Write in the mesh's import settings.");
            }
            if (emitter.UnderWater)
            {
                return Wrong(emitter, "A nozzle of the shape of a mesh has no pipe to pump through under water.",
                    "Switch Under Water off, or choose another Shape.");
            }
            if (EmitterOutline.Create(emitter, spacing).Places.Length == 0)
            {
                return Wrong(emitter,
                    FormattableString.Invariant($"The mesh '{emitter.Mesh.name}', seen along the emitter's forward axis, has no place ") +
                    FormattableString.Invariant($"for a particle at a spacing of {spacing} m, or for too many."),
                    "Turn or scale the emitter, so that the mesh is at least a spacing and at most a few hundred wide.");
            }
            return null;
        }

        internal static FluidMessage Wrong(in EmitterSpec emitter, string text, string cure) =>
            new FluidMessage(FluidSeverity.Error, FluidIssue.EmitterInvalid, emitter.Owner, text, cure);
    }
}
