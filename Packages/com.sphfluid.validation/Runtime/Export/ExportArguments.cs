using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>Which scene <c>export</c> writes as a case of which engine.</summary>
    public sealed class ExportArguments : MeasuringArguments
    {
        private const string Engine = "pysph";
        private const string DefaultScene = "Packages/com.sphfluid/Samples~/DamBreak/DamBreak.unity";
        private static readonly string[] schemes = { "wcsph", "edac" };

        internal ExportArguments() : base("export", "Build/export")
        {
            var defaults = new FluidExportOptions();
            (Seconds, FrameRate, Ranks) = (defaults.Seconds, defaults.FrameRate, defaults.Ranks);
            Options.Add("--scene", "FILE.unity", "scene to export, each liquid as a case; ./run takes the name of a sample, too",
                "Dam Break, of the samples", flag => Scene = SceneFile(flag));
            Options.Add("--engine", "NAME", "engine that is to compute it", Engine, new[] { Engine }, flag => flag.OneOf(new[] { Engine }));
            Options.Add("--scheme", "NAME", "scheme that the case begins with", schemes[0], schemes,
                flag => Scheme = (FluidExportScheme)Array.IndexOf(schemes, flag.OneOf(schemes)));
            Options.Add("--seconds", "S", "time that is computed, and over which colliders' motion is recorded", $"{Seconds:0}",
                flag => Seconds = CommandLineWords.Positive(flag.Name, flag.Value()));
            Options.Add("--frame-rate", "F", "frames a second that are kept", $"{FrameRate:0}",
                flag => FrameRate = CommandLineWords.Positive(flag.Name, flag.Value()));
            Options.Add("--spacing", "D", "particle spacing of every liquid in metres", "as in the scene",
                flag => Spacing = (float)CommandLineWords.Positive(flag.Name, flag.Value()));
            Options.Add("--particles", "N", "the same liquid with about N particles", "as in the scene",
                flag => Particles = flag.Integer(1, int.MaxValue));
            Options.Add("--ranks", "N", "processes that the scripts start", $"{Ranks}",
                flag => Ranks = flag.Integer(1, FluidExportOptions.MostRanks));
            Options.Add("--strict", "writes nothing where a part of the scene cannot be exported", flag => Strict = flag.On());
            AddFolder();
        }

        /// <summary>The scene's file, below the project.</summary>
        public string Scene { get; private set; } = DefaultScene;

        /// <summary>Scheme that the case begins with.</summary>
        public FluidExportScheme Scheme { get; private set; }

        /// <summary>Time that is computed [s].</summary>
        public double Seconds { get; private set; }

        /// <summary>Frames a second that are kept.</summary>
        public double FrameRate { get; private set; }

        /// <summary>Particle spacing of every liquid [m]; null keeps the scene's.</summary>
        public float? Spacing { get; private set; }

        /// <summary>Number of particles of every liquid, by rescaling its spacing; null keeps the scene's.</summary>
        public int? Particles { get; private set; }

        /// <summary>Processes that the scripts start.</summary>
        public int Ranks { get; private set; }

        /// <summary>Whether nothing is written where a part of the scene cannot be exported.</summary>
        public bool Strict { get; private set; }

        /// <summary>Reads the command line of the process.</summary>
        /// <exception cref="CommandLineException">A flag is unknown, a value is missing or wrong, or two flags contradict each
        /// other.</exception>
        public static ExportArguments Parse(IReadOnlyList<string> commandLine)
        {
            var result = new ExportArguments();
            result.Read(commandLine);
            if (result.Spacing != null && result.Particles != null)
            {
                throw new CommandLineException("--spacing and --particles both set the spacing; give one of them.");
            }
            if (result.Seconds * result.FrameRate > FluidExportOptions.MostFrames)
            {
                throw new CommandLineException(FormattableString.Invariant(
                    $"--seconds {result.Seconds} at --frame-rate {result.FrameRate} are more than {FluidExportOptions.MostFrames} ") +
                    "frames; compute less time or keep fewer frames a second.");
            }
            return result;
        }

        private static string SceneFile(CommandLineFlag flag)
        {
            string value = flag.Value();
            if (!value.EndsWith(".unity", StringComparison.Ordinal))
            {
                throw new CommandLineException($"--scene must be a .unity file of the project, found '{CommandLineWords.Shown(value)}'.");
            }
            return value;
        }
    }
}
