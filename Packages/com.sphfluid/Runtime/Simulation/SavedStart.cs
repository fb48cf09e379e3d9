using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A relaxed start as it is saved: what it follows from, and how far each particle went from its site. What it follows from is compared
    /// with a tolerance, as runtimes round differently.
    /// </summary>
    internal sealed class SavedStart
    {
        private const int Edition = 1; // of the bytes and of what they follow from
        private const double Tolerance = 1e-4;

        private readonly IReadOnlyList<FluidParticle> sites;
        private readonly float[] origin;

        /// <summary>Of a liquid.</summary>
        /// <param name="settings">The physics that brings it to rest.</param>
        /// <param name="sites">Its particles before.</param>
        /// <param name="solids">What it rests on.</param>
        public SavedStart(in FluidSolverSettings settings, IReadOnlyList<FluidParticle> sites, IReadOnlyList<FluidObstacle> solids)
        {
            this.sites = sites;
            origin = Origin(settings, sites, solids).ToArray();
        }

        /// <summary>The bytes of a start.</summary>
        /// <param name="rested">The particles at rest, in the order of the sites.</param>
        public byte[] Write(IReadOnlyList<FluidParticle> rested)
        {
            float farthest = 0f;
            for (int i = 0; i < sites.Count; i++)
                for (int axis = 0; axis < 3; axis++)
                {
                    farthest = Mathf.Max(farthest, Mathf.Abs(rested[i].Position[axis] - sites[i].Position[axis]));
                }
            float unit = Mathf.Max(farthest, 1e-30f) / short.MaxValue;
            var steps = new short[3 * sites.Count];
            for (int i = 0; i < steps.Length; i++)
            {
                steps[i] = (short)Math.Round((rested[i / 3].Position[i % 3] - sites[i / 3].Position[i % 3]) / unit);
            }
            var writer = new SaveWriter();
            writer.Write(Edition);
            writer.WriteItems<float>(origin);
            writer.Write(unit);
            writer.WriteItems<short>(steps);
            float[] offsets = rested.Select(p => p.DensityOffset).ToArray();
            if (Array.Exists(offsets, offset => offset != 0f)) writer.WriteItems<float>(offsets);
            return writer.Bytes.ToArray();
        }

        /// <summary>Reads the particles at rest, with the velocities of the sites.</summary>
        /// <param name="bytes">The bytes of a start.</param>
        /// <param name="rested">The particles; null where it is of another liquid or another vessel.</param>
        public bool TryRead(byte[] bytes, out FluidParticle[] rested)
        {
            rested = null;
            var reader = new SaveReader("start", bytes, null);
            try
            {
                if (reader.Read<int>() != Edition || !IsOrigin(reader.ReadItems<float>())) return false;
                float unit = reader.Read<float>();
                short[] steps = reader.ReadItems<short>();
                if (steps.Length != 3 * sites.Count) return false;
                float[] offsets = reader.IsAtEnd ? new float[sites.Count] : reader.ReadItems<float>();
                if (offsets.Length != sites.Count) return false;
                rested = new FluidParticle[sites.Count];
                for (int i = 0; i < rested.Length; i++)
                {
                    Vector3 way = unit * new Vector3(steps[3 * i], steps[3 * i + 1], steps[3 * i + 2]);
                    rested[i] = new FluidParticle(sites[i].Position + way, sites[i].VelT0, sites[i].Id) { DensityOffset = offsets[i] };
                }
                return true;
            }
            catch (InvalidDataException)
            {
                return false;
            }
        }

        private bool IsOrigin(float[] other)
        {
            if (other.Length != origin.Length) return false;
            for (int i = 0; i < origin.Length; i++)
            {
                double a = origin[i], b = other[i];
                if (!(Math.Abs(a - b) <= Tolerance * (1.0 + Math.Abs(a) + Math.Abs(b)))) return false;
            }
            return true;
        }

        // Numbers of the order of one or more: lengths in spacings.
        private static List<float> Origin(in FluidSolverSettings settings, IReadOnlyList<FluidParticle> sites,
            IReadOnlyList<FluidObstacle> solids)
        {
            float dx = settings.Spacing;
            var origin = new List<float>
            {
                1e3f * dx, settings.SupportRadius / dx, settings.RestDensity, settings.SoundSpeed,
                1e6f * settings.Viscosity / settings.RestDensity, (int)settings.Boundaries.Periodic, settings.Boundaries.Friction,
                sites.Count, solids.Count,
            };
            Add(origin, settings.DomainSize / dx);
            Add(origin, settings.Gravity);
            Add(origin, settings.BodyForce.RateSquared);
            Add(origin, settings.BodyForce.Centre / dx);
            var places = new Vector3[sites.Count];
            for (int i = 0; i < places.Length; i++) places[i] = sites[i].Position;
            AddSpread(origin, places, dx);
            foreach (FluidObstacle solid in solids)
            {
                origin.Add(solid.Mesh.TriangleCount);
                AddSpread(origin, solid.Mesh.Vertices, dx);
            }
            return origin;
        }

        // Mean and deviation along each axis.
        private static void AddSpread(List<float> origin, Vector3[] places, float dx)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                double sum = 0.0, squares = 0.0;
                foreach (Vector3 place in places)
                {
                    double x = place[axis] / dx;
                    sum += x;
                    squares += x * x;
                }
                double mean = sum / Math.Max(1, places.Length);
                origin.Add((float)mean);
                origin.Add((float)Math.Sqrt(Math.Max(0.0, squares / Math.Max(1, places.Length) - mean * mean)));
            }
        }

        private static void Add(List<float> origin, Vector3 v)
        {
            for (int axis = 0; axis < 3; axis++) origin.Add(v[axis]);
        }
    }
}
