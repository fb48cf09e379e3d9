using UnityEngine;

namespace SphFluid
{
    /// <summary>A velocity that the liquid in a sphere gets once; world space, SI.</summary>
    internal readonly struct ZonePush
    {
        private readonly Vector3 centre, velocity;
        private readonly float radius, outward;

        /// <summary>Along one direction, and away from the centre; towards it where negative.</summary>
        public ZonePush(Vector3 centre, float radius, Vector3 velocity, float outward)
        {
            this.centre = centre;
            this.radius = radius;
            this.velocity = velocity;
            this.outward = outward;
        }

        /// <summary>The velocity's magnitude [m/s].</summary>
        public float Speed => velocity.magnitude + Mathf.Abs(outward);

        /// <summary>World position of its centre [m].</summary>
        public Vector3 Place => centre;

        /// <summary>How far it reaches from there [m].</summary>
        public float Reach => radius;

        /// <summary>A part of it.</summary>
        public ZonePush Weakened(float factor) => new ZonePush(centre, radius, factor * velocity, factor * outward);

        /// <summary>The force zone that gives the velocity within a time.</summary>
        /// <param name="worldToLocal">World to simulation space.</param>
        /// <param name="time">The time [s].</param>
        public ForceZone Zone(in DomainPose worldToLocal, float time)
        {
            var zone = new ForceZone { Core = new Vector4(0f, 0f, 0f, radius), Uniform = worldToLocal.MultiplyVector(velocity / time) };
            zone.Centre.w = -outward / time;
            zone.Place(worldToLocal.MultiplyPoint3x4(centre), Quaternion.identity);
            return zone;
        }
    }
}
