using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// The pipe of an emitter that stands in liquid: a wall about the nozzle, closed behind it and open ahead, which keeps the liquid
    /// outside from taking the place of what is to be born, and a zone in it that drives all that is there at the speed of the nozzle. Both
    /// end a little more than a support radius ahead of the nozzle.
    /// </summary>
    internal sealed class EmitterPipe
    {
        // Over the spacing: from the outermost particles to the wall, its thickness, and from the nozzle to the wall behind it.
        private const float Clearance = 0.75f, Thickness = 1f, Back = 0.5f;

        // Over the spacing: how much farther than the pipe is wide, and than a support radius, the zone reaches; over how much it begins.
        private const float Beyond = 0.15f, Ahead = 0.4f, Edge = 0.25f;

        // 1/s: of another speed nothing is left after a step.
        private const float DriveRate = 10000f;

        private const int Segments = 32;

        private readonly FluidEmitterShape shape;
        private readonly Vector2 size, half;
        private readonly float spacing, reach;

        private EmitterPipe(in EmitterSpec emitter, float spacing, float reach)
        {
            shape = emitter.Shape;
            size = emitter.Size;
            this.spacing = spacing;
            this.reach = reach;
            half = Half(emitter, spacing);
            Mesh = Cup();
        }

        /// <summary>The wall in the emitter's space, metres whatever its scale.</summary>
        public TriangleMesh Mesh { get; }

        /// <summary>From the nozzle to the mouth [m].</summary>
        public float Length => reach + 0.25f * spacing;

        /// <summary>The pipe of an emitter, made anew where it is another.</summary>
        /// <param name="emitter">The emitter, with a size that can be computed with.</param>
        /// <param name="spacing">Particle spacing [m].</param>
        /// <param name="reach">Support radius [m].</param>
        public static EmitterPipe Create(in EmitterSpec emitter, float spacing, float reach)
        {
            EmitterPipe known = emitter.State.Pipe;
            bool serves = known != null && known.shape == emitter.Shape && known.size.Equals(emitter.Size) &&
                known.spacing.Equals(spacing) && known.reach.Equals(reach);
            return serves ? known : emitter.State.Pipe = new EmitterPipe(emitter, spacing, reach);
        }

        /// <summary>The zone that drives the liquid in the pipe.</summary>
        /// <param name="position">Of the nozzle, simulation space [m].</param>
        /// <param name="rotation">Of the emitter, simulation space.</param>
        /// <param name="velocity">Of the liquid, simulation space [m/s].</param>
        public ForceZone Drive(Vector3 position, Quaternion rotation, Vector3 velocity)
        {
            var zone = new ForceZone
            {
                Core =
                new Vector4(half.x + Beyond * spacing, half.y + Beyond * spacing, 0.5f * reach + Ahead * spacing, 0f)
            };
            zone.Wind = new Vector4(velocity.x, velocity.y, velocity.z, DriveRate);
            zone.Eddies.w = Edge * spacing;
            zone.Place(position + rotation * new Vector3(0f, 0f, 0.5f * reach), rotation);
            return zone;
        }

        // Half the inner width along both axes: room for the particles of a layer, which may stand a little beyond the nozzle's outline.
        private static Vector2 Half(in EmitterSpec emitter, float spacing)
        {
            Vector2 nozzle = 0.5f * emitter.Size;
            float widest = 0f;
            var farthest = Vector2.zero;
            foreach (Vector2 place in EmitterSites.For(emitter, spacing).Places)
            {
                farthest = Vector2.Max(farthest, new Vector2(Mathf.Abs(place.x), Mathf.Abs(place.y)));
                widest = Mathf.Max(widest, new Vector2(place.x / nozzle.x, place.y / nozzle.y).magnitude);
            }
            Vector2 layer = emitter.Shape == FluidEmitterShape.Disc ? widest * nozzle : farthest;
            return layer + Clearance * spacing * Vector2.one;
        }

        // A closed surface: outer wall, bottom, rim, inner wall and inner bottom. The outer wall is a box, so that nothing outside is
        // within the zone's corners.
        private TriangleMesh Cup()
        {
            Vector2[] outline = Outline();
            int n = outline.Length;
            Vector2 outer = half + Thickness * spacing * Vector2.one;
            float bottom = -Back * spacing;
            var vertices = new Vector3[4 * n + 2];
            for (int i = 0; i < n; i++)
            {
                Vector2 inside = shape == FluidEmitterShape.Disc ? Vector2.Scale(half, outline[i].normalized)
                    : Vector2.Scale(half, outline[i]), outside = Vector2.Scale(outer, outline[i]);
                vertices[i] = new Vector3(outside.x, outside.y, bottom - Thickness * spacing);
                vertices[n + i] = new Vector3(outside.x, outside.y, Length);
                vertices[2 * n + i] = new Vector3(inside.x, inside.y, Length);
                vertices[3 * n + i] = new Vector3(inside.x, inside.y, bottom);
            }
            vertices[4 * n] = new Vector3(0f, 0f, bottom - Thickness * spacing);
            vertices[4 * n + 1] = new Vector3(0f, 0f, bottom);
            var indices = new List<int>();
            for (int i = 0; i < n; i++)
            {
                int next = (i + 1) % n;
                for (int ring = 0; ring < 3; ring++)
                {
                    int a = ring * n + i, b = ring * n + next, c = a + n, d = b + n;
                    indices.AddRange(new[] { a, b, c, b, d, c });
                }
                indices.AddRange(new[] { 4 * n, next, i, 4 * n + 1, 3 * n + i, 3 * n + next });
            }
            return new TriangleMesh(vertices, indices.ToArray());
        }

        // Counter-clockwise about z, on the square from −1 to 1.
        private Vector2[] Outline()
        {
            if (shape != FluidEmitterShape.Disc)
            {
                return new[] { new Vector2(-1f, -1f), new Vector2(1f, -1f), new Vector2(1f, 1f), new Vector2(-1f, 1f) };
            }
            var outline = new Vector2[Segments];
            for (int i = 0; i < Segments; i++)
            {
                float turn = 2f * Mathf.PI * i / Segments;
                var round = new Vector2(Mathf.Cos(turn), Mathf.Sin(turn));
                outline[i] = round / Mathf.Max(Mathf.Abs(round.x), Mathf.Abs(round.y));
            }
            return outline;
        }
    }
}
