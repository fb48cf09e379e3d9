using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using SphFluid.Validation;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>Stands in for another program: writes to a folder what it would.</summary>
    internal static class PeerRig
    {
        public static PeerPoint Point(string name, int resolution, double soundSpeedRatio = 10.0) =>
            new PeerPoint(PeerCase.All.First(c => c.Case.Name == name), resolution, soundSpeedRatio);

        /// <summary>The time of each sample.</summary>
        public static IEnumerable<double> Times(CaseSetup setup) =>
            Enumerable.Range(0, 1 + (int)Math.Round(setup.Duration / setup.SampleInterval)).Select(i => i * setup.SampleInterval);

        /// <summary>
        /// Numbers of a state: x y z u v w density pressure of each particle, as they are at the start with other velocities.
        /// </summary>
        public static float[,] State(CaseSetup setup, Func<Vector3, Vector3> velocity)
        {
            var table = new float[setup.Particles.Length, 8];
            for (int i = 0; i < setup.Particles.Length; i++)
            {
                Vector3 position = setup.Particles[i].Position, moves = velocity(position);
                for (int axis = 0; axis < 3; axis++) (table[i, axis], table[i, 3 + axis]) = (position[axis], moves[axis]);
                (table[i, 6], table[i, 7]) = (1000f + 1e-3f * i, 3f * i);
            }
            return table;
        }

        /// <summary>The state as a run of ours has it in memory.</summary>
        public static FluidSnapshot Snapshot(float[,] state)
        {
            int count = state.GetLength(0);
            FluidParticle[] particles = Enumerable.Range(0, count).Select(i => new FluidParticle(
                new Vector3(state[i, 0], state[i, 1], state[i, 2]), new Vector3(state[i, 3], state[i, 4], state[i, 5]), (uint)i)).ToArray();
            return FluidSnapshot.FromParticles(particles, Column(state, 6), Column(state, 7), Matrix4x4.identity);
        }

        public static void WriteSamples(PeerFolder folder, IReadOnlyList<double> times, Func<double, float[,]> stateAt)
        {
            var lines = new List<string> { "time_s,file,steps,wall_s" };
            for (int i = 0; i < times.Count; i++)
            {
                NpyFile.Write(folder.PathOf($"sample-{i:00000}.npy"), stateAt(times[i]));
                lines.Add(FormattableString.Invariant($"{times[i]:R},sample-{i:00000}.npy,{10 * i},{0.5 * i}"));
            }
            File.WriteAllLines(folder.PathOf("samples.csv"), lines);
        }

        private static float[] Column(float[,] state, int column) =>
            Enumerable.Range(0, state.GetLength(0)).Select(i => state[i, column]).ToArray();
    }
}
