using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// What <c>play</c> changes in the scene's simulations and which files it writes. Only the flags of the liquid are
    /// read here; scene, time, size and device belong to the program that plays the scene.
    /// </summary>
    public sealed class PlayArguments
    {
        private const string OutFlag = "--out";
        private const string AutomaticName = "automatic";
        private const string MeshText =
            "writes the surface at the end: with marching-cubes the sparse one, with marching-cubes-gs and cubes the thesis's grid, " +
            "with particles and none as the scene's own surface component would make it";
        private static readonly string[] surfaces = { "marching-cubes", "marching-cubes-gs", "cubes", "particles", "none" };

        internal PlayArguments()
        {
            string[] methods = CaseMethod.All.Where(m => CaseMethod.Of(m.Kind) == m).Select(m => m.Name).Append(AutomaticName).ToArray();
            Options.Add("--method", "NAME", "solver of every liquid (automatic: the one that fits the frame budget)", "as in the scene",
                methods, flag => Method = KindOf(flag.OneOf(methods)));
            Options.Add("--liquid", "NAME", "what every liquid is", "as in the scene", PackageLiquids.Names,
                flag => Liquid = flag.OneOf(PackageLiquids.Names));
            Options.Add("--budget", "MS", "milliseconds a frame that the steps of every liquid may take with --method automatic",
                "as in the scene",
                flag => Budget = (float)flag.Milliseconds());
            Options.Add("--surface", "NAME", "how every liquid is drawn (none: not at all)", "as in the scene", surfaces,
                flag => Surface = flag.OneOf(surfaces));
            Options.Add("--particles", "N", "the same liquid with about N particles", "as in the scene",
                flag => Particles = flag.Integer(1, int.MaxValue));
            Options.Add("--seed", "N", "seed of the start jitter", "as in the scene", flag => Seed = flag.Integer(0, int.MaxValue));
            Options.Add("--profile", "LIST",
                "numbers of every liquid's profile, as support-ratio=2,substeps=2; of " + string.Join(" | ", ProfileNumbers.Names),
                "as in the scene", flag => Profile = ProfileNumbers.Parse(flag.Name, flag.Value()));
            Options.Add("--sequence", "DIR", "plays the liquid from the particle files of a sequence instead of simulating it", null,
                flag => Sequence = flag.Value());
            Options.Add("--write-sequence", "DIR", "writes the particles of every frame as a sequence", null,
                flag => SequenceFolder = flag.Folder());
            Options.Add("--state", "FILE.ply", "writes the particles at the end", null, flag => StateFile = flag.File(".ply"));
            Options.Add("--mesh", "FILE.ply", MeshText, null, flag => MeshFile = flag.File(".ply"));
            Options.Add("--record", "FILE.csv",
                "writes speed, density error, energy and centre of mass of every frame, and what instruments read, with a plot", null,
                flag => RecordFile = flag.File(".csv"));
        }

        internal CommandLineOptions Options { get; } = new CommandLineOptions("play's liquid");

        /// <summary>Method for every simulation; null keeps the scene's.</summary>
        public FluidMethodKind? Method { get; private set; }

        /// <summary>Liquid for every simulation, one of <see cref="PackageLiquids.Names"/>; null keeps the scene's.</summary>
        public string Liquid { get; private set; }

        /// <summary>Frame budget for every simulation [ms]; null keeps the scene's.</summary>
        public float? Budget { get; private set; }

        /// <summary>
        /// Drawing for every simulation: marching-cubes, marching-cubes-gs, cubes, particles or none; null keeps the scene's.
        /// </summary>
        public string Surface { get; private set; }

        /// <summary>Number of particles for every simulation, by rescaling its spacing; null keeps the scene's.</summary>
        public int? Particles { get; private set; }

        /// <summary>Seed of the start jitter; null keeps the scene's.</summary>
        public int? Seed { get; private set; }

        /// <summary>Numbers for every simulation's profile; null keeps the scene's.</summary>
        internal ProfileNumbers Profile { get; private set; }

        /// <summary>Folder of a sequence that is played in the place of the scene's liquid, or null.</summary>
        public string Sequence { get; private set; }

        /// <summary>Folder for the particles of every frame as a sequence, or null.</summary>
        public string SequenceFolder { get; private set; }

        /// <summary>File for the particles at the end (PLY), or null.</summary>
        public string StateFile { get; private set; }

        /// <summary>File for the surface at the end (PLY), or null.</summary>
        public string MeshFile { get; private set; }

        /// <summary>File for a row of measured quantities each frame (CSV), or null.</summary>
        public string RecordFile { get; private set; }

        /// <summary>Folder that the playing program writes to, or null.</summary>
        public string OutputFolder { get; private set; }

        /// <summary>
        /// Reads the whole command line of the process. Flags before a lone <c>--</c> belong to the playing program, of
        /// which only <c>--out DIR</c> is read; without a <c>--</c> flags of others are passed over.
        /// </summary>
        /// <exception cref="CommandLineException">A flag after <c>--</c> is unknown, or a value is missing or wrong.</exception>
        public static PlayArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new PlayArguments();
            int separator = CommandLineWords.Separator(commandLine);
            int end = separator < 0 ? commandLine.Count : separator;
            for (int i = 0; i < end; i++)
            {
                if (commandLine[i] == OutFlag && i + 1 < end)
                    result.OutputFolder = commandLine[++i];
                else if (commandLine[i].StartsWith(OutFlag + "=", StringComparison.Ordinal))
                    result.OutputFolder = commandLine[i].Substring(OutFlag.Length + 1);
            }
            result.Options.Read(commandLine);
            result.RequireDifferentFiles();
            result.RequireUse();
            return result;
        }

        private static FluidMethodKind KindOf(string name) => name == AutomaticName ? FluidMethodKind.Automatic
            : CaseMethod.Find(name).Kind;

        private void RequireUse()
        {
            if (Budget != null && Method != null && Method != FluidMethodKind.Automatic)
            {
                throw new CommandLineException(
                    $"--budget acts with --method {AutomaticName} only; give --method {AutomaticName}, or no budget.");
            }
            // What is played is not started: it has its own particles.
            string idle = Sequence == null ? null : Method != null ? "--method" : Budget != null ? "--budget" : Particles != null
                ? "--particles" : Seed != null ? "--seed" : Profile != null ? "--profile" : null;
            if (idle != null)
            {
                throw new CommandLineException(
                    $"{idle} changes how a liquid starts, and --sequence plays one that is there; give one of them.");
            }
            if (SequenceFolder != null && Directory.Exists(SequenceFolder) &&
                (File.Exists(Path.Combine(SequenceFolder, "sequence.json")) || Directory.GetFiles(SequenceFolder, "*.ply").Length > 0))
            {
                throw new CommandLineException(
                    $"--write-sequence: '{CommandLineWords.Shown(SequenceFolder)}' holds a sequence or .ply files already; name another " +
                    "folder.");
            }
        }

        private void RequireDifferentFiles()
        {
            if (StateFile != null && MeshFile != null && Path.GetFullPath(StateFile) == Path.GetFullPath(MeshFile))
            {
                throw new CommandLineException("--state and --mesh name the same file; give them two.");
            }
            if (RecordFile != null && OutputFolder != null &&
                Path.GetFullPath(RecordFile) == Path.GetFullPath(Path.Combine(OutputFolder, "timings.csv")))
            {
                throw new CommandLineException("--record names timings.csv of the folder of --out; give it another name.");
            }
        }
    }
}
