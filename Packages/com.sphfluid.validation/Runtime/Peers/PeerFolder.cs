using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// A folder through which a case goes to another program and its states come back: case.json and start.npy; samples.csv, a table of
    /// particles for each sample, pressures.npy where the case has patches, and run.csv. Particles are rows of x y z u v w density
    /// pressure, by id from 0 on. It is deleted in the end.
    /// </summary>
    internal sealed class PeerFolder : IDisposable
    {
        private const int Columns = 8;

        // Several times as many as any scheme takes: one whose step went to nothing ends.
        private const double MostSteps = 20.0;

        private sealed class Listed
        {
            public double Time, Wall;
            public string File;
            public long Steps;
        }

        private static readonly TableFormat<Listed> samplesFormat = new TableFormat<Listed>("samples.csv")
            .Number("time_s", s => s.Time, (s, v) => s.Time = v)
            .Text("file", s => s.File, (s, v) => s.File = v)
            .Count("steps", s => s.Steps, (s, v) => s.Steps = v)
            .Number("wall_s", s => s.Wall, (s, v) => s.Wall = v);

        /// <summary>A new folder among the system's temporary files.</summary>
        /// <exception cref="IOException">It cannot be made.</exception>
        public PeerFolder()
        {
            Name = Path.Combine(Path.GetTempPath(), "sphfluid-peer-" + Guid.NewGuid().ToString("N"));
            Directory.CreateDirectory(Name);
        }

        /// <summary>Its path.</summary>
        public string Name { get; }

        /// <summary>Writes a case.</summary>
        /// <param name="point">The run.</param>
        public void Write(PeerPoint point)
        {
            CaseSetup setup = point.Setup;
            FluidSolverSettings settings = setup.Settings;
            FluidAxes periodic = settings.Boundaries.Periodic;
            new JsonObject()
                .Add("case", point.Peer.Case.Name)
                .Add("spacing", settings.Spacing)
                .Add("restDensity", settings.RestDensity)
                .Add("soundSpeed", settings.SoundSpeed)
                .Add("speed", settings.MaxSpeed)
                .Add("viscosity", settings.Viscosity / settings.RestDensity)
                .Add("gravity", Numbers(settings.Gravity))
                .Add("centralForce", Numbers(settings.BodyForce.RateSquared))
                .Add("domainSize", Numbers(settings.DomainSize))
                .Add("periodic", Enumerable.Range(0, 3).Select(axis => ((int)periodic & 1 << axis) != 0 ? 1.0 : 0.0))
                .Add("walls", setup.IsOpen ? Array.Empty<JsonObject>() : Walls(settings.Boundaries))
                .Add("duration", setup.Duration)
                .Add("sampleInterval", setup.SampleInterval)
                .Add("mostSteps", (long)(100.0 + MostSteps * setup.Duration * settings.SoundSpeed / settings.Spacing))
                .Add("obstacles", setup.Obstacles.Select(Box))
                .Add("patches", setup.Patches.Select(Patch))
                .AppendTo(PathOf("case.json"));
            NpyFile.Write(PathOf("start.npy"), Start(point));
        }

        /// <summary>What the program told of its run.</summary>
        /// <exception cref="InvalidDataException">It told nothing that can be read.</exception>
        public PeerFacts ReadFacts()
        {
            List<PeerFacts> facts = ReadAll(PeerFacts.Format, () => new PeerFacts());
            return facts.Count == 1 ? facts[0]
                : throw new InvalidDataException($"'{PathOf(PeerFacts.Format.FileName)}' has {facts.Count} lines instead of one.");
        }

        /// <summary>Times of a step by the clock, without what the samples took. Each stretch between two samples is a part.</summary>
        /// <exception cref="InvalidDataException">There are no samples.</exception>
        public StepTimes ReadTimes()
        {
            List<Listed> listed = ReadAll(samplesFormat, () => new Listed());
            List<double> milliseconds = listed.Zip(listed.Skip(1), (from, to) => 1000.0 * (to.Wall - from.Wall)).ToList();
            return StepTimes.Of(milliseconds, listed.Zip(listed.Skip(1), (from, to) => checked((int)(to.Steps - from.Steps))).ToList(),
                milliseconds.Count);
        }

        /// <summary>The states, each read when it comes to it.</summary>
        /// <param name="setup">What was run.</param>
        /// <exception cref="InvalidDataException">A file is missing, cut, or has another number of particles than the set-up.</exception>
        public IEnumerable<PeerSample> ReadSamples(CaseSetup setup)
        {
            List<Listed> listed = ReadAll(samplesFormat, () => new Listed());
            string file = PathOf("pressures.npy");
            float[,] pressures = setup.Patches.Count > 0 && File.Exists(file) ? NpyFile.Read(file, setup.Patches.Count) : null;
            if (pressures != null && pressures.GetLength(0) != listed.Count)
            {
                throw new InvalidDataException($"'{file}' has pressures of {pressures.GetLength(0)} samples instead of {listed.Count}.");
            }
            for (int i = 0; i < listed.Count; i++)
            {
                int row = i;
                FluidSnapshot state = StateOf(PathOf(listed[i].File), setup.Particles.Length);
                yield return new PeerSample(listed[i].Time, state, pressures == null ? null
                    : Enumerable.Range(0, setup.Patches.Count).Select(p => (double)pressures[row, p]).ToArray());
            }
        }

        /// <summary>Deletes it.</summary>
        public void Dispose()
        {
            if (Directory.Exists(Name)) Directory.Delete(Name, true);
        }

        internal string PathOf(string file) => Path.Combine(Name, file);

        private static FluidSnapshot StateOf(string file, int count)
        {
            if (!File.Exists(file)) throw new InvalidDataException($"'{file}' is missing.");
            float[,] table = NpyFile.Read(file, Columns);
            if (table.GetLength(0) != count)
            {
                throw new InvalidDataException($"'{file}' has {table.GetLength(0)} particles instead of {count}.");
            }
            var particles = new FluidParticle[count];
            float[] densities = new float[count], pressures = new float[count];
            for (int i = 0; i < count; i++)
            {
                particles[i] = new FluidParticle(new Vector3(table[i, 0], table[i, 1], table[i, 2]),
                    new Vector3(table[i, 3], table[i, 4], table[i, 5]), (uint)i);
                (densities[i], pressures[i]) = (table[i, 6], table[i, 7]);
            }
            return FluidSnapshot.FromParticles(particles, densities, pressures, Matrix4x4.identity);
        }

        private static float[,] Start(PeerPoint point)
        {
            FluidParticle[] particles = point.Setup.Particles;
            var table = new float[particles.Length, Columns];
            for (int i = 0; i < particles.Length; i++)
            {
                for (int axis = 0; axis < 3; axis++)
                {
                    (table[i, axis], table[i, 3 + axis]) = (particles[i].Position[axis], particles[i].VelT0[axis]);
                }
                table[i, 6] = point.Peer.DensityAt(point.Setup, point.Parameters.Resolution, particles[i].Position);
            }
            return table;
        }

        private List<TRow> ReadAll<TRow>(TableFormat<TRow> format, Func<TRow> create)
        {
            string file = PathOf(format.FileName);
            try
            {
                return File.Exists(file) ? format.ReadAll(file, create) : throw new InvalidDataException($"'{file}' is missing.");
            }
            catch (FormatException exception)
            {
                throw new InvalidDataException(exception.Message, exception);
            }
        }

        private static IEnumerable<JsonObject> Walls(FluidBoundaries faces) =>
            new[] { (faces.LowX, faces.HighX), (faces.LowY, faces.HighY), (faces.LowZ, faces.HighZ) }
            .Select(pair => new JsonObject().Add("low", Numbers(pair.Item1)).Add("high", Numbers(pair.Item2)));

        // What goes over is the box of a mesh, so the mesh must be one: each corner lies at a corner of it.
        private static JsonObject Box(Vector3[] corners)
        {
            Vector3 low = corners.Aggregate(Vector3.Min), high = corners.Aggregate(Vector3.Max);
            if (corners.Any(c => Enumerable.Range(0, 3).Any(axis => c[axis] != low[axis] && c[axis] != high[axis])))
            {
                throw new ArgumentException("An obstacle is no box along the axes; other programs are given boxes only.");
            }
            return new JsonObject().Add("low", Numbers(low)).Add("high", Numbers(high));
        }

        private static JsonObject Patch(CasePatch patch) =>
            new JsonObject().Add("centre", Numbers(patch.Centre)).Add("along", Numbers(patch.Rotation * Vector3.right))
            .Add("up", Numbers(patch.Rotation * Vector3.up)).Add("size", new double[] { patch.Size.x, patch.Size.y });

        private static IEnumerable<double> Numbers(Vector3 v) => new double[] { v.x, v.y, v.z };
    }
}
