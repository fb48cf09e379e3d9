using System;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Particles that wait for their birth, each with a time. A step that sorts takes those whose time has come, where they would be if
    /// they had fallen freely since: a layer of an emitter keeps its distance from the one before, wherever in the frame the steps end.
    /// </summary>
    internal sealed class BirthQueue
    {
        // Births of several sources are compared with each other: more of them wait for the next sort.
        private const int MostRivals = 4096;

        private ParticleBirth[] waiting = new ParticleBirth[64], due = new ParticleBirth[64];
        private double[] times = new double[64];

        /// <summary>A queue behind particles with ids.</summary>
        /// <param name="nextId">Id of the first.</param>
        public BirthQueue(uint nextId) => NextId = nextId;

        /// <summary>Particles that wait.</summary>
        public int Waiting { get; private set; }

        /// <summary>Id of the next particle.</summary>
        public uint NextId { get; set; }

        /// <summary>Id of the first that waits, else of the next: from it on nobody is born yet.</summary>
        public uint Unborn => Waiting > 0 ? waiting[0].Id : NextId;

        /// <summary>Births that were taken since the start.</summary>
        public long Taken { get; private set; }

        /// <summary>What <see cref="CollectDue"/> took last.</summary>
        public ParticleBirth[] Due => due;

        /// <summary>Whether those are of several sources.</summary>
        public bool HasRivals { get; private set; }

        /// <summary>Adds a particle.</summary>
        /// <param name="position">Position at its time [m], simulation space.</param>
        /// <param name="velocity">Velocity at its time [m/s].</param>
        /// <param name="time">Time of its birth in the simulation [s].</param>
        /// <param name="source">Number of its source.</param>
        /// <param name="pumps">Whether the source drives what it gives through a pipe.</param>
        public void Add(Vector3 position, Vector3 velocity, double time, int source, bool pumps = false)
        {
            if (Waiting == waiting.Length)
            {
                Array.Resize(ref waiting, Math.Max(64, 2 * Waiting));
                Array.Resize(ref times, Math.Max(64, 2 * Waiting));
            }
            waiting[Waiting] = new ParticleBirth
            {
                Position = position, Velocity = velocity, Id = NextId,
                Source = (uint)source | (pumps ? ParticleBirth.Pumps : 0u)
            };
            times[Waiting] = time;
            Waiting++;
            NextId = unchecked(NextId + 1u);
        }

        /// <summary>Forgets what a source has waiting.</summary>
        public void Cancel(int source)
        {
            int kept = 0;
            for (int i = 0; i < Waiting; i++)
                if ((waiting[i].Source & ~ParticleBirth.Pumps) != source) Keep(i, kept++);
            Waiting = kept;
        }

        /// <summary>Takes what is born at the end of a step.</summary>
        /// <param name="end">Time of that [s].</param>
        /// <param name="length">Length of the step [s]: velocities are half of it older than positions.</param>
        /// <param name="gravity">Gravity [m/s²], simulation space.</param>
        /// <returns>Their number in <see cref="Due"/>.</returns>
        public int CollectDue(double end, float length, Vector3 gravity)
        {
            int kept = 0, taken = 0;
            HasRivals = false;
            if (due.Length < Waiting) Array.Resize(ref due, waiting.Length);
            for (int i = 0; i < Waiting; i++)
            {
                bool isRival = taken > 0 && waiting[i].Source != due[0].Source;
                if (times[i] > end || taken >= MostRivals && (HasRivals || isRival))
                {
                    Keep(i, kept++);
                    continue;
                }
                ParticleBirth birth = waiting[i];
                float since = (float)(end - times[i]);
                birth.Position += since * birth.Velocity + 0.5f * since * since * gravity;
                birth.Velocity += (since - 0.5f * length) * gravity;
                HasRivals |= isRival;
                due[taken++] = birth;
            }
            Waiting = kept;
            Taken += taken;
            return taken;
        }

        /// <summary>Writes what waits.</summary>
        public void Save(SaveWriter writer)
        {
            writer.Write(NextId);
            writer.Write(Taken);
            writer.WriteItems(waiting, Waiting);
            writer.WriteItems(times, Waiting);
        }

        /// <summary>Goes on from a save.</summary>
        public void Load(SaveReader reader)
        {
            NextId = reader.Read<uint>();
            Taken = reader.Read<long>();
            waiting = reader.ReadItems<ParticleBirth>();
            times = reader.ReadItems<double>();
            Waiting = waiting.Length;
        }

        private void Keep(int from, int to)
        {
            waiting[to] = waiting[from];
            times[to] = times[from];
        }
    }
}
