using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>The states by name, the same at every call.</summary>
    sealed class SurfaceStates
    {
        readonly Func<SurfaceScale, SurfaceState> build;

        SurfaceStates(string name, Func<SurfaceScale, SurfaceState> build)
        {
            Name = name;
            this.build = build;
        }

        /// <summary>Name on the command line.</summary>
        public string Name { get; }

        /// <summary>All.</summary>
        public static IReadOnlyList<SurfaceStates> All { get; } = new[]
        {
            new SurfaceStates("lattice-5", s => PoolStates.Lattice(s, 0.05)),
            new SurfaceStates("lattice-20", s => PoolStates.Lattice(s, 0.20)),
            new SurfaceStates("packed", PoolStates.Packed),
            new SurfaceStates("rising", PoolStates.Rising),
            new SurfaceStates("full", PoolStates.Full),
            new SurfaceStates("film-5", s => PoolStates.Film(s, 0.05)),
            new SurfaceStates("film-20", s => PoolStates.Film(s, 0.20)),
            new SurfaceStates("sphere", BodyStates.Sphere),
            new SurfaceStates("torus", BodyStates.Torus),
            new SurfaceStates("two-spheres", BodyStates.TwoSpheres),
            new SurfaceStates("drops", BodyStates.Drops),
            new SurfaceStates("splash", BodyStates.Splash),
            new SurfaceStates("coincident", BodyStates.Coincident),
            new SurfaceStates("field-sphere", FieldStates.Sphere),
            new SurfaceStates("field-torus", FieldStates.Torus),
            new SurfaceStates("field-noise", FieldStates.Noise),
            new SurfaceStates("settled", SolvedStates.Settled),
            new SurfaceStates("dam-break", SolvedStates.DamBreak),
        };

        /// <summary>The state of a name.</summary>
        public static SurfaceStates Find(string name) => All.First(s => s.Name == name);

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
