using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A state by name, the same at every call.</summary>
    internal sealed class SurfaceStateEntry
    {
        private readonly Func<SurfaceScale, SurfaceState> build;

        private SurfaceStateEntry(string name, Func<SurfaceScale, SurfaceState> build)
        {
            Name = name;
            this.build = build;
        }

        /// <summary>Name on the command line.</summary>
        public string Name { get; }

        /// <summary>All.</summary>
        public static IReadOnlyList<SurfaceStateEntry> All { get; } = new[]
        {
            new SurfaceStateEntry("lattice-5", s => PoolStates.Lattice(s, 0.05)),
            new SurfaceStateEntry("lattice-20", s => PoolStates.Lattice(s, 0.20)),
            new SurfaceStateEntry("packed", PoolStates.Packed),
            new SurfaceStateEntry("rising", PoolStates.Rising),
            new SurfaceStateEntry("full", PoolStates.Full),
            new SurfaceStateEntry("film-5", s => PoolStates.Film(s, 0.05)),
            new SurfaceStateEntry("film-20", s => PoolStates.Film(s, 0.20)),
            new SurfaceStateEntry("sphere", BodyStates.Sphere),
            new SurfaceStateEntry("torus", BodyStates.Torus),
            new SurfaceStateEntry("two-spheres", BodyStates.TwoSpheres),
            new SurfaceStateEntry("drops", BodyStates.Drops),
            new SurfaceStateEntry("splash", BodyStates.Splash),
            new SurfaceStateEntry("coincident", BodyStates.Coincident),
            new SurfaceStateEntry("field-sphere", FieldStates.Sphere),
            new SurfaceStateEntry("field-torus", FieldStates.Torus),
            new SurfaceStateEntry("field-noise", FieldStates.Noise),
            new SurfaceStateEntry("settled", SolvedStates.Settled),
            new SurfaceStateEntry("dam-break", SolvedStates.DamBreak),
        };

        /// <summary>The state of a name.</summary>
        public static SurfaceStateEntry Find(string name) => All.First(s => s.Name == name);

        /// <summary>The state.</summary>
        /// <param name="scale">Sizes.</param>
        public SurfaceState Build(SurfaceScale scale)
        {
            SurfaceState state = build(scale);
            state.Name = Name;
            return state;
        }
    }
}
