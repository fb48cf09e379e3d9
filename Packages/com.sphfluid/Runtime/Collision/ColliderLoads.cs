using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// How hard the scene's colliders drive a liquid, from where they were in the last frames. One of the length L that is accelerated by a may press
    /// liquid as a column of that length stands under a: √(2 a L) is the speed that the liquid's constants have to be made for.
    /// </summary>
    internal sealed class ColliderLoads
    {
        // s: what physics moves in steps of its own among frames, and a knock, is no acceleration that lasts.
        const double Smoothing = 0.05;

        readonly Dictionary<object, Track> tracks = new Dictionary<object, Track>();
        readonly List<object> gone = new List<object>();
        int frame;

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
        public void Note(IReadOnlyList<FluidObstacle> solids, Vector3 domain, double time, double longestMotion)
        {
            Load = 0.0;
            Speed = time > 0.0 ? longestMotion / time : 0.0;
            double most = 0.0;
            frame++;
            for (int i = 0; i < solids.Count; i++)
            {
                Bounds bounds = solids[i].Mesh.Bounds;
                Vector3 size = Vector3.Min(bounds.size, domain);
                float length = Mathf.Max(size.x, Mathf.Max(size.y, size.z));
                if (!tracks.TryGetValue(solids[i].State.Key, out Track track)) tracks.Add(solids[i].State.Key, track = new Track { Place = bounds.center });
                double speed = track.Follow(bounds.center, length, time);
                track.Frame = frame;
                // What the liquid moves is as fast as it lets it.
                double load = solids[i].State.Body == null ? Math.Sqrt(2.0 * track.Acceleration.magnitude * length) : 0.0;
                Load = Math.Max(Load, load);
                Speed = Math.Max(Speed, speed);
                if (Math.Max(load, speed) <= most) continue;
                most = Math.Max(load, speed);
                Name = solids[i].Name;
            }
            if (tracks.Count == solids.Count) return;
            gone.Clear();
            foreach (KeyValuePair<object, Track> pair in tracks)
                if (pair.Value.Frame != frame) gone.Add(pair.Key);
            foreach (object key in gone) tracks.Remove(key);
        }

        /// <summary>Writes how the colliders move.</summary>
        public void Save(SaveWriter writer)
        {
            writer.Write(tracks.Count);
            foreach (KeyValuePair<object, Track> pair in tracks)
            {
                writer.WriteKey(pair.Key as Component);
                writer.Write(pair.Value.Place);
                writer.Write(pair.Value.Velocity);
                writer.Write(pair.Value.Acceleration);
            }
        }

        /// <summary>Goes on from a save.</summary>
        public void Continue(SaveReader reader, IReadOnlyList<FluidObstacle> solids)
        {
            tracks.Clear();
            Dictionary<string, FluidObstacle> present = SaveReader.ByKey(solids, s => s.Source);
            for (int left = reader.Read<int>(); left > 0; left--)
            {
                bool isThere = reader.TryFind(present, out FluidObstacle solid);
                var track = new Track { Place = reader.Read<Vector3>(), Velocity = reader.Read<Vector3>(), Acceleration = reader.Read<Vector3>() };
                if (isThere) tracks[solid.State.Key] = track;
            }
        }

        sealed class Track
        {
            public Vector3 Place, Velocity, Acceleration;
            public int Frame;

            // Farther than its length in a frame it was put elsewhere.
            public double Follow(Vector3 place, float length, double time)
            {
                Vector3 way = place - Place;
                Place = place;
                if (!(time > 0.0) || way.magnitude > length) return 0.0;
                float share = (float)(1.0 - Math.Exp(-time / Smoothing));
                Vector3 velocity = way / (float)time, change = share * (velocity - Velocity);
                Velocity += change;
                Acceleration += share * (change / (float)time - Acceleration);
                return velocity.magnitude;
            }
        }
    }
}
