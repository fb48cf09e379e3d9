using System;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Watches particles and counts those that got through a surface.</summary>
    internal abstract class LeakDetector
    {
        private bool[] escaped;

        /// <summary>Particles that got through, since the start.</summary>
        public int Escapes { get; private set; }

        /// <summary>Whether a particle got through, since the start.</summary>
        public bool HasEscaped(int particle) => escaped[particle];

        /// <summary>
        /// The detector for a surface. A closed surface has an inside, and a particle that changes sides escaped, whatever its path. An
        /// open one has a rim over which particles may go, so each step's path is tested against the triangles. Where the surface
        /// stretches, deforms or floats the detector shares nothing with the solver's own obstacles.
        /// </summary>
        /// <param name="body">The surface.</param>
        /// <param name="period">Length of the domain along periodic axes [m], zero along others.</param>
        public static LeakDetector Of(LeakBody body, Vector3 period)
        {
            if (!body.Mesh.IsClosed) return new PathDetector(body.Surface, period);
            return body.IsFreeWithinFrames ? (LeakDetector)new WindingDetector(body.Surface) : new InsideDetector(body.Mesh);
        }

        /// <summary>Whether it must see every step, not only every frame.</summary>
        public abstract bool NeedsSteps { get; }

        /// <summary>Looks at the particles; the first look is the start.</summary>
        /// <param name="places">Places in the surface's own space [m], ordered by id.</param>
        public void Look(Vector3[] places)
        {
            bool first = escaped == null;
            escaped = escaped ?? new bool[places.Length];
            for (int i = 0; i < places.Length; i++)
            {
                if (!Passed(i, places[i], first) || escaped[i]) continue;
                escaped[i] = true;
                Escapes++;
            }
            Seen(places);
        }

        /// <summary>The surface has other corners from the next look on.</summary>
        /// <exception cref="NotSupportedException">The detector sees surfaces that keep their shape only.</exception>
        public virtual void Reshape(Vector3[] corners) =>
            throw new NotSupportedException(
                "What goes through a surface that deforms is seen by its winding number, which needs a closed surface.");

        /// <summary>Whether a particle got through since the last look.</summary>
        protected abstract bool Passed(int particle, Vector3 place, bool first);

        /// <summary>The look is over.</summary>
        protected virtual void Seen(Vector3[] places)
        {
        }
    }
}
