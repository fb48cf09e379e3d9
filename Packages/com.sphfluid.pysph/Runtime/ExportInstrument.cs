using UnityEngine;

namespace SphFluid
{
    /// <summary>A probe or a gauge of an exported liquid, where it is at the start.</summary>
    internal struct ExportInstrument
    {
        public string Name;

        /// <summary>What is read: p, rho, u, v or w, as PySPH calls it, of a probe; height of a gauge.</summary>
        public string Property;

        /// <summary>Place, or of a gauge its lower end [m], simulation space.</summary>
        public Vector3 Place;

        /// <summary>Direction of a gauge, length 1, simulation space.</summary>
        public Vector3 Up;

        /// <summary>Length of a gauge [m].</summary>
        public float Length;
    }
}
