using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// What <c>play</c> changes in the scene's simulations and which files it writes. Only the flags of the liquid are
    /// read here; scene, time, size and device belong to the program that plays the scene.
    /// </summary>
    public sealed class PlayArguments
    {
        static readonly string[] flags = { "--method", "--surface", "--particles", "--seed", "--state", "--mesh", "--record" };
        static readonly string[] surfaces = { "marching-cubes", "marching-cubes-gs", "cubes", "particles", "none" };

        /// <summary>Method for every simulation; null keeps the scene's.</summary>
        public FluidMethodKind? Method { get; private set; }

        /// <summary>Drawing for every simulation: marching-cubes, marching-cubes-gs, cubes, particles or none; null keeps the scene's.</summary>
        public string Surface { get; private set; }

        /// <summary>Number of particles for every simulation, by rescaling its spacing; null keeps the scene's.</summary>
        public int? Particles { get; private set; }

        /// <summary>Seed of the start jitter; null keeps the scene's.</summary>
        public int? Seed { get; private set; }

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
            for (int i = 0; i < commandLine.Count; i++)
            {
                string flag = commandLine[i];
                if (flag == "--out" && i < commandLine.Count - 1 && (separator < 0 || i < separator))
                    result.OutputFolder = commandLine[++i];
                else if (i > separator && Array.IndexOf(flags, flag) >= 0)
                    result.Read(flag, CommandLineWords.Value(commandLine, ref i));
                else if (separator >= 0 && i > separator)
                    throw new CommandLineException($"{flag} is not a flag of play. The liquid's flags are {string.Join(", ", flags)}; --help tells the others.");
            }
            return result;
        }

        void Read(string flag, string value)
        {
            switch (flag)
            {
                case "--method":
                    CommandLineWords.RequireOneOf(flag, value, CaseMethod.All.Select(m => m.Name).ToArray());
                    Method = CaseMethod.Find(value).Kind;
                    break;
                case "--surface":
                    CommandLineWords.RequireOneOf(flag, value, surfaces);
                    Surface = value;
                    break;
                case "--particles":
                    Particles = Integer(flag, value, 1);
                    break;
                case "--seed":
                    Seed = Integer(flag, value, 0);
                    break;
                case "--state":
                    StateFile = FileWithEnding(flag, value, ".ply");
                    break;
                case "--mesh":
                    MeshFile = FileWithEnding(flag, value, ".ply");
                    break;
                case "--record":
                    RecordFile = FileWithEnding(flag, value, ".csv");
                    break;
            }
        }

        static int Integer(string flag, string value, int minimum)
        {
            if (!int.TryParse(value, NumberStyles.Integer, CultureInfo.InvariantCulture, out int number) || number < minimum)
                throw new CommandLineException($"{flag} must be a whole number of at least {minimum}, found '{value}'.");
            return number;
        }

        static string FileWithEnding(string flag, string value, string ending)
        {
            if (!value.EndsWith(ending, StringComparison.OrdinalIgnoreCase))
                throw new CommandLineException($"{flag} must be a file ending in {ending}, found '{value}'.");
            return value;
        }
    }
}
