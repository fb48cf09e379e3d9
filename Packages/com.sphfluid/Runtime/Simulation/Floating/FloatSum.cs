using UnityEngine;

namespace SphFluid
{
    /// <summary>Bodies that rest on each other, as one rigid body.</summary>
    internal struct FloatSum
    {
        private readonly Vector3 origin;
        private Vector3 moment, force, torque, inertiaX, inertiaY, inertiaZ; // about the origin

        /// <param name="origin">A place in or near it [m].</param>
        public FloatSum(Vector3 origin) : this()
        {
            this.origin = origin;
        }

        /// <summary>Mass of all [kg].</summary>
        public float Mass { get; private set; }

        /// <summary>What turns the stack about its centre of mass [N m].</summary>
        public Vector3 Torque
        {
            get => torque - Vector3.Cross(Centre, force);
            set => torque = value + Vector3.Cross(Centre, force);
        }

        private Vector3 Centre => moment / Mass;

        /// <summary>Adds a body.</summary>
        /// <param name="body">How it answers to impulses; free to move.</param>
        /// <param name="pose">Where it is.</param>
        /// <param name="acceleration">What moves it, if nothing of the stack did [m/s²].</param>
        /// <param name="angularAcceleration">What turns it [rad/s²].</param>
        public void Add(in FloatingMass body, in FloatingPose pose, Vector3 acceleration, Vector3 angularAcceleration)
        {
            Vector3 arm = pose.Centre - origin, given = body.Mass * acceleration;
            Mass += body.Mass;
            moment += body.Mass * arm;
            force += given;
            torque += Vector3.Cross(arm, given) + Turned(body, pose, angularAcceleration);
            inertiaX += Turned(body, pose, Vector3.right) + Swung(body.Mass, arm, Vector3.right);
            inertiaY += Turned(body, pose, Vector3.up) + Swung(body.Mass, arm, Vector3.up);
            inertiaZ += Turned(body, pose, Vector3.forward) + Swung(body.Mass, arm, Vector3.forward);
        }

        /// <summary>How all that was added moves a place of it.</summary>
        /// <param name="place">Where [m].</param>
        /// <param name="angularAcceleration">How it turns the stack [rad/s²].</param>
        /// <returns>The acceleration [m/s²].</returns>
        public Vector3 At(Vector3 place, out Vector3 angularAcceleration)
        {
            Vector3 centre = Centre, about = Torque;
            Vector3 x = inertiaX - Swung(Mass, centre, Vector3.right), y = inertiaY - Swung(Mass, centre, Vector3.up),
                z = inertiaZ - Swung(Mass, centre, Vector3.forward);
            Vector3 yz = Vector3.Cross(y, z); // the rows of a symmetric matrix: their products are those of its inverse
            angularAcceleration = (about.x * yz + about.y * Vector3.Cross(z, x) + about.z * Vector3.Cross(x, y)) / Vector3.Dot(x, yz);
            return force / Mass + Vector3.Cross(angularAcceleration, place - origin - centre);
        }

        private static Vector3 Turned(in FloatingMass body, in FloatingPose pose, Vector3 spin) =>
            pose.Rotation * Vector3.Scale(body.Inertia, Quaternion.Inverse(pose.Rotation) * spin);

        private static Vector3 Swung(float mass, Vector3 arm, Vector3 spin) =>
            mass * (arm.sqrMagnitude * spin - Vector3.Dot(arm, spin) * arm);
    }
}
