using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The pipes of a simulation's emitters that stand in liquid.</summary>
    internal static class EmitterPipes
    {
        /// <summary>Their walls as colliders have them; null where there is none.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="walls">Filled anew.</param>
        public static List<ColliderState> Walls(in FluidSpec spec, List<ColliderState> walls)
        {
            walls.Clear();
            for (int i = 0; i < (spec.Emitters?.Count ?? 0); i++)
            {
                EmitterSpec emitter = spec.Emitters[i];
                if (!emitter.UnderWater || EmitterChecks.Check(emitter, spec) != null) continue;
                Matrix4x4 toSimulation = spec.WorldToLocal * Matrix4x4.TRS(emitter.Position, emitter.Rotation, Vector3.one);
                walls
                    .Add(new ColliderState(emitter.Owner, EmitterPipe.Create(emitter, spec.Spacing, spec.SupportRadius).Mesh,
                        ColliderSettings.DomainFriction, toSimulation));
            }
            return walls.Count > 0 ? walls : null;
        }

        /// <summary>Whether an emitter drives the liquid in its pipe.</summary>
        /// <param name="emitter">The emitter.</param>
        /// <param name="spec">The simulation.</param>
        /// <param name="soundSpeed">Its speed of sound [m/s].</param>
        /// <param name="zone">The zone that does.</param>
        public static bool TryDrive(in EmitterSpec emitter, in FluidSpec spec, double soundSpeed, out ForceZone zone)
        {
            zone = default;
            if (!emitter.UnderWater || !emitter.State.IsOn || EmitterChecks.Check(emitter, spec) != null ||
                EmitterChecks.IsTooFast(emitter, spec, soundSpeed))
            {
                return false;
            }
            Quaternion rotation = Quaternion.Inverse(spec.Rotation) * emitter.Rotation;
            Vector3 velocity = rotation * new Vector3(0f, 0f, (float)emitter.Speed(spec.Spacing)) + emitter.State.Carried;
            zone = EmitterPipe.Create(emitter, spec.Spacing, spec.SupportRadius)
                .Drive(spec.WorldToLocal.MultiplyPoint3x4(emitter.Position), rotation, velocity);
            return true;
        }
    }
}
