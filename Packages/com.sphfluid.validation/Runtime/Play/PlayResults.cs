using System.Collections.Generic;
using System.IO;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>The files at the end of a play: particles, surface, the liquid's part of timings.csv and summary.json.</summary>
    internal sealed class PlayResults
    {
        private readonly PlayArguments arguments;
        private readonly IReadOnlyList<FluidSimulation> simulations;
        private readonly IReadOnlyDictionary<FluidSimulation, SurfaceCaps> surfaces;
        private readonly IReadOnlyDictionary<FluidSimulation, ColliderSides> sides;

        /// <param name="arguments">What to write.</param>
        /// <param name="simulations">The simulations.</param>
        /// <param name="surfaces">What the surfaces of simulations that were watched could not do.</param>
        /// <param name="sides">On which side of colliders the particles of simulations that were watched began.</param>
        public PlayResults(PlayArguments arguments, IReadOnlyList<FluidSimulation> simulations,
            IReadOnlyDictionary<FluidSimulation, SurfaceCaps> surfaces,
            IReadOnlyDictionary<FluidSimulation, ColliderSides> sides)
        {
            this.sides = sides;
            this.arguments = arguments;
            this.simulations = simulations;
            this.surfaces = surfaces;
        }

        public void Write(FrameTable frames, FrameTable record, InstrumentRecord instruments)
        {
            var summaries = new List<JsonObject>();
            for (int i = 0; i < simulations.Count; i++)
            {
                FluidSnapshot snapshot = FluidSnapshot.Read(simulations[i]);
                summaries.Add(Summary(simulations[i], snapshot));
                if (arguments.StateFile != null) PlyWriter.WriteParticles(FileOf(arguments.StateFile, i), snapshot);
                if (arguments.MeshFile != null) WriteMesh(FileOf(arguments.MeshFile, i), simulations[i]);
            }
            if (arguments.RecordFile != null) WriteRecord(record, instruments);
            if (arguments.OutputFolder == null) return;
            Directory.CreateDirectory(arguments.OutputFolder);
            JsonObject all = summaries.Count == 1 ? summaries[0] : new JsonObject().Add("simulations", summaries);
            all.AppendTo(Path.Combine(arguments.OutputFolder, "summary.json"));
            string timings = Path.Combine(arguments.OutputFolder, "timings.csv");
            if (File.Exists(timings))
                frames.InsertInto(timings, "time_s");
            else
                frames.Write(timings);
        }

        // Pictures of what instruments read stand beside the table.
        private void WriteRecord(FrameTable record, InstrumentRecord instruments)
        {
            string file = Path.GetFullPath(arguments.RecordFile);
            record.Write(file);
            instruments.AppendTo(file);
            var plot = new InstrumentScript(Path.GetFileNameWithoutExtension(file) + "-instruments", instruments.Curves);
            if (!plot.IsEmpty && GnuplotScript.Draw(Path.GetDirectoryName(file), new[] { plot }) is string problem)
            {
                Debug.LogWarning($"{FluidMessage.Prefix} {problem}");
            }
        }

        // With several simulations the files are name.ply, name.1.ply, name.2.ply, ...
        private string FileOf(string file, int index) => index == 0 ? file
            : Path.ChangeExtension(file, $".{index}{Path.GetExtension(file)}");

        private static void WriteMesh(string file, FluidSimulation simulation)
        {
            SurfaceMesh mesh = PlaySurface.Extract(simulation);
            PlyWriter.WriteMesh(file, mesh, simulation.LocalToWorld);
        }

        private JsonObject Summary(FluidSimulation simulation, FluidSnapshot snapshot)
        {
            FluidSolverSettings settings = simulation.Solver.Settings;
            SnapshotStatistics statistics = SnapshotStatistics.Of(snapshot, settings);
            NeighbourCount neighbours = NeighbourCount.Of(snapshot.LocalPositions, settings.SupportRadius);
            ParticleGaps gaps = ParticleGaps.Of(snapshot.LocalPositions, settings.Spacing);
            ColliderPenetration penetration = ColliderPenetration.Of(simulation, snapshot);
            LiquidVolume volume = LiquidVolume.Of(simulation, snapshot);
            FluidCounters counters = simulation.Solver.ReadCountersNow();
            int throughColliders = sides.TryGetValue(simulation, out ColliderSides start) &&
                start.AreOf(simulation) ? start.CountChanged(simulation, snapshot) : 0;
            SurfaceCaps surface = surfaces.TryGetValue(simulation, out SurfaceCaps watched) ? watched : new SurfaceCaps();
            var summary = new JsonObject()
                .Add("simulation", simulation.name)
                .Add("method", CaseMethod.Of(simulation.ActiveMethod).Name)
                .Add("surface", PlayOverrides.SurfaceOf(simulation))
                .Add("particles", simulation.ParticleCount)
                .Add("removed_particles", counters.Removed)
                .Add("spacing_m", settings.Spacing)
                .Add("support_radius_m", settings.SupportRadius)
                .Add("time_step_s", simulation.TimeStep)
                .Add("sound_speed_m_s", settings.SoundSpeed)
                .Add("steps", simulation.StepCount)
                .Add("liquid_time_s", simulation.SimulatedTime)
                .Add("neighbours_mean", neighbours.Mean)
                .Add("neighbours_max", neighbours.Maximum)
                .Add("close_particles", gaps.CloseCount)
                .Add("nearest_over_spacing", gaps.Nearest)
                .Add("max_speed_m_s", statistics.MaxSpeed)
                .Add("rms_speed_m_s", statistics.RmsSpeed)
                .Add("density_error_mean", statistics.DensityErrorMean)
                .Add("density_error_max", statistics.DensityErrorMax)
                .Add("nonfinite_count", statistics.NonFiniteCount)
                .Add("escaped_count", statistics.EscapedCount + throughColliders)
                .Add("inside_collider_count", penetration.Inside)
                .Add("deep_inside_collider_count", penetration.Deep)
                .Add("volume_m3", LiquidVolume.IsAtRest(statistics.RmsSpeed, settings) ? volume.Measured : double.NaN)
                .Add("volume_expected_m3", volume.Expected)
                .Add("cap_hits", new JsonObject()
                    .Add("substeps", simulation.CapHits)
                    .Add("acceleration", counters.AccelerationLimitHits)
                    .Add("domain", counters.DomainClamps)
                    .Add("nonfinite", counters.NonFinite)
                    .Add("surface_stale_frames", surface.StaleFrames)
                    .Add("surface_open_faces", surface.OpenFaces)
                    .Add("surface_skipped_particles", surface.SkippedParticles))
                .Add("fluid_gpu_bytes", simulation.GpuBytes + PlaySurface.GpuBytesOf(simulation))
                .Add("state_hash", snapshot.Hash);
            if (simulation.IsPlayedBack && simulation.TryGetComponent(out FluidPlayback playback))
            {
                summary.Add("sequence", new JsonObject()
                    .Add("source", playback.Source)
                    .Add("frames", playback.FrameCount)
                    .Add("frame", playback.CurrentFrame)
                    .Add("left_out_particles", playback.LeftOutParticles)
                    .Add("memory_bytes", playback.MemoryBytes));
            }
            return simulation.MethodChoice == null ? summary : summary.Add("method_choice", PlayChoice.Of(simulation.MethodChoice));
        }
    }
}
