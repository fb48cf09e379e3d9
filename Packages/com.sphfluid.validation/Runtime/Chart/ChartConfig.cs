using System;
using System.Globalization;

namespace SphFluid.Validation
{
    /// <summary>A point of the chart: a case, a method and its constants, whatever the seed.</summary>
    public sealed class ChartConfig
    {
        // Standard deviation of the start's jitter over dx.
        private const double Jitter = 0.01;

        private CaseParameters parameters;
        private bool built;
        private double spacing = double.NaN;
        private int particles;
        private double steps, timeStep, speed, softening = 1.0;
        private bool hasGravity;
        private string problem;

        /// <summary>A point.</summary>
        /// <param name="validationCase">The case.</param>
        /// <param name="parameters">Its parameters; seed and jitter are set for each run.</param>
        /// <param name="factor">What differs from the base.</param>
        public ChartConfig(ValidationCase validationCase, in CaseParameters parameters, ChartFactor factor)
        {
            Case = validationCase;
            this.parameters = parameters;
            this.parameters.Jitter = Jitter;
            Factor = factor;
        }

        /// <summary>The case.</summary>
        public ValidationCase Case { get; }

        /// <summary>What differs from the base.</summary>
        public ChartFactor Factor { get; }

        /// <summary>The method.</summary>
        public CaseMethod Method => parameters.Method;

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio => parameters.SupportRatio;

        /// <summary>Time step over the method's stable one.</summary>
        public double TimeStepFraction => parameters.TimeStepFraction;

        /// <summary>Speed of sound over the case's own speed.</summary>
        public double SoundSpeedRatio => parameters.SoundSpeedRatio;

        /// <summary>Particle spacing dx [m]; not a number when the case cannot be set up.</summary>
        public double Spacing => Built().spacing;

        /// <summary>Number of particles.</summary>
        public int Particles => Built().particles;

        /// <summary>Steps of a whole run.</summary>
        public double Steps => Built().steps;

        /// <summary>Length of a step [s].</summary>
        public double TimeStep => Built().timeStep;

        /// <summary>The case's own speed [m/s].</summary>
        public double Speed => Built().speed;

        /// <summary>
        /// Speed of sound that the liquid has in its steps over the case's own speed: less than asked for with the method Robust.
        /// </summary>
        public double EffectiveSoundSpeedRatio => SoundSpeedRatio * Built().softening;

        /// <summary>Whether gravity moves the liquid, so that its speed follows from its size.</summary>
        public bool HasGravity => Built().hasGravity;

        /// <summary>Why the case cannot be set up at this point; null when it can.</summary>
        public string Problem => Built().problem;

        /// <summary>The name of the point in files: equal for equal constants.</summary>
        public string Key => KeyOf(Case.Name, Method.Name, Spacing, SupportRatio, TimeStepFraction, SoundSpeedRatio);

        /// <summary>The parameters of a run.</summary>
        /// <param name="seed">Its seed.</param>
        public CaseParameters Parameters(int seed)
        {
            CaseParameters result = parameters;
            result.Seed = seed;
            return result;
        }

        /// <summary>The constants, for instance "dx 0.125 m, κ 2, dt 0.75, c 7.5".</summary>
        public string Constants => ConstantsOf(Spacing, SupportRatio, TimeStepFraction, SoundSpeedRatio);

        /// <summary>For progress lines, for instance "ellipsoid, thesis, dx 0.125 m, κ 2, dt 0.75, c 7.5".</summary>
        public override string ToString() => $"{Case.Name}, {Method.Name}, {Constants}";

        internal static string ConstantsOf(double spacing, double supportRatio, double timeStepFraction, double soundSpeedRatio) =>
            string.Format(CultureInfo.InvariantCulture, "dx {0:G3} m, κ {1:G4}, dt {2:G3}, c {3:G3}", spacing, supportRatio,
                timeStepFraction, soundSpeedRatio);

        internal static string KeyOf(string caseName, string method, double spacing, double supportRatio, double timeStepFraction,
            double soundSpeedRatio) =>
                string.Join("|", caseName, method, CsvText.Text(spacing), CsvText.Text(supportRatio), CsvText.Text(timeStepFraction),
                    CsvText.Text(soundSpeedRatio));

        private ChartConfig Built()
        {
            if (built) return this;
            built = true;
            try
            {
                CaseSetup setup = Case.Build(Parameters(1));
                spacing = setup.Settings.Spacing;
                particles = setup.Particles.Length;
                timeStep = setup.Settings.TimeStep;
                speed = setup.Settings.MaxSpeed;
                softening = CaseSettings.EffectiveSoundSpeed(setup.Settings) / setup.Settings.SoundSpeed;
                hasGravity = setup.Settings.Gravity != UnityEngine.Vector3.zero;
                steps = Math.Ceiling(setup.Duration / setup.Settings.TimeStep);
            }
            catch (ArgumentException exception)
            {
                problem = exception.Message;
            }
            return this;
        }
    }
}
