using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What a run knows at a sample besides its particles.</summary>
    public sealed class CaseReadings
    {
        /// <summary>Readings of a run without bodies and patches.</summary>
        public static readonly CaseReadings None = new CaseReadings(Array.Empty<Vector3>());

        /// <summary>Readings at a sample.</summary>
        /// <param name="bodies">Where the origins of the set-up's bodies are [m], in the set-up's order.</param>
        /// <param name="pressures">Mean pressures on the set-up's patches since the last sample [Pa], in the set-up's order; null for
        /// none.</param>
        public CaseReadings(IReadOnlyList<Vector3> bodies, IReadOnlyList<double> pressures = null)
        {
            Bodies = bodies;
            Pressures = pressures ?? Array.Empty<double>();
        }

        /// <summary>
        /// Force per area on <see cref="CaseSetup.Patches"/> over the time since the sample before [Pa], in their order; not numbers at the
        /// first sample; empty where the method does not measure it.
        /// </summary>
        public IReadOnlyList<double> Pressures { get; }

        /// <summary>
        /// Where the origins of <see cref="CaseSetup.Bodies"/> are [m], simulation space, in their order. None of them turns.
        /// </summary>
        public IReadOnlyList<Vector3> Bodies { get; }
    }
}
