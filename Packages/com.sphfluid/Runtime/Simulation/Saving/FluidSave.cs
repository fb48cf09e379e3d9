using System;
using System.Collections.Generic;
using System.IO;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// A liquid as a save holds it, section by section: what it was made on, what it is, its particles, and what each part of a run goes on
    /// from.
    /// </summary>
    internal sealed class FluidSave
    {
        public const string About = "ABOUT", Liquid = "LIQUID", Particles = "PARTICLE", Run = "RUN", Pace = "PACE", Flows = "FLOWS",
            Zones = "ZONES", Colliders = "COLLIDER", Floats = "FLOATS", Choice = "CHOICE", Offsets = "OFFSETS",
            Detail = "DETAIL";

        private readonly Dictionary<string, byte[]> sections;
        private readonly List<string> missing = new List<string>();

        private FluidSave(Dictionary<string, byte[]> sections)
        {
            this.sections = sections;
            SaveReader about = Section(About);
            Device = about.ReadText();
            SaveReader liquid = Section(Liquid);
            Identity = liquid.Read<SaveIdentity>();
            LiquidExtent extent = LiquidExtent.Load(liquid);
            Start = new FluidStart(new List<FluidParticle>(), liquid.Read<long>(), extent,
                liquid.Read<float>())
            { Gravity = liquid.Read<Vector3>() };
            Progress = liquid.Read<SolverProgress>();
            Live = SavedParticles.Load(Section(Particles));
            if (Has(Offsets)) SavedParticles.LoadOffsets(Section(Offsets), Live);
        }

        /// <summary>Device and driver that it was made on.</summary>
        public string Device { get; }

        /// <summary>The device and driver of now.</summary>
        public static string PresentDevice => $"{SystemInfo.graphicsDeviceName}, {SystemInfo.graphicsDeviceVersion}";

        /// <summary>What the simulation must have in common with it.</summary>
        public SaveIdentity Identity { get; }

        /// <summary>How the liquid started once: its constants follow from that.</summary>
        public FluidStart Start { get; }

        /// <summary>How far it has come.</summary>
        public SolverProgress Progress { get; }

        /// <summary>Its particles by number.</summary>
        public FluidParticle[] Live { get; }

        /// <summary>Keys of what it speaks of and the scene does not have, as far as it was read.</summary>
        public IReadOnlyList<string> Missing => missing;

        /// <summary>Sections of a liquid, waiting for the GPU; the run adds its own.</summary>
        public static List<(string name, SaveWriter contents)> Collect(in FluidSpec spec, FluidStart start, FluidSolver solver)
        {
            var about = new SaveWriter();
            about.WriteText(PresentDevice);
            about.WriteText(Application.unityVersion);
            var liquid = new SaveWriter();
            liquid.Write(SaveIdentity.Create(spec));
            start.Extent.Save(liquid);
            liquid.Write(start.Count);
            liquid.Write(start.InitialSpeed);
            liquid.Write(start.Gravity);
            solver.ReadCountersNow();
            liquid.Write(solver.Progress);
            FluidParticle[] live = SavedParticles.Read(solver);
            var particles = new SaveWriter();
            SavedParticles.Save(particles, live);
            var sections = new List<(string, SaveWriter)> { (About, about), (Liquid, liquid), (Particles, particles) };
            if (Array.Exists(live, p => p.DensityOffset != 0f))
            {
                var offsets = new SaveWriter();
                SavedParticles.SaveOffsets(offsets, live);
                sections.Add((Offsets, offsets));
            }
            if (start.Choice == null) return sections;
            var choice = new SaveWriter();
            start.Choice.Save(choice);
            sections.Add((Choice, choice));
            return sections;
        }

        /// <summary>
        /// The method that a simulation with the method Automatic goes on by: the one of the save, whatever would be picked now.
        /// </summary>
        public FluidMethodChoice ChoiceFor(in FluidSpec spec) =>
            Has(Choice) ? FluidMethodChoice.Load(spec.Automatic, Section(Choice))
                : FluidMethodChoice.OfSave(spec, Identity.Method, Start.Count);

        /// <summary>The sections as a run goes on from them.</summary>
        public static FluidSave From(List<(string name, SaveWriter contents)> sections)
        {
            var found = new Dictionary<string, byte[]>();
            foreach ((string name, SaveWriter contents) in sections) found.Add(name, contents.Bytes.ToArray());
            return new FluidSave(found);
        }

        /// <summary>Reads a save.</summary>
        /// <exception cref="InvalidDataException">It is none, or not whole; the message ends a sentence that begins with "the
        /// save".</exception>
        public static FluidSave Read(Stream stream) => new FluidSave(SaveFile.Read(stream));

        /// <summary>Whether a part of a run is in it.</summary>
        public bool Has(string name) => sections.ContainsKey(name);

        /// <summary>What a part of a run goes on from.</summary>
        /// <exception cref="InvalidDataException">There is no such section.</exception>
        public SaveReader Section(string name) => sections.TryGetValue(name, out byte[] contents)
            ? new SaveReader(name, contents, missing)
            : throw new InvalidDataException($"has no section {name}");
    }
}
