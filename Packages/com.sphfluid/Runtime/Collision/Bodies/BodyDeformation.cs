using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The triangles of a body that deforms, in its rigid frame: those of the start of the frame and those of its end, between which
    /// corners go straight.
    /// </summary>
    internal sealed class BodyDeformation
    {
        private BodyStretch lastStretch = BodyStretch.None;
        private bool isNew = true;

        /// <param name="mesh">The triangles before they deform.</param>
        /// <param name="state">The collider that they are of.</param>
        public BodyDeformation(TriangleMesh mesh, in ColliderState state)
        {
            Start = End = mesh;
            Last = state;
            IsChanged = true;
        }

        /// <summary>The triangles at the start of the frame.</summary>
        public TriangleMesh Start { get; private set; }

        /// <summary>The same at its end.</summary>
        public TriangleMesh End { get; private set; }

        /// <summary>The collider as it was last seen.</summary>
        public ColliderState Last { get; private set; }

        /// <summary>Farthest that a corner goes in the rigid frame [m].</summary>
        public float Longest { get; private set; }

        /// <summary>Whether a corner goes anywhere.</summary>
        public bool IsUnderWay => !ReferenceEquals(Start, End);

        /// <summary>Whether the triangles changed since this was last false; whoever copies them resets it.</summary>
        public bool IsChanged { get; set; }

        /// <summary>Sets the end of the motion.</summary>
        /// <param name="solid">The collider now.</param>
        /// <param name="rotation">Its rigid pose at the end: rotation.</param>
        /// <param name="position">Its rigid pose at the end: position [m].</param>
        /// <param name="stretch">The stretch of the collider's own space, which the corners have in them.</param>
        public void MoveTo(FluidObstacle solid, Quaternion rotation, Vector3 position, in AffineMap stretch)
        {
            BodyStretch found = BodyStretch.Create(stretch, lastStretch);
            bool same = !isNew && solid.State.HasShapeOf(Last) && found.Equals(lastStretch);
            Last = solid.State;
            lastStretch = found;
            isNew = false;
            if (same) return;
            AffineMap toFrame = AffineMap.FromMatrix(Matrix4x4.TRS(position, rotation, Vector3.one)).Inverse;
            var corners = new Vector3[Start.Vertices.Length];
            Vector3[] now = solid.Mesh.Vertices, before = Start.Vertices;
            float longest = 0f;
            for (int i = 0; i < corners.Length; i++)
            {
                corners[i] = toFrame.Apply(now[i]);
                longest = Mathf.Max(longest, (corners[i] - before[i]).sqrMagnitude);
            }
            End = Start.Deformed(corners);
            Longest = (float)Math.Sqrt(longest);
            IsChanged = true;
        }

        /// <summary>Ends the motion: it begins where it ended.</summary>
        public void Arrive()
        {
            if (!IsUnderWay) return;
            Start = End;
            Longest = 0f;
            IsChanged = true;
        }
    }
}
