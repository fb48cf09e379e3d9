using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Mass, centre of mass and principal axes of a Rigidbody, in simulation space.</summary>
    internal static class RigidbodyMass
    {
        /// <summary>How it answers to impulses. Frozen positions are the world's axes, frozen rotations the body's own.</summary>
        /// <param name="body">The body.</param>
        /// <param name="toSimulation">Rotation of the world to simulation space.</param>
        public static FloatingMass Read(Rigidbody body, Quaternion toSimulation)
        {
            RigidbodyConstraints constraints = body.constraints;
            var mass =
                new FloatingMass(body.mass, Moments(body, constraints), body.useGravity ? toSimulation * Physics.gravity : Vector3.zero);
#if UNITY_6000_0_OR_NEWER
            (mass.Damping, mass.AngularDamping) = (body.linearDamping, body.angularDamping);
#else
            (mass.Damping, mass.AngularDamping) = (body.drag, body.angularDrag);
#endif
            if ((constraints & RigidbodyConstraints.FreezePosition) == 0) return mass;
            for (int axis = 0; axis < 3; axis++)
            {
                if (((int)constraints & ((int)RigidbodyConstraints.FreezePositionX << axis)) == 0) continue;
                Vector3 frozen = Vector3.zero;
                frozen[axis] = 1f;
                frozen = toSimulation * frozen;
                mass.FreeX -= frozen.x * frozen;
                mass.FreeY -= frozen.y * frozen;
                mass.FreeZ -= frozen.z * frozen;
            }

            return mass;
        }

        /// <summary>Axes of the moments in the body's own frame: those that are frozen are its own.</summary>
        public static Quaternion Axes(Rigidbody body) =>
            (body.constraints & RigidbodyConstraints.FreezeRotation) == 0 ? body.inertiaTensorRotation : Quaternion.identity;

        // A frozen axis has no finite moment; the others have their own entry of the tensor, as where products of inertia are none.
        private static Vector3 Moments(Rigidbody body, RigidbodyConstraints constraints)
        {
            Vector3 principal = body.inertiaTensor;
            if ((constraints & RigidbodyConstraints.FreezeRotation) == 0) return principal;
            Quaternion axes = Quaternion.Inverse(body.inertiaTensorRotation);
            Vector3 moments = Vector3.zero;
            for (int axis = 0; axis < 3; axis++)
            {
                if (((int)constraints & ((int)RigidbodyConstraints.FreezeRotationX << axis)) != 0) continue;
                Vector3 direction = Vector3.zero;
                direction[axis] = 1f;
                direction = axes * direction;
                moments[axis] = principal.x * direction.x * direction.x + principal.y * direction.y * direction.y +
                    principal.z * direction.z * direction.z;
            }

            return moments;
        }
    }
}
