using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>What a run knows at a sample besides its particles.</summary>
    public sealed class CaseReadings
    {
        /// <summary>Readings of a run without bodies.</summary>
        public static readonly CaseReadings None = new CaseReadings(Array.Empty<Vector3>());

        /// <summary>Readings at a sample.</summary>
        /// <param name="bodies">Where the origins of the set-up's bodies are [m], in the set-up's order.</param>
        public CaseReadings(IReadOnlyList<Vector3> bodies)
        {
            Bodies = bodies;
        }

        /// <summary>Where the origins of <see cref="CaseSetup.Bodies"/> are [m], simulation space, in their order. None of them turns.</summary>
        public IReadOnlyList<Vector3> Bodies { get; }
    }
}
