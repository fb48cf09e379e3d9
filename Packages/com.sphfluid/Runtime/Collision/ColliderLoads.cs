using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// How hard the scene's colliders drive a liquid, from where they were in the last frames. One of the length L that is accelerated by a
    /// may press liquid as a column of that length stands under a: √(2 a L) is the speed that the liquid's constants have to be made for.
    /// </summary>
    internal sealed class ColliderLoads
    {
        // s: what physics moves in steps of its own among frames, and a knock, is no acceleration that lasts.
        private const double Smoothing = 0.05;

        private Dictionary<object, Track> tracks = new Dictionary<object, Track>(), before = new Dictionary<object, Track>();

        private bool atStart = true;

        /// <summary>Fastest speed of a collider [m/s].</summary>
        public double Speed { get; private set; }

        /// <summary>The largest √(2 a L) [m/s].</summary>
        public double Load { get; private set; }

        /// <summary>Name of the collider that drives the liquid most.</summary>
        public string Name { get; private set; }

        /// <summary>Takes note of a frame.</summary>
        /// <param name="solids">The colliders in it.</param>
        /// <param name="domain">Edge lengths of the domain, in which the liquid is [m].</param>
        /// <param name="time">Its time [s]; 0: they may be anywhere at its end.</param>
        /// <param name="longestMotion">Farthest that a point of one went in it, where that is known [m].</param>
        public void Record(IReadOnlyList<FluidObstacle> solids, Vector3 domain, double time, double longestMotion)
        {
            (tracks, before) = (before, tracks);
            tracks.Clear();
            (Load, Speed) = (0.0, time > 0.0 ? longestMotion / time : 0.0);
            double most = 0.0;
            for (int i = 0; i < solids.Count; i++)
            {
                Bounds bounds = solids[i].Mesh.Bounds;
                Vector3 size = Vector3.Min(bounds.size, domain);
                float length = Mathf.Max(size.x, Mathf.Max(size.y, size.z));
                object key = solids[i].State.Key;
                before.TryGetValue(key, out Track track);
                tracks[key] = track = track.After(bounds.center, length, time, atStart);
                // What the liquid moves is as fast as it lets it.
                double load = solids[i].State.Body == null ? Math.Sqrt(2.0 * track.Acceleration.magnitude * length) : 0.0;
                (Load, Speed) = (Math.Max(Load, load), Math.Max(Speed, track.Speed));
                if (Math.Max(load, track.Speed) <= most) continue;
                (most, Name) = (Math.Max(load, track.Speed), solids[i].Name);
            }
            atStart = false;
        }

        /// <summary>Knows no motion any more: each collider goes on at the speed of its next frame.</summary>
        public void Forget()
        {
            tracks.Clear();
            atStart = false;
        }

        private struct Track
        {
            public Vector3 Acceleration;
            public double Speed;
            private Vector3 place, velocity;
            private int frames; // 0: not seen yet, 1: it has no velocity yet

            // Farther than its length in a frame it was put elsewhere.
            public Track After(Vector3 now, float length, double time, bool fromRest)
            {
                Vector3 way = now - place;
                Track next = this;
                (next.place, next.Speed) = (now, 0.0);
                next.frames = Math.Max(fromRest ? 2 : 1, frames);
                if (frames == 0 || !(time > 0.0) || way.magnitude > length) return next;
                float share = frames == 1 ? 1f : (float)(1.0 - Math.Exp(-time / Smoothing));
                Vector3 change = share * (way / (float)time - velocity);
                next.frames = 2;
                next.velocity += change;
                if (frames > 1) next.Acceleration += share * (change / (float)time - Acceleration);
                next.Speed = way.magnitude / time;
                return next;
            }
        }
    }
}
