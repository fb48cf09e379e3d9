using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A collider as the affine image of a shape of its own: a unit box, a sphere or capsule of radius 1, or a mesh. Two states whose
    /// own shapes are the same differ by an affine map, which contact can follow.
    /// </summary>
    internal static class ColliderFrame
    {
        // Of a capsule's length over its radius: what rounding may change.
        private const double AspectTolerance = 1e-5;

        /// <summary>Whether two states of a collider have the same own shape.</summary>
        public static bool HasSameShape(in ColliderState a, in ColliderState b)
        {
            if (!a.HasMeshOf(b)) return false;
            if (!(a.Collider is CapsuleCollider || a.Collider is CharacterController)) return true;
            if (a.Size.z != b.Size.z) return false;
            double first = RoundShape.FromCollider(a).Aspect, second = RoundShape.FromCollider(b).Aspect;
            return Math.Abs(first - second) <= AspectTolerance * Math.Max(1.0, first);
        }

        /// <summary>
        /// Whether the same triangles with other corners are the same wall deformed: of a mesh; of a Character Controller, which stands
        /// upright. A terrain's patch goes with the domain, and a capsule's corners turn about its axis as it turns.
        /// </summary>
        public static bool MayDeform(in ColliderState state) => state.Collider is MeshCollider || state.Collider is CharacterController ||
            state.Collider == null;

        /// <summary>The own shape's space to simulation space.</summary>
        public static AffineMap GetMap(in ColliderState state)
        {
            AffineMap toSimulation = AffineMap.FromMatrix(state.ToSimulation);
            switch (state.Collider)
            {
                case BoxCollider _:
                    Vector3 size = state.Size;
                    return toSimulation * new AffineMap(size.x, 0, 0, 0, size.y, 0, 0, 0, size.z, state.Center.x, state.Center.y,
                        state.Center.z);
                case SphereCollider _:
                case CapsuleCollider _:
                case CharacterController _:
                    RoundShape round = RoundShape.FromCollider(state);
                    Vector3 centre = toSimulation.Apply(state.Center);
                    AffineMap turned = Turned(toSimulation, round.Axis);
                    return turned.Scaled(round.Radius).At(centre.x, centre.y, centre.z);
                default:
                    return toSimulation;
            }
        }

        // The rotation of a round shape: that of the transform, brought to where the shape's own axis lies. Point reflection leaves
        // the shape as it is, so that a mirrored transform has a rotation too.
        private static AffineMap Turned(in AffineMap toSimulation, int axis)
        {
            AffineMap sign = toSimulation.Determinant < 0.0 ? toSimulation.Scaled(-1.0) : toSimulation;
            if (!PolarDecomposition.TryFind(sign, out PolarDecomposition parts)) return AffineMap.Identity;
            Vector3 from = Column(parts.Rotation, axis).normalized, goal = Column(sign, axis).normalized;
            return AffineMap.FromMatrix(Matrix4x4.Rotate(Quaternion.FromToRotation(from, goal))) * parts.Rotation;
        }

        private static Vector3 Column(in AffineMap m, int axis) =>
            axis == 0 ? new Vector3((float)m.M00, (float)m.M10, (float)m.M20) :
            axis == 1 ? new Vector3((float)m.M01, (float)m.M11, (float)m.M21) :
            new Vector3((float)m.M02, (float)m.M12, (float)m.M22);
    }

    /// <summary>Radius and length that Unity gives a sphere or capsule under a transform.</summary>
    internal readonly struct RoundShape
    {
        private RoundShape(int axis, float radius, float halfLength)
        {
            Axis = axis;
            Radius = radius;
            HalfLength = halfLength;
        }

        /// <summary>Column of the transform along which the shape is long.</summary>
        public int Axis { get; }

        /// <summary>Radius [m].</summary>
        public float Radius { get; }

        /// <summary>Half the length of the cylinder between the caps [m]; 0 for a sphere.</summary>
        public float HalfLength { get; }

        /// <summary>Half length over radius.</summary>
        public double Aspect => Radius > 0f ? (double)HalfLength / Radius : 0.0;

        /// <summary>Unity keeps spheres round: the largest scale acts on the radius, a capsule's own axis on its height.</summary>
        public static RoundShape FromCollider(in ColliderState state)
        {
            bool sphere = state.Collider is SphereCollider;
            int axis = sphere ? 1 : (int)state.Size.z;
            Matrix4x4 m = state.ToSimulation;
            float along = Length(m, axis), across = Mathf.Max(Length(m, (axis + 1) % 3), Length(m, (axis + 2) % 3));
            float radius = Mathf.Abs(state.Size.x) * (sphere ? Mathf.Max(along, across) : across);
            float height = sphere ? 0f : state.Size.y;
            return new RoundShape(axis, radius, Mathf.Max(0f, 0.5f * Mathf.Abs(height) * along - radius));
        }

        private static float Length(in Matrix4x4 m, int column) => ((Vector3)m.GetColumn(column)).magnitude;
    }
}
