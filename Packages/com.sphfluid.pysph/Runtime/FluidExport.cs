using System;
using System.Collections.Generic;
using System.IO;
using System.Text.RegularExpressions;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A liquid as a case of PySPH, a solver that runs on many processors: particles as filled and brought to rest, or as they are where
    /// the liquid runs; walls and colliders as particles; constants; probes and gauges; scripts that run it and make of its output a
    /// sequence for playback. In play mode colliders that move are exported with their path: call <see cref="Note"/> each frame until
    /// <see cref="IsComplete"/>, then <see cref="Write"/>. What PySPH cannot express is among the <see cref="Messages"/>. Scheme and
    /// settings are those of PySPH's authors: Ramachandran et al., PySPH: a Python-based framework for smoothed particle hydrodynamics, ACM
    /// Transactions on Mathematical Software 47 (2021).
    /// </summary>
    public sealed class FluidExport : IDisposable
    {
        private const int MostLetters = 40;

        private static readonly Regex DeviceName =
            new Regex("^(con|prn|aux|nul|com.|lpt.)$", RegexOptions.IgnoreCase | RegexOptions.CultureInvariant);

        private readonly FluidSimulation simulation;
        private readonly FluidExportOptions options;
        private readonly ExportStart start;
        private readonly ColliderTracks colliders;
        private readonly List<ExportInstrument> instruments = new List<ExportInstrument>();
        private readonly List<FluidMessage> messages = new List<FluidMessage>();
        private readonly Vector3 position;
        private readonly Quaternion rotation;
        private double time;

        private FluidExport(FluidSimulation simulation, FluidExportOptions options)
        {
            this.simulation = simulation;
            this.options = options;
            FluidSpec spec = simulation.Spec;
            (position, rotation) = (spec.Position, spec.Rotation);
            start = simulation.IsRunning ? ExportStart.OfRunning(spec, simulation.Solver)
                : ExportStart.TryMake(spec, FluidScene.Volumes(simulation), simulation.Watch, Report);
            if (start == null) return;
            if (start.Particles.Length == 0)
            {
                Report(new FluidMessage(FluidSeverity.Error, FluidIssue.NoLiquid, simulation, "There is no liquid to export.",
                    "Add a Fluid Volume, or let an emitter pour first and export the running liquid."));
                return;
            }
            PysphLimits.Report(spec, Report);
            colliders = new ColliderTracks(start.Collision, Report);
            ExportInstruments.Find(simulation, instruments, Report);
        }

        /// <summary>What is wrong or worth knowing. Those of <see cref="FluidIssue.NotExported"/> name what PySPH cannot express.</summary>
        public IReadOnlyList<FluidMessage> Messages => messages;

        /// <summary>Whether there is something to write; if not, a message says why.</summary>
        public bool HasLiquid => colliders != null;

        /// <summary>Whether a part of the scene is left out or exported as less than it is: a warning says so.</summary>
        public bool LeavesOut => messages.Exists(m => m.Issue == FluidIssue.NotExported && m.Severity >= FluidSeverity.Warning);

        /// <summary>Whether the colliders' motion is known for the whole time.</summary>
        public bool IsComplete => time >= options.Seconds;

        /// <summary>Part of the time for which it is known, 0 to 1.</summary>
        public float Progress => (float)Math.Min(1.0, time / options.Seconds);

        /// <summary>Particles of the liquid.</summary>
        public int ParticleCount => start?.Particles.Length ?? 0;

        /// <summary>Particles of walls and colliders; known once it is written.</summary>
        public long WallParticleCount { get; private set; }

        /// <summary>
        /// Begins with the liquid and the colliders as they are now. A liquid that does not run comes to rest first, where its settings ask
        /// for that.
        /// </summary>
        /// <param name="simulation">The simulation, running or not, in play mode or not; it is not changed.</param>
        /// <param name="options">What is computed.</param>
        /// <returns>The export, to be disposed of.</returns>
        /// <exception cref="ArgumentNullException">One is missing.</exception>
        /// <exception cref="ArgumentException">An option is out of range.</exception>
        public static FluidExport Begin(FluidSimulation simulation, FluidExportOptions options)
        {
            if (simulation == null) throw new ArgumentNullException(nameof(simulation));
            if (options == null) throw new ArgumentNullException(nameof(options));
            options.Validate();
            return new FluidExport(simulation, options);
        }

        /// <summary>
        /// Where the cases of several liquids go: one to the folder itself, more each to a folder of its name in it, with a number where
        /// names are shared.
        /// </summary>
        /// <param name="simulations">The liquids.</param>
        /// <param name="folder">The folder.</param>
        /// <returns>A folder for each, in their order.</returns>
        /// <exception cref="ArgumentNullException">There are no simulations, or no folder.</exception>
        public static string[] FoldersOf(IReadOnlyList<FluidSimulation> simulations, string folder)
        {
            if (simulations == null) throw new ArgumentNullException(nameof(simulations));
            if (folder == null) throw new ArgumentNullException(nameof(folder));
            var folders = new string[simulations.Count];
            for (int i = 0; i < folders.Length; i++)
            {
                string name = Plain(simulations[i].name), path = Path.Combine(folder, name);
                for (int number = 2; Array.FindIndex(folders, 0, i, f => string.Equals(f, path, StringComparison.OrdinalIgnoreCase)) >= 0;
                    number++)
                {
                    path = Path.Combine(folder, $"{name}-{number}");
                }
                folders[i] = folders.Length == 1 ? folder : path;
            }
            return folders;
        }

        /// <summary>Takes where the colliders are now.</summary>
        /// <param name="sinceBegin">Scene time since <see cref="Begin"/> [s], growing.</param>
        /// <exception cref="ArgumentException">The time is negative or not finite.</exception>
        public void Note(double sinceBegin)
        {
            Require.NotNegative(sinceBegin, nameof(sinceBegin));
            if (!HasLiquid || !(sinceBegin > time)) return;
            time = sinceBegin;
            FluidSpec spec = simulation.Spec;
            if (!spec.Position.Equals(position) || !spec.Rotation.Equals(rotation))
            {
                Report(new FluidMessage(FluidSeverity.Warning, FluidIssue.NotExported, simulation,
                    "The domain itself moves, which is not exported: it stays where it was at first.", "Move the colliders instead."));
                (spec.Position, spec.Rotation) = (position, rotation);
            }
            colliders.Note(spec, time);
        }

        /// <summary>Writes the case, of what was noted so far.</summary>
        /// <param name="folder">Folder, new, empty or of an earlier export.</param>
        /// <returns>Bytes written.</returns>
        /// <exception cref="InvalidOperationException">There is no liquid to write.</exception>
        /// <exception cref="IOException">The folder holds what no export wrote, or cannot be written.</exception>
        public long Write(string folder)
        {
            if (!HasLiquid) throw new InvalidOperationException($"'{simulation.name}' has no liquid to export; the messages say why.");
            int layers = PysphCase.Layers(options.Scheme);
            var scene = new FluidExportOptions
            {
                Seconds = options.Seconds, FrameRate = options.FrameRate, Scheme = options.Scheme, Ranks = options.Ranks,
                Commit = options.Commit,
                Scene = options.Scene ?? simulation.gameObject.scene.name,
            };
            var bodies = new List<ExportBody>();
            foreach ((FluidObstacle solid, BodyPath path) in colliders.Moving)
            {
                bodies.Add(new ExportBody(solid.Name, ExportWalls.Moving(start, solid, path.Pivot, layers), path.Poses));
            }
            var made = new PysphCase(simulation.name, start.Constants, scene)
            {
                Liquid = start.Particles, Walls = ExportWalls.Still(start, colliders.Still, layers), Bodies = bodies,
                Instruments = instruments, Messages = messages,
            };
            WallParticleCount = made.Walls.Length;
            foreach (ExportBody body in bodies) WallParticleCount += body.Particles.Length;
            return made.Write(folder);
        }

        /// <inheritdoc/>
        public void Dispose()
        {
            if (colliders != null) colliders.Dispose();
            else start?.Collision.Dispose();
        }

        // Letters and digits in one form, no more of them than every file system takes, and no name that Windows keeps for a device.
        private static string Plain(string name)
        {
            char[] letters = name.ToCharArray(0, Math.Min(name.Length, MostLetters));
            for (int i = 0; i < letters.Length; i++)
                if (!char.IsLetterOrDigit(letters[i])) letters[i] = '-';
            string plain = new string(letters).Normalize();
            return plain.Length == 0 || DeviceName.IsMatch(plain) ? $"liquid{plain}" : plain;
        }

        // Each once.
        private void Report(FluidMessage message)
        {
            if (!messages.Contains(message)) messages.Add(message);
        }
    }
}
