using System;
using System.Collections;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>Particles whose surface is known, or moves as it does in a simulation. SI, simulation space.</summary>
    internal sealed class SurfaceState
    {
        /// <summary>Name on the command line and in tables.</summary>
        public string Name;

        /// <summary>Domain and spacing, and the physics where the particles move by it.</summary>
        public FluidSolverSettings Settings;

        /// <summary>Positions of the particles [m], frame by frame, as many in each.</summary>
        public List<Vector3[]> Frames = new List<Vector3[]>();

        /// <summary>Computes <see cref="Frames"/> where they are not given; null where they are.</summary>
        public Func<FluidShaderSet, IEnumerator> Prepare;

        /// <summary>
        /// Numbers of particles and of frames, and the steps behind them, where <see cref="Prepare"/> has still to compute them.
        /// </summary>
        public (int Particles, int Frames, int Steps) Planned;

        /// <summary>Particles of a frame.</summary>
        public int ParticleCount => Frames.Count > 0 ? Frames[0].Length : Planned.Particles;

        /// <summary>Frames, those to come included.</summary>
        public int FrameCount => Frames.Count > 0 ? Frames.Count : Planned.Frames;

        /// <summary>Volume of the liquid [m³]; not a number where it has none of its own.</summary>
        public double Volume = double.NaN;

        /// <summary>Where the liquid is seen from above, away from its rims: x and z [m].</summary>
        public Rect? Top;

        /// <summary>Height of the liquid's level in a frame [m]; null where it has none.</summary>
        public Func<int, double> Level;

        /// <summary>Unit normal of the true surface next to a point; zero where it is not known. Null where there is none.</summary>
        public Func<Vector3, Vector3> Normal;

        /// <summary>Whether frames follow each other in time, 1/60 s apart.</summary>
        public bool InTime;

        /// <summary>Particles without neighbours, whose drops should be visible.</summary>
        public Vector3[] Drops = Array.Empty<Vector3>();

        /// <summary>
        /// A field that is known everywhere, 0.5 on its surface and more inside, in the place of one that particles make; else null.
        /// </summary>
        public Func<Vector3, float> Field;

        /// <summary>Distance in each frame between two bodies of liquid [dx]; null where there are no two.</summary>
        public double[] Gaps;

        /// <summary>dx [m].</summary>
        public float Spacing => Settings.Spacing;
    }
}
