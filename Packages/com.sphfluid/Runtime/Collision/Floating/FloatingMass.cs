using UnityEngine;

namespace SphFluid
{
    /// <summary>How a rigid body answers to impulses, SI.</summary>
    internal struct FloatingMass
    {
        private const float Rounding = 3e-6f;

        /// <summary>Mass [kg]; infinite: it does not move.</summary>
        public float Mass;

        /// <summary>Moments of inertia about the principal axes [kg m²]; infinite: it does not turn about the axis.</summary>
        public Vector3 Inertia;

        /// <summary>Gravity that acts on the body [m/s²], simulation space; 0 where none does.</summary>
        public Vector3 Gravity;

        /// <summary>What is lost of velocity and of angular velocity in a time, over it [1/s].</summary>
        public float Damping, AngularDamping;

        /// <summary>Row by row what velocities are multiplied by: the identity less the axes along which the body does not move.</summary>
        public Vector3 FreeX, FreeY, FreeZ;

        /// <summary>A body that is free to move.</summary>
        public FloatingMass(float mass, Vector3 inertia, Vector3 gravity)
        {
            Mass = mass;
            Inertia = inertia;
            Gravity = gravity;
            Damping = AngularDamping = 0f;
            FreeX = Vector3.right;
            FreeY = Vector3.up;
            FreeZ = Vector3.forward;
        }

        /// <summary>A box of even density: ρ a b c and m (b² + c²)/12.</summary>
        /// <param name="size">Edge lengths [m].</param>
        /// <param name="density">Density [kg/m³].</param>
        /// <param name="gravity">Gravity [m/s²].</param>
        public static FloatingMass Box(Vector3 size, float density, Vector3 gravity)
        {
            float mass = density * size.x * size.y * size.z;
            Vector3 squares = Vector3.Scale(size, size);
            return new FloatingMass(mass, mass / 12f * new Vector3(squares.y + squares.z, squares.z + squares.x, squares.x + squares.y),
                gravity);
        }

        /// <summary>One that nothing moves.</summary>
        public static FloatingMass Held => default;

        /// <summary>The part of a vector along which the body moves.</summary>
        public Vector3 Free(Vector3 v) => new Vector3(Vector3.Dot(FreeX, v), Vector3.Dot(FreeY, v), Vector3.Dot(FreeZ, v));

        /// <summary>1/kg.</summary>
        public float InverseMass => Inverse(Mass);

        /// <summary>1/(kg m²).</summary>
        public Vector3 InverseInertia => new Vector3(Inverse(Inertia.x), Inverse(Inertia.y), Inverse(Inertia.z));

        /// <summary>
        /// Whether another is the same but for the rounding with which moments of inertia are found again as a body turns.
        /// </summary>
        public bool IsNear(in FloatingMass other) => IsNear(Mass, other.Mass) && IsNear(Damping, other.Damping) &&
            IsNear(AngularDamping, other.AngularDamping) &&
            IsNear(Inertia, other.Inertia) && IsNear(Gravity, other.Gravity) && IsNear(FreeX, other.FreeX) && IsNear(FreeY, other.FreeY) &&
            IsNear(FreeZ, other.FreeZ);

        private static bool IsNear(Vector3 a, Vector3 b) => a.Equals(b) || (a - b).magnitude <= Rounding * b.magnitude;

        private static bool IsNear(float a, float b) => a.Equals(b) || Mathf.Abs(a - b) <= Rounding * Mathf.Abs(b);

        // Unity gives 0 for what is frozen.
        private static float Inverse(float value) => value > 0f && !float.IsInfinity(value) ? 1f / value : 0f;
    }
}
