using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Rules about one liquid volume, and its shape as the spawner needs it.</summary>
    internal static class VolumeRules
    {
        /// <summary>The shape of a volume among the colliders gathered in <paramref name="collision"/>.</summary>
        /// <returns>Null when an error was added to the messages.</returns>
        public static LiquidShape Check(FluidVolume volume, FluidSimulation simulation, CollisionScene collision, List<FluidMessage> messages)
        {
            Matrix4x4 worldToLocal = FluidScene.WorldToLocal(simulation.transform);
            Matrix4x4 toSimulation = worldToLocal * volume.transform.localToWorldMatrix;
            Vector3 velocity = worldToLocal.MultiplyVector(volume.transform.rotation * volume.InitialVelocity);
            if (!AffineMath.IsFinite(volume.InitialVelocity))
                return Fail(volume, messages, "The liquid volume's initial velocity is not a finite number.",
                    "Give Initial Velocity three finite numbers.");
            if (volume.Shape == FluidVolumeShape.Vessel) return Vessel(volume, simulation, collision, velocity, messages);
            if (AffineMath.IsSingular(toSimulation))
                return Fail(volume, messages, "The liquid volume's transform has a zero or non-finite scale.",
                    "Give the object and its parents a scale without zeros.");
            if (volume.Shape == FluidVolumeShape.Mesh) return Mesh(volume, toSimulation, velocity, messages);

            Vector3 size = volume.Size;
            if (!AffineMath.IsFinite(size) || !(size.x > 0f && size.y > 0f && size.z > 0f))
                return Fail(volume, messages, $"The liquid volume's size is {FluidValidation.Text(size)} m.",
                    "Give Size three numbers greater than zero.");
            Matrix4x4 frame = worldToLocal * (volume.transform.localToWorldMatrix * Matrix4x4.Scale(size));
            if (volume.Shape == FluidVolumeShape.Sphere) return new LiquidEllipsoid(volume.name, frame, velocity);
            return new LiquidBox(volume.name, frame, velocity);
        }

        /// <summary>Tells whether a vessel that was fitted holds its liquid.</summary>
        /// <returns>False when an error was added to the messages.</returns>
        public static bool CheckVessel(FluidVolume volume, LiquidVessel vessel, FluidSimulation simulation, List<FluidMessage> messages)
        {
            if (vessel.IsTooFine)
            {
                messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.TooManyParticles, volume,
                    FormattableString.Invariant($"The vessel has more than {VesselCells.Most} places for particles at a spacing of {simulation.Spacing} m."),
                    "Use a larger Particle Spacing or a smaller domain."));
                return false;
            }
            if (!(vessel.Leak is VesselLeak leak)) return true;
            Vector3 place = FluidScene.LocalToWorld(simulation.transform).MultiplyPoint3x4(leak.Position);
            string near = FormattableString.Invariant($"near ({place.x:0.###}, {place.y:0.###}, {place.z:0.###})");
            bool rim = leak.HoldsTo > 0f;
            string way = rim
                ? FormattableString.Invariant($"over its rim {near} at a level of {volume.Level:0.###} m.")
                : $"through a gap {near}.";
            string cure = rim
                ? FormattableString.Invariant($"Set Level to {leak.HoldsTo:0.###} m or less")
                : "Close the gap in the colliders";
            messages.Add(new FluidMessage(FluidSeverity.Error, FluidIssue.VesselLeaks, volume, "The liquid runs out of the vessel " + way,
                cure + ", or switch Domain Holds on if the domain's faces are to hold the liquid too."));
            return false;
        }

        static LiquidShape Mesh(FluidVolume volume, in Matrix4x4 toSimulation, Vector3 velocity, List<FluidMessage> messages)
        {
            Mesh mesh = volume.FilledMesh;
            if (mesh == null)
                return Fail(volume, messages, "The liquid volume has no mesh.",
                    "Assign a closed mesh, or add a Mesh Filter that has one.", FluidIssue.VolumeMeshInvalid);
            if (!mesh.isReadable)
                return Fail(volume, messages, $"The liquid volume's mesh '{mesh.name}' cannot be read.",
                    "Tick Read/Write in the mesh's import settings.", FluidIssue.VolumeMeshInvalid);
            TriangleMesh triangles = new MeshReader().Read(mesh);
            if (triangles.TriangleCount == 0)
                return Fail(volume, messages, $"The liquid volume's mesh '{mesh.name}' has no triangles.",
                    "Assign a closed mesh.", FluidIssue.VolumeMeshInvalid);
            if (!triangles.IsClosed)
                return Fail(volume, messages, $"The liquid volume's mesh '{mesh.name}' is open: {triangles.OpenEdges} edges do not join two triangles, so it has no inside.",
                    "Close the mesh's holes in the program that made it, or use the shape Vessel with a Mesh Collider.", FluidIssue.VolumeMeshInvalid);
            return new LiquidMesh(volume.name, triangles.Transformed(toSimulation), velocity);
        }

        static LiquidShape Vessel(FluidVolume volume, FluidSimulation simulation, CollisionScene collision, Vector3 velocity, List<FluidMessage> messages)
        {
            if (!AffineMath.IsFinite(volume.Level) || !(volume.Level > 0f))
                return Fail(volume, messages, FormattableString.Invariant($"The vessel's level is {volume.Level} m."),
                    "Place the object in the hollow and give Level the height of the surface above it, a number greater than zero.");
            Vector3 gravity = simulation.LocalGravity;
            Vector3 up = gravity.sqrMagnitude > 0f ? -gravity.normalized : Quaternion.Inverse(simulation.transform.rotation) * Vector3.up;
            var input = new VesselInput
            {
                Seed = FluidScene.WorldToLocal(simulation.transform).MultiplyPoint3x4(volume.transform.position),
                Up = up,
                Level = volume.Level,
                DomainHolds = volume.DomainHolds,
                DomainSize = simulation.DomainSize,
                Colliders = collision,
                Clearance = FluidScene.ObstacleClearance * simulation.Spacing,
            };
            return new LiquidVessel(volume.name, input, velocity);
        }

        static LiquidShape Fail(FluidVolume volume, List<FluidMessage> messages, string text, string cure, FluidIssue issue = FluidIssue.VolumeSizeInvalid)
        {
            messages.Add(new FluidMessage(FluidSeverity.Error, issue, volume, text, cure));
            return null;
        }
    }
}
