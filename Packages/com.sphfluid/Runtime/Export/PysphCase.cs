using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Writes an exported liquid as a case of PySPH: data as NumPy reads it, scripts and a manifest.</summary>
    internal sealed class PysphCase
    {
        /// <summary>Version of PySPH that the scripts were made for and are tested with.</summary>
        public const string EngineVersion = "1.0b1";

        readonly ExportConstants constants;
        readonly FluidExportOptions options;
        readonly string simulation;

        /// <param name="simulation">Name of the simulation.</param>
        /// <param name="constants">What it computes with.</param>
        /// <param name="options">What is computed, with a scene.</param>
        public PysphCase(string simulation, in ExportConstants constants, FluidExportOptions options)
        {
            this.simulation = simulation;
            this.constants = constants;
            this.options = options;
        }

        /// <summary>
        /// Layers of a wall that the outermost liquid feels, half a spacing before the face: its kernel ends 2 h away with WCSPH, 3 h with EDAC, h = 1.3 dx. PySPH's
        /// dam break has two as well.
        /// </summary>
        public static int Layers(FluidExportScheme scheme) => scheme == FluidExportScheme.Edac ? 3 : 2;

        public StoredParticle[] Liquid { get; set; } = Array.Empty<StoredParticle>();
        public WallParticle[] Walls { get; set; } = Array.Empty<WallParticle>();
        public IReadOnlyList<ExportBody> Bodies { get; set; } = Array.Empty<ExportBody>();
        public IReadOnlyList<ExportInstrument> Instruments { get; set; } = Array.Empty<ExportInstrument>();

        /// <summary>What is not exported, for the manifest.</summary>
        public IReadOnlyList<FluidMessage> Messages { get; set; } = Array.Empty<FluidMessage>();

        string Scheme => options.Scheme == FluidExportScheme.Edac ? "EDAC" : "WCSPH";

        /// <summary>Writes the case.</summary>
        /// <param name="path">The folder.</param>
        /// <returns>Bytes written.</returns>
        /// <exception cref="System.IO.IOException">The folder holds what no export wrote, or cannot be written.</exception>
        public long Write(string path)
        {
            ExportFolder folder = ExportFolder.Open(path);
            folder.Write("liquid.npy", stream => NpyFile.Write(stream, StoredParticle.Columns, Liquid));
            if (Walls.Length > 0) folder.Write("walls.npy", stream => NpyFile.Write(stream, WallParticle.Columns, Walls));
            for (int i = 0; i < Bodies.Count; i++)
            {
                ExportBody body = Bodies[i];
                folder.Write($"body-{i:000}.npy", stream => NpyFile.Write(stream, WallParticle.Columns, body.Particles));
                folder.Write($"body-{i:000}-path.npy", stream => NpyFile.Write(stream, BodyPose.Columns, body.Path.ToArray()));
            }
            folder.WriteText("case.py", Filled(CaseScript.Text));
            folder.WriteText("to_sequence.py", SequenceScript.Text);
            if (Instruments.Count > 0) folder.WriteText("readings.py", Filled(ReadingScript.Text));
            folder.WriteText("run.sh", Filled(RunScripts.Local));
            folder.WriteText("job.sbatch", Filled(RunScripts.Slurm));
            folder.Close(Manifest());
            return folder.Bytes;
        }

        ExportManifest Manifest() => new ExportManifest
        {
            commit = options.Commit ?? "",
            scene = options.Scene,
            simulation = simulation,
            scheme = Scheme,
            seconds = options.Seconds,
            frameRate = options.FrameRate,
            spacing = Exact(constants.Spacing),
            domainSize = Exact(constants.DomainSize),
            position = Exact(constants.Position),
            rotation = new[] { Exact(constants.Rotation.x), Exact(constants.Rotation.y), Exact(constants.Rotation.z), Exact(constants.Rotation.w) },
            openFaces = Enum.GetValues(typeof(FluidFaces)).Cast<FluidFaces>().Where(f => IsOne(f) && (constants.Boundaries.Open & f) != 0).Select(f => $"{f}").ToList(),
            liquidParticles = Liquid.Length,
            wallParticles = Walls.Length,
            bodies = Bodies.Select(b => new ExportManifest.Body { name = b.Name, particles = b.Particles.Length, poses = b.Path.Count }).ToList(),
            instruments = Instruments.Select(i => i.Name).ToList(),
            notExported = Messages.Where(m => m.Issue == FluidIssue.NotExported)
                .Select(m => new ExportManifest.Note { name = m.Source, text = m.Text, cure = m.Cure }).ToList(),
        };

        string Filled(string template)
        {
            var values = new Dictionary<string, string>
            {
                ["TITLE"] = Plain($"{simulation} of the scene {options.Scene}"),
                ["VERSION"] = FluidPackage.Version,
                ["ENGINE"] = EngineVersion,
                ["SPACING"] = Number(constants.Spacing),
                ["DENSITY"] = Number(constants.Density),
                ["VISCOSITY"] = Number(constants.Viscosity),
                ["SOUND"] = Number(constants.SoundSpeed),
                ["GRAVITY"] = Numbers(constants.Gravity),
                ["SECONDS"] = options.Seconds.ToString("R", CultureInfo.InvariantCulture),
                ["FRAMERATE"] = options.FrameRate.ToString("R", CultureInfo.InvariantCulture),
                ["BOX"] = Numbers(constants.DomainSize),
                ["PERIODIC"] = string.Join(", ", new[] { FluidAxes.X, FluidAxes.Y, FluidAxes.Z }.Select(a => (constants.Boundaries.Periodic & a) != 0 ? "True" : "False")),
                ["SOLIDS"] = string.Join(", ", (Walls.Length > 0 ? new[] { "'walls'" } : Array.Empty<string>()).Concat(Bodies.Select((b, i) => $"'body{i}'"))),
                ["SCHEME"] = Scheme.ToLowerInvariant(),
                ["RANKS"] = options.Ranks.ToString(CultureInfo.InvariantCulture),
                ["JOB"] = Plain(simulation).Replace(' ', '-'),
                ["PROBES"] = string.Concat(Instruments.Where(i => i.Property != null).Select(i => $"    ({Quoted(i.Name)}, '{i.Property}', ({Numbers(i.Place)})),\n")),
                ["GAUGES"] = string.Concat(Instruments.Where(i => i.Property == null)
                    .Select(i => $"    ({Quoted(i.Name)}, ({Numbers(i.Place)}), ({Numbers(i.Up)}), {Number(i.Length)}),\n")),
                ["READINGS"] = Instruments.Count > 0 ? "\"${PYTHON:-python3}\" readings.py out readings.csv\n" : "",
            };
            string text = template.Replace("\r\n", "\n");
            foreach (KeyValuePair<string, string> value in values) text = text.Replace($"@{value.Key}@", value.Value);
            return text;
        }

        static bool IsOne(FluidFaces face) => face != FluidFaces.None && (face & (face - 1)) == 0;

        static string Numbers(Vector3 v) => $"{Number(v.x)}, {Number(v.y)}, {Number(v.z)}";

        // A float as one writes it: 0.025, not the double next to it.
        static string Number(float value) => Exact(value).ToString("R", CultureInfo.InvariantCulture);

        static double[] Exact(Vector3 v) => new[] { Exact(v.x), Exact(v.y), Exact(v.z) };

        static double Exact(float value) => double.Parse(value.ToString("R", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);

        // In headings and names of jobs: letters, digits and a few signs.
        static string Plain(string text) => new string(text.Select(c => char.IsLetterOrDigit(c) || " .-_".IndexOf(c) >= 0 ? c : '_').ToArray());

        static string Quoted(string text)
        {
            var quoted = new StringBuilder("'");
            foreach (char c in text)
                if (c == '\'' || c == '\\') quoted.Append('\\').Append(c);
                else if (c < ' ') quoted.Append("\\x").Append(((int)c).ToString("x2", CultureInfo.InvariantCulture));
                else quoted.Append(c);
            return quoted.Append('\'').ToString();
        }
    }
}
