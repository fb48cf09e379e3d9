using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Writes an exported liquid as a case of PySPH: data as NumPy reads it, scripts and a manifest.</summary>
    internal sealed class PysphCase
    {
        /// <summary>Version of PySPH that the scripts were made for and are tested with.</summary>
        public const string EngineVersion = "1.0b1";

        private readonly ExportConstants constants;
        private readonly FluidExportOptions options;
        private readonly string simulation;

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
        /// Layers of a wall that the outermost liquid feels, half a spacing before the face: its kernel ends 2 h away with WCSPH, 3 h with
        /// EDAC, h = 1.3 dx. PySPH's dam break has two as well.
        /// </summary>
        public static int Layers(FluidExportScheme scheme) => scheme == FluidExportScheme.Edac ? 3 : 2;

        public LiquidParticle[] Liquid { get; set; } = Array.Empty<LiquidParticle>();
        public WallParticle[] Walls { get; set; } = Array.Empty<WallParticle>();
        public IReadOnlyList<ExportBody> Bodies { get; set; } = Array.Empty<ExportBody>();
        public IReadOnlyList<ExportInstrument> Instruments { get; set; } = Array.Empty<ExportInstrument>();

        /// <summary>What is not exported, for the manifest.</summary>
        public IReadOnlyList<FluidMessage> Messages { get; set; } = Array.Empty<FluidMessage>();

        private string Scheme => options.Scheme == FluidExportScheme.Edac ? "EDAC" : "WCSPH";

        /// <summary>Writes the case.</summary>
        /// <param name="path">The folder.</param>
        /// <returns>Bytes written.</returns>
        /// <exception cref="System.IO.IOException">The folder holds what no export wrote, or cannot be written.</exception>
        public long Write(string path)
        {
            ExportFolder folder = ExportFolder.Open(path);
            folder.Write("liquid.npy", stream => NpyFile.Write(stream, LiquidParticle.Columns, Liquid));
            if (Walls.Length > 0) folder.Write("walls.npy", stream => NpyFile.Write(stream, WallParticle.Columns, Walls));
            for (int i = 0; i < Bodies.Count; i++)
            {
                ExportBody body = Bodies[i];
                folder.Write($"body-{i:000}.npy", stream => NpyFile.Write(stream, WallParticle.Columns, body.Particles));
                folder.Write($"body-{i:000}-path.npy", stream => NpyFile.Write(stream, BodyPose.Columns, body.Path.ToArray()));
            }
            foreach (string script in new[] { "case.py", "to_sequence.py", "readings.py", "run.sh", "job.sbatch" })
                if (script != "readings.py" || Instruments.Count > 0) folder.WriteText(script, CaseScripts.Text(script, options.Ranks));
            folder.Close(Manifest());
            return folder.Bytes;
        }

        private ExportManifest Manifest() => new ExportManifest
        {
            commit = options.Commit ?? "",
            scene = options.Scene,
            simulation = simulation,
            scheme = Scheme,
            seconds = options.Seconds,
            frameRate = options.FrameRate,
            spacing = Exact(constants.Spacing),
            density = Exact(constants.Density),
            viscosity = Exact(constants.Viscosity),
            soundSpeed = Exact(constants.SoundSpeed),
            gravity = Exact(constants.Gravity),
            domainSize = Exact(constants.DomainSize),
            position = Exact(constants.Position),
            rotation = new[] { Exact(constants.Rotation.x), Exact(constants.Rotation.y), Exact(constants.Rotation.z),
                Exact(constants.Rotation.w) },
            openFaces = Enum.GetValues(typeof(FluidFaces)).Cast<FluidFaces>().Where(f => IsOne(f) && (constants.Boundaries.Open & f) != 0)
                .Select(f => $"{f}").ToList(),
            periodicAxes = new[] { FluidAxes.X, FluidAxes.Y, FluidAxes.Z }.Where(a => (constants.Boundaries.Periodic & a) != 0)
                .Select(a => $"{a}").ToList(),
            liquidParticles = Liquid.Length,
            wallParticles = Walls.Length,
            bodies = Bodies.Select(b => new ExportManifest.Body { name = b.Name, particles = b.Particles.Length, poses = b.Path.Count })
                .ToList(),
            readings = Instruments.Select(i => new ExportManifest.Reading
            {
                name = i.Name, property = i.Property, place = Exact(i.Place), up = Exact(i.Up), length = Exact(i.Length),
            }).ToList(),
            notExported = Messages.Where(m => m.Issue == FluidIssue.NotExported)
                .Select(m => new ExportManifest.Note { name = m.Source, text = m.Text, cure = m.Cure }).ToList(),
        };

        private static bool IsOne(FluidFaces face) => face != FluidFaces.None && (face & (face - 1)) == 0;

        private static double[] Exact(Vector3 v) => new[] { Exact(v.x), Exact(v.y), Exact(v.z) };

        // A float as one writes it: 0.025, not the double next to it.
        private static double Exact(float value) =>
            double.Parse(value.ToString("R", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
    }
}
