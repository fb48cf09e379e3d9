using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>All that a preview of a simulation's start follows from, besides its colliders.</summary>
    internal sealed class PreviewKey
    {
        private readonly FluidStartKey start;
        private readonly FluidLiveKey live;
        private readonly Vector3 position;
        private readonly Quaternion rotation;
        private readonly (FluidCapacityPolicy policy, int capacity) slots;
        private readonly VolumeSpec[] volumes;
        private readonly EmitterSpec[] emitters;
        private readonly int costs;

        /// <summary>As of now.</summary>
        public PreviewKey(in FluidSpec spec, IReadOnlyList<VolumeSpec> volumes)
        {
            start = FluidStartKey.Create(spec);
            live = FluidLiveKey.AsGiven(spec);
            (position, rotation) = (spec.Position, spec.Rotation);
            slots = (spec.CapacityPolicy, spec.Capacity);
            this.volumes = ToArray(volumes);
            emitters = ToArray(spec.Emitters);
            costs = spec.Automatic.IsOn ? StepCosts.Revision : 0;
        }

        /// <summary>Whether nothing changed.</summary>
        public bool Is(PreviewKey other) => other != null && start.Equals(other.start) && live.Equals(other.live) &&
            position.Equals(other.position) &&
            rotation.Equals(other.rotation) && slots == other.slots && costs == other.costs && Same(volumes, other.volumes) &&
            Same(emitters, other.emitters);

        private static T[] ToArray<T>(IReadOnlyList<T> items)
        {
            var array = new T[items?.Count ?? 0];
            for (int i = 0; i < array.Length; i++) array[i] = items[i];
            return array;
        }

        private static bool Same<T>(T[] a, T[] b) where T : struct
        {
            if (a.Length != b.Length) return false;
            for (int i = 0; i < a.Length; i++)
                if (!a[i].Equals(b[i])) return false;
            return true;
        }
    }
}
