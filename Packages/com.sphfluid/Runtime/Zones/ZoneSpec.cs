using UnityEngine;

namespace SphFluid
{
    /// <summary>What a force zone is, as of one moment.</summary>
    internal struct ZoneSpec
    {
        /// <summary>The component: the context of messages.</summary>
        public Component Owner;

        /// <summary>What outlives the moment.</summary>
        public ZoneState State;

        public Vector3 Position;
        public Quaternion Rotation;
        public FluidForceKind Kind;

        /// <summary>
        /// Box, sphere or capsule; <see cref="FluidZoneShape.Collider"/> where the object has no collider of such a shape.
        /// </summary>
        public FluidZoneShape Shape;

        /// <summary>From the zone's axes, along which it pushes, to those of its shape.</summary>
        public Quaternion ShapeTurn;

        /// <summary>Edge lengths [m].</summary>
        public Vector3 Size;

        /// <summary>Acceleration [m/s²].</summary>
        public float Strength;

        /// <summary>Speed of the wind [m/s].</summary>
        public float WindSpeed;

        /// <summary>Rate of drag [1/s].</summary>
        public float DragRate;

        /// <summary>Size of the eddies [m], and how long one lasts [s]; 0: for ever.</summary>
        public float EddySize, EddyTime;

        /// <summary>The owner's name.</summary>
        public readonly string Name => Owner.name;

        /// <summary>Whether it drags and does not push.</summary>
        public readonly bool IsDrag => Kind == FluidForceKind.Wind || Kind == FluidForceKind.Damping;

        /// <summary>Label of the first field that the kind uses and that cannot be computed with; null: all can.</summary>
        public readonly string Fault
        {
            get
            {
                bool isTurbulence = Kind == FluidForceKind.Turbulence;
                if (!AffineMath.IsFinite(Position)) return "place";
                if (!AffineMath.IsFinite(Size) || !(Size.x > 0f && Size.y > 0f && Size.z > 0f)) return "Size";
                if (IsDrag && !(DragRate >= 0f && AffineMath.IsFinite(DragRate))) return "Drag Rate";
                if (Kind == FluidForceKind.Wind && !AffineMath.IsFinite(WindSpeed)) return "Wind Speed";
                if (!IsDrag && !AffineMath.IsFinite(Strength)) return "Strength";
                if (isTurbulence && !(EddySize > 0f && AffineMath.IsFinite(EddySize))) return "Eddy Size";
                return isTurbulence && !(EddyTime >= 0f && AffineMath.IsFinite(EddyTime)) ? "Eddy Time" : null;
            }
        }

        /// <summary>How far it reaches from its position [m].</summary>
        public readonly float Reach => new Vector3(Core.x, Core.y, Core.z).magnitude + Core.w;

        /// <summary>
        /// Speed that liquid can get in it [m/s], on a straight path: v² + 2 a L over the length on which it pushes; of drag, its wind.
        /// </summary>
        /// <param name="speed">Speed with which it comes in [m/s].</param>
        /// <param name="domain">Edge lengths of the domain [m].</param>
        /// <param name="simulation">Rotation of the simulation.</param>
        public readonly double SpeedFrom(double speed, Vector3 domain, Quaternion simulation)
        {
            if (IsDrag) return Kind == FluidForceKind.Wind && DragRate > 0f ? System.Math.Max(speed, System.Math.Abs(WindSpeed)) : speed;
            Vector3 along = Quaternion.Inverse(simulation) * Rotation * Vector3.forward;
            double length = Kind switch
            {
                FluidForceKind.Directional => System.Math.Min(Shape == FluidZoneShape.Box ? Size.z : Size.x,
                    Mathf.Abs(along.x) * domain.x + Mathf.Abs(along.y) * domain.y + Mathf.Abs(along.z) * domain.z),
                FluidForceKind.Turbulence => EddySize,
                _ => System.Math.Min(Reach, 0.5 * domain.magnitude), // of a vortex about half a turn through the middle of the radius
            };
            return System.Math.Sqrt(speed * speed + 2.0 * System.Math.Abs(Strength) * length);
        }

        /// <summary>The zone on the GPU.</summary>
        /// <param name="worldToLocal">World to simulation space.</param>
        /// <param name="simulation">Rotation of the simulation.</param>
        /// <param name="time">The liquid's time [s].</param>
        public readonly ForceZone Zone(in DomainPose worldToLocal, Quaternion simulation, double time)
        {
            Quaternion turn = Quaternion.Inverse(simulation) * Rotation;
            Vector3 forward = turn * Vector3.forward, up = turn * Vector3.up;
            var zone = new ForceZone { Core = Core };
            switch (Kind)
            {
                case FluidForceKind.Directional:
                    zone.Uniform = Strength * forward;
                    break;
                case FluidForceKind.Point:
                    zone.Centre.w = Strength;
                    break;
                case FluidForceKind.Vortex:
                    zone.Axis = new Vector4(up.x, up.y, up.z, Strength);
                    break;
                case FluidForceKind.Turbulence:
                    float phase = EddyTime > 0f ? (float)(time / EddyTime * 2.0 * System.Math.PI % 1e4) : 0f;
                    zone.Eddies = new Vector4(Strength, Mathf.PI / EddySize, phase, 0f);
                    break;
                default:
                    Vector3 wind = Kind == FluidForceKind.Wind ? WindSpeed * forward : Vector3.zero;
                    zone.Wind = new Vector4(wind.x, wind.y, wind.z, DragRate);
                    break;
            }
            zone.Place(worldToLocal.MultiplyPoint3x4(Position), turn * ShapeTurn);
            return zone;
        }

        /// <summary>The zone that gives a velocity within a time, everywhere along one direction.</summary>
        /// <param name="worldToLocal">World to simulation space.</param>
        /// <param name="simulation">Rotation of the simulation.</param>
        /// <param name="acceleration">The acceleration [m/s²], world space.</param>
        public readonly ForceZone Burst(in DomainPose worldToLocal, Quaternion simulation, Vector3 acceleration)
        {
            var zone = new ForceZone { Core = Core, Uniform = worldToLocal.MultiplyVector(acceleration) };
            zone.Place(worldToLocal.MultiplyPoint3x4(Position), Quaternion.Inverse(simulation) * Rotation * ShapeTurn);
            return zone;
        }

        private readonly Vector4 Core => Shape switch
        {
            FluidZoneShape.Sphere => new Vector4(0f, 0f, 0f, 0.5f * Size.x),
            FluidZoneShape.Capsule => new Vector4(0f, Mathf.Max(0f, 0.5f * (Size.y - Size.x)), 0f, 0.5f * Size.x),
            _ => 0.5f * Size,
        };
    }

    /// <summary>What a force zone is to do once.</summary>
    internal sealed class ZoneState
    {
        /// <summary>Velocity to be given with the next steps [m/s], world space.</summary>
        public Vector3 Burst;

        /// <summary>The liquid that was said to be made too fast.</summary>
        public object FastIn;
    }
}
