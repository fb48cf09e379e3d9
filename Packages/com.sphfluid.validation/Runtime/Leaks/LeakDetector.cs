using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Watches particles and counts those that got through a surface.</summary>
    abstract class LeakDetector
    {
        bool[] escaped;

        /// <summary>Particles that got through, since the start.</summary>
        public int Escapes { get; private set; }

        /// <summary>
        /// The detector for a scene. A closed surface has an inside, and a particle that changes sides escaped, whatever its path. An open one
        /// has a rim over which particles may go, so each step's path is tested against the triangles. Where the surface stretches the
        /// detector shares nothing with the solver's own obstacles.
        /// </summary>
        public static LeakDetector Of(LeakScene scene)
        {
            if (!scene.Mesh.IsClosed)
                return new PathDetector(scene.Surface, scene.Settings.PeriodLength);
            return scene.Stretches ? (LeakDetector)new WindingDetector(scene.Surface) : new InsideDetector(scene.Mesh);
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
                if (!Passed(i, places[i], first) || escaped[i])
                    continue;
                escaped[i] = true;
                Escapes++;
            }
            Seen(places);
        }

        /// <summary>Whether a particle got through since the last look.</summary>
        protected abstract bool Passed(int particle, Vector3 place, bool first);

        /// <summary>The look is over.</summary>
        protected virtual void Seen(Vector3[] places)
        {
        }
    }
}
