using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>A rectangle of a wall whose mean pressure a metric is told, where the method measures the force on walls.</summary>
    public readonly struct CasePatch
    {
        /// <summary>A rectangle.</summary>
        /// <param name="centre">Its middle, on the wall [m], simulation space.</param>
        /// <param name="normal">Out of the wall, towards the liquid.</param>
        /// <param name="up">Along its second edge.</param>
        /// <param name="size">Lengths of its edges [m], the second along <paramref name="up"/>.</param>
        public CasePatch(Vector3 centre, Vector3 normal, Vector3 up, Vector2 size)
        {
            Centre = centre;
            Rotation = Quaternion.LookRotation(normal, up);
            Size = size;
        }

        /// <summary>Its middle [m].</summary>
        public Vector3 Centre { get; }

        /// <summary>Its axes: edges along x and y, z towards the liquid.</summary>
        public Quaternion Rotation { get; }

        /// <summary>Lengths of its edges [m].</summary>
        public Vector2 Size { get; }
    }
}
