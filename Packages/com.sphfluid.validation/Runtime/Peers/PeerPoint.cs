namespace SphFluid.Validation
{
    /// <summary>A run of another program: a case, its resolution and its speed of sound.</summary>
    internal sealed class PeerPoint
    {
        private const int Seed = 1;

        private CaseSetup setup;

        /// <summary>A run.</summary>
        /// <param name="peer">The case.</param>
        /// <param name="resolution">Particles along the case's length.</param>
        /// <param name="soundSpeedRatio">Speed of sound over the case's own speed.</param>
        public PeerPoint(PeerCase peer, int resolution, double soundSpeedRatio)
        {
            Peer = peer;
            CaseParameters parameters = peer.Case.Base(CaseMethod.Of(FluidMethodKind.Standard));
            (parameters.Resolution, parameters.SoundSpeedRatio, parameters.Seed) = (resolution, soundSpeedRatio, Seed);
            Parameters = parameters;
        }

        /// <summary>The case.</summary>
        public PeerCase Peer { get; }

        /// <summary>
        /// The parameters of which the case makes particles and metric: those of the method Standard but for resolution and speed of sound.
        /// </summary>
        public CaseParameters Parameters { get; }

        /// <summary>Particles, box, forces and times.</summary>
        public CaseSetup Setup => setup ??= Peer.Case.Build(Parameters);

        /// <summary>Expected work: steps go with the speed of sound over the spacing.</summary>
        public double Cost => Setup.Particles.Length * Setup.Duration * Setup.Settings.SoundSpeed / Setup.Settings.Spacing;

        /// <summary>The row's key.</summary>
        public string Key => KeyOf(Peer.Case.Name, Peer.Method, Setup.Settings.Spacing, Parameters.SoundSpeedRatio, Seed);

        /// <summary>For progress lines.</summary>
        public override string ToString() => System.FormattableString.Invariant(
            $"{Peer.Case.Name}, {Peer.Method}, dx {Setup.Settings.Spacing:G3} m, c {Parameters.SoundSpeedRatio:G3}");

        internal static string KeyOf(string caseName, string method, double spacing, double soundSpeedRatio, int seed) =>
            string.Join("|", caseName, method, CsvText.Text(spacing), CsvText.Text(soundSpeedRatio), CsvText.Text(seed));
    }
}
