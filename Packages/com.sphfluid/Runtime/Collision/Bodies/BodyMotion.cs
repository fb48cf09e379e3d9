using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A collider that moves: its triangles rest in a frame that was simulation space when it was first seen, and its motion since is
    /// a stretch in that frame and a rigid pose after it. The stretch is one of scale and shear; that of a rigid collider is none. Where
    /// corners have moved among themselves the triangles deform in the rigid frame instead.
    /// </summary>
    internal sealed class BodyMotion
    {
        /// <summary>Stretches that cells are made for; beyond them the triangles are taken over at the last pose.</summary>
        public const double LeastStretch = 0.5, MostStretch = 2.0;

        // In a frame: less than this or more than its inverse is no motion that liquid can follow.
        private const double LeastInFrame = 0.1;

        // Frames without a change of the stretch or of corners after which a body becomes a rigid one: 5 s at 60 Hz.
        private const int SteadyFrames = 300;

        private ColliderState reference;
        private TriangleMesh mesh;
        private AffineMap toShape; // the frame of the triangles to the collider's own shape
        private FloatingBody floats;
        private int steady;

        /// <param name="solid">The collider.</param>
        /// <param name="deforms">Its corners are not those of its state, so that it deforms from where they are.</param>
        public BodyMotion(FluidObstacle solid, bool deforms = false)
        {
            reference = solid.State;
            mesh = solid.Mesh;
            Name = solid.Name;
            Friction = solid.State.Friction;
            floats = solid.State.Body;
            toShape = ColliderFrame.GetMap(reference).Inverse;
            Begin();
            if (deforms) Deformation = new BodyDeformation(mesh, reference);
        }

        /// <summary>The component that it is found again by; null of a mesh that a script gave.</summary>
        public Component Source => reference.Key as Component;

        /// <summary>Name of its object.</summary>
        public string Name { get; }

        /// <summary>
        /// The triangles in the frame in which they rest; of a body that deforms, in the rigid frame at the start of the frame.
        /// </summary>
        public TriangleMesh Mesh => Deformation?.Start ?? mesh;

        /// <summary>The triangles of a body that deforms; null of others.</summary>
        public BodyDeformation Deformation { get; private set; }

        /// <summary>0 free slip to 1 no slip; negative: as the domain's faces.</summary>
        public float Friction { get; private set; }

        /// <summary>
        /// The rigid body that the liquid moves this with; null: it goes where its collider goes. While a collider is scaled or deforms it
        /// is so as well.
        /// </summary>
        public FloatingBody Floats => IsStretched || Deformation != null ? null : floats;

        public Quaternion Rotation0 { get; private set; }
        public Vector3 Position0 { get; private set; }
        public BodyStretch Stretch0 { get; private set; }
        public Quaternion Rotation1 { get; private set; }
        public Vector3 Position1 { get; private set; }
        public BodyStretch Stretch1 { get; private set; }

        /// <summary>Smallest stretch that the triangles' cells have to serve.</summary>
        public double CellStretch { get; private set; }

        /// <summary>Whether scale or shear differ from those of the triangles at the start or the end of the frame.</summary>
        public bool IsStretched => !Stretch0.IsNone || !Stretch1.IsNone;

        /// <summary>Whether the frame's motion is none.</summary>
        public bool IsAtRest => !(Deformation != null && Deformation.IsUnderWay) && Position0 == Position1 && Rotation0.Equals(Rotation1) &&
            Stretch0.Equals(Stretch1);

        /// <summary>
        /// How far a particle may go in the frame of the triangles over how far it is from its first to its last place there: 1 of a
        /// rigid body, more where stretch bends its line.
        /// </summary>
        /// <remarks>
        /// With D = S1 − S0 the particle's place there strays from the straight line by t(1 − t) S⁻¹ D Δu, and its speed is
        /// S⁻¹((1 − t) S1 + t S0) Δu with the stray's part added.
        /// </remarks>
        public double SpanRatio
        {
            get
            {
                if (!IsStretched) return 1.0;
                (double least, double most) = FrameRange();
                double change = BodyStretch.Change(Stretch0, Stretch1) / least;
                return most / least + 0.25 * change * change;
            }
        }

        /// <summary>Where the last steps left the collider: its own space to simulation space.</summary>
        /// <param name="last">The collider as it was last seen.</param>
        public Matrix4x4 Begun(in ColliderState last)
        {
            if (IsAtRest) return last.ToSimulation;
            AffineMap start = AffineMap.FromMatrix(Matrix4x4.TRS(Position0, Rotation0, Vector3.one)) * Stretch0.Map;
            return (start * toShape.Inverse * ColliderFrame.GetMap(reference).Inverse *
                AffineMap.FromMatrix(reference.ToSimulation)).Matrix;
        }

        /// <summary>Corners of a body that deforms, in simulation space, where the last steps left them [m]; null of others.</summary>
        public Vector3[] BegunCorners =>
            Deformation?.Start.Transformed(AffineMap.FromMatrix(Matrix4x4.TRS(Position0, Rotation0, Vector3.one))).Vertices;

        /// <summary>Ends the motion: it begins where it ended.</summary>
        public void Arrive()
        {
            Rotation0 = Rotation1;
            Position0 = Position1;
            Stretch0 = Stretch1;
            Deformation?.Arrive();
        }

        /// <summary>Sets the end of the motion, and the friction.</summary>
        /// <param name="solid">The collider now.</param>
        /// <returns>How it is followed.</returns>
        public BodyFollowing MoveTo(FluidObstacle solid)
        {
            ColliderState state = solid.State;
            bool deforms = Deformation != null, begins = !deforms && !ColliderFrame.HasSameShape(reference, state);
            AffineMap frame = ColliderFrame.GetMap(state);
            if ((begins || deforms) && !(ColliderFrame.MayDeform(state) && Mesh.HasTrianglesOf(solid.Mesh)))
            {
                return (frame * toShape).Determinant < 0.0 ? BodyFollowing.Mirrored : BodyFollowing.Reshaped;
            }
            Friction = state.Friction;
            floats = state.Body;
            if (begins) BeginDeforming();
            BodyFollowing following = MoveTo(frame * toShape, solid);
            if (Deformation != null && following == BodyFollowing.Followed) return begins ? BodyFollowing.CellsOutgrown : following;
            if (following != BodyFollowing.Followed || !IsStretched) return following;
            (double least, double most) = Stretch1.Range();
            bool rigid = CellStretch == 1.0; // its cells look as far as liquid does, no farther
            double cells = rigid ? LeastStretch : CellStretch;
            if (least >= cells && most <= MostStretch)
            {
                CellStretch = cells;
                return rigid ? BodyFollowing.CellsOutgrown : BodyFollowing.Followed;
            }
            TakeOver();
            following = MoveTo(frame * toShape, solid);
            (least, most) = Stretch1.Range();
            if (following != BodyFollowing.Followed || least < LeastInFrame || most > 1.0 / LeastInFrame) return BodyFollowing.Scaled;
            CellStretch = Math.Min(LeastStretch, 0.9 * least);
            return BodyFollowing.CellsOutgrown;
        }

        /// <summary>Counts a frame. A body whose stretch or corners have not changed for long is taken over as a rigid one.</summary>
        /// <returns>Whether it was, so that its cells have to be made anew.</returns>
        public bool Settle()
        {
            if (!IsStretched && Deformation == null) return false;
            bool same = Stretch0.Equals(Stretch1) && !(Deformation != null && Deformation.IsUnderWay);
            steady = same ? steady + 1 : 0;
            if (steady < SteadyFrames) return false;
            Quaternion turn = Rotation1 * Quaternion.Inverse(Rotation0);
            Vector3 displacement = Position1 - turn * Position0;
            BodyDeformation settled = Deformation;
            TakeOver();
            if (settled != null)
            {
                reference = settled.Last;
                toShape = ColliderFrame.GetMap(reference).Inverse * AffineMap.FromMatrix(Matrix4x4.TRS(displacement, turn, Vector3.one));
            }
            Rotation1 = turn;
            Position1 = displacement;
            return true;
        }

        /// <summary>Largest displacement of a corner of the box of the triangles in this frame [m].</summary>
        public float LongestDisplacement(Vector3 min, Vector3 max)
        {
            float longest = 0f;
            AffineMap stretch0 = Stretch0.Map, stretch1 = Stretch1.Map;
            for (int corner = 0; corner < 8; corner++)
            {
                Vector3 p = Corner(min, max, corner);
                Vector3 from = Rotation0 * stretch0.Apply(p) + Position0, to = Rotation1 * stretch1.Apply(p) + Position1;
                longest = Mathf.Max(longest, (to - from).magnitude);
            }
            return longest + (Deformation?.Longest ?? 0f);
        }

        /// <summary>
        /// Largest displacement of a place near a box of simulation space that moves with a rigid body [m]: of a wide one that turns its
        /// far ends are left out.
        /// </summary>
        public float LongestWithin(Bounds box, float near)
        {
            if (IsStretched || Deformation != null) return float.PositiveInfinity;
            Quaternion back = Quaternion.Inverse(Rotation0);
            Vector3 half = box.extents + new Vector3(near, near, near), low = box.center - half, high = box.center + half;
            float longest = 0f;
            for (int corner = 0; corner < 8; corner++)
            {
                Vector3 from = Corner(low, high, corner), to = Rotation1 * (back * (from - Position0)) + Position1;
                longest = Mathf.Max(longest, (to - from).magnitude);
            }
            return longest;
        }

        /// <summary>Smallest and largest stretch from the start of the frame to its end.</summary>
        public (double least, double most) FrameRange()
        {
            (double least0, double most0) = Stretch0.Range();
            (double least1, double most1) = Stretch1.Range();
            return (Math.Min(least0, least1), Math.Max(most0, most1));
        }

        private static Vector3 Corner(Vector3 min, Vector3 max, int number) =>
            new Vector3((number & 1) == 0 ? min.x : max.x, (number & 2) == 0 ? min.y : max.y, (number & 4) == 0 ? min.z : max.z);

        private BodyFollowing MoveTo(in AffineMap motion, FluidObstacle solid)
        {
            if (motion.Determinant <= 0.0) return BodyFollowing.Mirrored;
            if (!PolarDecomposition.TryFind(motion, out PolarDecomposition parts)) return BodyFollowing.Scaled;
            Rotation1 = parts.Quaternion;
            Position1 = new Vector3((float)motion.X, (float)motion.Y, (float)motion.Z);
            if (Deformation != null) Deformation.MoveTo(solid, Rotation1, Position1, parts.Stretch);
            else Stretch1 = BodyStretch.Create(parts.Stretch, Stretch1);
            return BodyFollowing.Followed;
        }

        // The triangles rest from now on where they are at the start of the frame, so that nothing on the GPU moves.
        private void TakeOver()
        {
            AffineMap start = AffineMap.FromMatrix(Matrix4x4.TRS(Position0, Rotation0, Vector3.one)) * Stretch0.Map;
            mesh = Mesh.Transformed(start);
            Deformation = null;
            toShape = toShape * start.Inverse;
            Begin();
        }

        // Scale and shear are in the corners from now on.
        private void BeginDeforming()
        {
            TakeOver();
            Deformation = new BodyDeformation(mesh, reference);
        }

        private void Begin()
        {
            Rotation0 = Rotation1 = Quaternion.identity;
            Position0 = Position1 = Vector3.zero;
            Stretch0 = Stretch1 = BodyStretch.None;
            CellStretch = 1.0;
            steady = 0;
        }
    }

    /// <summary>How a body follows its collider.</summary>
    internal enum BodyFollowing
    {
        /// <summary>From where it was, within its cells.</summary>
        Followed,

        /// <summary>From where it was, with cells that have to be made anew.</summary>
        CellsOutgrown,

        /// <summary>Not: the collider has other triangles.</summary>
        Reshaped,

        /// <summary>Not: a scale has changed its sign.</summary>
        Mirrored,

        /// <summary>Not: scaled more than tenfold in a frame, or to nothing.</summary>
        Scaled,

        /// <summary>Not: too far for a frame.</summary>
        TooFar,
    }
}
