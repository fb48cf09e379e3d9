using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Rules about one liquid volume, and its shape as the spawner needs it.</summary>
    internal static class VolumeChecks
    {
        // Of a box that is drawn out to walls, before it is worth a word.
        private const double MostGrown = 0.02;

        /// <summary>The shape of a volume among the colliders gathered in <paramref name="collision"/>.</summary>
        /// <returns>Null when an error was added to the messages.</returns>
        public static LiquidShape Check(in VolumeSpec volume, in FluidSpec spec, CollisionScene collision, List<FluidMessage> messages)
        {
            DomainPose worldToLocal = spec.WorldToLocal;
            Matrix4x4 toSimulation = worldToLocal * volume.LocalToWorld;
            Vector3 velocity = worldToLocal.MultiplyVector(volume.Rotation * volume.InitialVelocity);
            if (!AffineMath.IsFinite(volume.InitialVelocity.sqrMagnitude))
            {
                return Fail(volume, messages,
                    $"The liquid volume's initial velocity is {volume.InitialVelocity} m/s, which cannot be computed with.",
                    "Give Initial Velocity three finite numbers.");
            }
            if (volume.Shape == FluidVolumeShape.Vessel) return Vessel(volume, spec, collision, velocity, messages);
            if (AffineMath.IsSingular(toSimulation))
            {
                return Fail(volume, messages, "The liquid volume's transform has a zero or non-finite scale.",
                    "Give the object and its parents a scale without zeros.");
            }
            if (volume.Shape == FluidVolumeShape.Mesh) return Mesh(volume, toSimulation, velocity, messages);

            Vector3 size = volume.Size;
            if (!AffineMath.IsFinite(size) || !(size.x > 0f && size.y > 0f && size.z > 0f))
            {
                return Fail(volume, messages, $"The liquid volume's size is {FluidMessage.Lengths(size)} m.",
                    "Give Size three numbers greater than zero.");
            }
            Matrix4x4 frame = worldToLocal * (volume.LocalToWorld * Matrix4x4.Scale(size));
            if (volume.Shape == FluidVolumeShape.Sphere) return new LiquidEllipsoid(volume.Name, frame, velocity);
            return LatticeFit.IsAligned(frame) ? Fitted(volume, frame, spec, velocity, messages)
                : new LiquidBox(volume.Name, frame, velocity);
        }

        private static LiquidBox Fitted(in VolumeSpec volume, in Matrix4x4 frame, in FluidSpec spec, Vector3 velocity,
            List<FluidMessage> messages)
        {
            FluidFaces walls = spec.Boundaries.Walls;
            Bounds box = AffineMath.BoundsOf(frame, Vector3.one);
            Bounds fitted = WallFit.DrawnOut(box, spec.DomainSize, walls, spec.Spacing, spec.LocalGravity);
            double growth = VolumeOf(fitted) / VolumeOf(box) - 1.0;
            if (growth > MostGrown)
            {
                messages.Add(new FluidMessage(FluidSeverity.Info, FluidIssue.VolumeDrawnOut, volume.Owner,
                    "The liquid volume ends less than a spacing from the domain's walls. It is drawn out to " +
                    FormattableString.Invariant($"them, so that it rests there: {100.0 * growth:0.#} % more liquid."),
                    "To have no message, let the volume end at the walls, or more than a spacing from them."));
            }
            bool stays = fitted == box && new Vector3(frame.m00, frame.m11, frame.m22) == box.size;
            return new LiquidBox(volume.Name, stays ? frame : Matrix4x4.TRS(fitted.center, Quaternion.identity, fitted.size), velocity,
                WallFit.At(fitted, spec.DomainSize, walls, spec.Spacing));
        }

        private static double VolumeOf(Bounds box) => (double)box.size.x * box.size.y * box.size.z;

        /// <summary>Checks whether a vessel that was fitted holds its liquid.</summary>
        /// <returns>False when an error was added to the messages.</returns>
        public static bool CheckVessel(in VolumeSpec volume, LiquidVessel vessel, in FluidSpec spec, List<FluidMessage> messages)
        {
            if (vessel.IsTooFine)
            {
                messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.TooManyParticles, volume.Owner,
                    FormattableString.Invariant($"The vessel has more than {VesselCells.Most} places for particles at a spacing of ") +
                    FormattableString.Invariant($"{spec.Spacing} m."),
                    "Use a larger Particle Spacing or a smaller domain."));
                return false;
            }
            if (!(vessel.Leak is VesselLeak leak)) return true;
            Vector3 place = spec.LocalToWorld.MultiplyPoint3x4(leak.Position);
            string near = FormattableString.Invariant($"near ({place.x:0.###}, {place.y:0.###}, {place.z:0.###})");
            bool rim = leak.HoldsTo > 0f;
            string outlet = rim
                ? FormattableString.Invariant($"over its rim {near} at a level of {volume.Level:0.###} m.")
                : $"through a gap {near}.";
            string cure = rim
                ? FormattableString.Invariant($"Set Level to {leak.HoldsTo:0.###} m or less")
                : "Close the gap in the colliders";
            messages
                .Add(new FluidMessage(FluidSeverity.Error, FluidIssue.VesselLeaks, volume.Owner,
                    "The liquid runs out of the vessel " + outlet,
                cure + ", or switch Domain Holds on if the domain's faces are to hold the liquid too."));
            return false;
        }

        private static LiquidShape Mesh(in VolumeSpec volume, in Matrix4x4 toSimulation, Vector3 velocity, List<FluidMessage> messages)
        {
            Mesh mesh = volume.FilledMesh;
            if (mesh == null)
            {
                return Fail(volume, messages, "The liquid volume has no mesh.",
                    "Assign a closed mesh, or add a Mesh Filter that has one.", FluidIssue.VolumeMeshInvalid);
            }
            if (!mesh.isReadable)
            {
                return Fail(volume, messages, $"The liquid volume's mesh '{mesh.name}' cannot be read.",
                    "Tick Read/Write in the mesh's import settings.", FluidIssue.VolumeMeshInvalid);
            }
            TriangleMesh triangles = new MeshReader().Read(mesh);
            if (triangles.TriangleCount == 0)
            {
                return Fail(volume, messages, $"The liquid volume's mesh '{mesh.name}' has no triangles.",
                    "Assign a closed mesh.", FluidIssue.VolumeMeshInvalid);
            }
            if (!triangles.IsClosed)
            {
                return Fail(volume, messages,
                    $"The liquid volume's mesh '{mesh.name}' is open: {triangles.OpenEdges().Count} edges do not join two triangles, so " +
                    "it has no inside.",
                    "Close the mesh's holes in the program that made it, or use the shape Vessel with a Mesh Collider.",
                    FluidIssue.VolumeMeshInvalid);
            }
            return new LiquidMesh(volume.Name, triangles.Transformed(toSimulation), velocity);
        }

        private static LiquidShape Vessel(in VolumeSpec volume, in FluidSpec spec, CollisionScene collision, Vector3 velocity,
            List<FluidMessage> messages)
        {
            if (!AffineMath.IsFinite(volume.Level) || !(volume.Level > 0f))
            {
                return Fail(volume, messages, FormattableString.Invariant($"The vessel's level is {volume.Level} m."),
                    "Place the object in the hollow and give Level the height of the surface above it, a number greater than zero.");
            }
            Vector3 gravity = spec.LocalGravity;
            Vector3 up = gravity.sqrMagnitude > 0f ? -gravity.normalized : Quaternion.Inverse(spec.Rotation) * Vector3.up;
            var input = new VesselInput
            {
                Seed = spec.WorldToLocal.MultiplyPoint3x4(volume.Position),
                Up = up,
                Level = volume.Level,
                DomainHolds = volume.DomainHolds,
                DomainSize = spec.DomainSize,
                Colliders = collision,
                Clearance = SpawnRequest.ObstacleClearance * spec.Spacing,
            };
            return new LiquidVessel(volume.Name, input, velocity);
        }

        private static LiquidShape Fail(in VolumeSpec volume, List<FluidMessage> messages, string text, string cure,
            FluidIssue issue = FluidIssue.VolumeSizeInvalid)
        {
            messages.Add(new FluidMessage(FluidSeverity.Error, issue, volume.Owner, text, cure));
            return null;
        }
    }
}
