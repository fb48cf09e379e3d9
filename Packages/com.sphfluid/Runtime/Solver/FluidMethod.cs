using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// All that the rest of the package knows of a method: its constants by rule, its limits, its shaders, the profile's fields that it
    /// reads, and what steps a liquid by it. A method is one folder with a class like this, and a line in <see cref="FluidMethods"/> or a
    /// call of its Register.
    /// </summary>
    internal abstract class FluidMethod
    {
        /// <summary>What users choose it by.</summary>
        public abstract FluidMethodKind Kind { get; }

        /// <summary>What it can do.</summary>
        public abstract FluidMethodFeatures Features { get; }

        /// <summary>Its shaders and what they need of a device.</summary>
        public abstract ShaderGroup Shaders { get; }

        /// <summary>A surface that the method brings along, for drawing its liquid; null where it has none of its own.</summary>
        public virtual ShaderGroup OwnSurface => null;

        /// <summary>Fields of a profile that this method reads and not all others do, by their serialised names.</summary>
        public abstract IReadOnlyList<string> ProfileFields { get; }

        /// <summary>Most cells of its neighbour search.</summary>
        public abstract long MaxCells { get; }

        /// <summary>Whether a cell takes memory without particles too, however many there are.</summary>
        public virtual bool StoresEmptyCells => true;

        /// <summary>Constants by rule.</summary>
        /// <exception cref="ArgumentException">An input is out of range.</exception>
        public abstract FluidSolverSettings Derive(in FluidRuleInput input);

        /// <summary>The largest stable step of a liquid whose fastest particle has a speed [m/s].</summary>
        public abstract TimeStepAdvice Advise(in FluidSolverSettings settings, double maxSpeed);

        /// <summary>A clock that cuts each frame into the method's steps; null where steps are as long as stability allows.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="maxSteps">Most steps a frame.</param>
        public virtual IStepClock MakeClock(in FluidSolverSettings settings, int maxSteps) => null;

        /// <summary>Speed of sound that the liquid has, which its steps may make less than that of the settings [m/s].</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <param name="speed">Speed of the fastest particle [m/s].</param>
        public virtual double EffectiveSoundSpeed(in FluidSolverSettings settings, double timeStep, double speed) => settings.SoundSpeed;

        /// <summary>Kinematic viscosity that acts, which long steps may make less than that of the settings [m²/s].</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        public virtual double ActingViscosity(in FluidSolverSettings settings, double timeStep) =>
            settings.Viscosity / (double)settings.RestDensity;

        /// <summary>What users are told of a liquid by this method, besides what holds for all methods: labels and values.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="timeStep">Length of a step [s].</param>
        /// <param name="speed">Speed of the fastest particle [m/s].</param>
        public virtual IReadOnlyList<(string Label, string Value)> Remarks(in FluidSolverSettings settings, double timeStep,
            double speed) =>
                Array.Empty<(string, string)>();

        /// <summary>What a frame asks for.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="frameTime">The frame [s].</param>
        /// <param name="speed">Speed of the fastest particle [m/s].</param>
        /// <param name="stepFraction">Step over the stable one, where that decides.</param>
        public virtual FrameWork WorkOf(in FluidSolverSettings settings, double frameTime, double speed, double stepFraction)
        {
            int steps = FrameWork.StepsOf(frameTime, Advise(settings, speed).Step(stepFraction));
            return new FrameWork(steps, 2.0, steps); // density and forces
        }

        /// <summary>What makes its steps shorter, the beginning of a cure.</summary>
        public string ShorterSteps => "With Time Step Mode Fixed shorten Fixed Time Step; else " +
            (Has(FluidMethodFeatures.StepsByFrame) ? "raise the profile's Substeps" : "lower the profile's Time Step Fraction");

        /// <summary>
        /// How many times longer steps this method can take of a liquid that is worth less work, no more than asked for; 1: none.
        /// </summary>
        /// <param name="input">The liquid as its profile asks.</param>
        /// <param name="asked">How many times longer they are to be, 1 or more.</param>
        public virtual double CoarsestFactor(in FluidRuleInput input, double asked) => 1.0;

        /// <summary>Rules for steps that are so many times longer, 1 to <see cref="CoarsestFactor"/>.</summary>
        public virtual FluidRuleInput Coarsen(FluidRuleInput rules, double factor) => rules;

        /// <summary>Why steps are not as long as asked for, the end of a sentence; null: they are.</summary>
        public virtual string CoarsestReason(in FluidRuleInput input, double asked, double reached) =>
            asked > reached ? $", and the method {Kind} takes them as they are." : null;

        /// <summary>And the cure.</summary>
        public virtual string CoarsestCure => "Use the method Standard or Robust, or set Step Factor to 1.";

        /// <summary>Whether cells of 2R are searched by octants, not cells of R by rows.</summary>
        public virtual bool SearchesOctants(in FluidRuleInput input) => false;

        /// <summary>Cells that a liquid of these settings has; along periodic axes that are too short none.</summary>
        public virtual double CellCount(in FluidSolverSettings settings) => FluidGrid.CountFor(settings, 0);

        /// <summary>Whether the density leaves out the particle's own share.</summary>
        public virtual bool OmitsOwnDensity(in FluidSolverSettings settings) => false;

        /// <summary>The settings as the method computes with them.</summary>
        public virtual FluidSolverSettings Prepare(in FluidSolverSettings settings) => settings;

        /// <summary>Starts a liquid.</summary>
        /// <param name="settings">Constants that were checked and prepared.</param>
        /// <param name="shaders">The shaders.</param>
        /// <param name="particleCount">Number of particles.</param>
        /// <exception cref="FluidDeviceException">The device cannot run a kernel or hold a buffer.</exception>
        public abstract IFluidStepper Start(in FluidSolverSettings settings, FluidShaderSet shaders, int particleCount);

        /// <summary>
        /// Bytes of GPU memory that a started liquid takes, by the same buffers as <see cref="Start"/> makes and the first setup of
        /// neighbours; takes none.
        /// </summary>
        /// <param name="settings">Constants that were checked and prepared.</param>
        /// <param name="particleCount">Number of particles.</param>
        /// <param name="hasBodies">Whether there are triangles in the domain.</param>
        /// <param name="sleep">When parts of it sleep; null: none do.</param>
        /// <exception cref="FluidDeviceException">The device cannot hold a buffer.</exception>
        public abstract long PlannedBytes(in FluidSolverSettings settings, int particleCount, bool hasBodies, SleepRule? sleep = null);

        /// <summary>Grows when a change to the method changes what its steps cost: older measurements then count for nothing.</summary>
        public virtual int CostRevision => 1;

        /// <summary>
        /// What a method computes besides where settings ask for it, in short, as far as it changes what a step costs; empty: nothing.
        /// </summary>
        public virtual string CostVariant(in FluidSolverSettings settings) => "";

        /// <summary>
        /// Passes over every particle's neighbours in a usual step, its search counted as one: what kept costs are of, and what a step
        /// costs against another method's where nothing is measured.
        /// </summary>
        public abstract double PassesAStep { get; }

        /// <summary>The same for a step of some length, where the number of passes follows from it.</summary>
        /// <param name="settings">The liquid's constants.</param>
        /// <param name="timeStep">Length of the step [s].</param>
        /// <param name="speed">Speed of the fastest particle [m/s].</param>
        public virtual double PassesOf(in FluidSolverSettings settings, double timeStep, double speed) => PassesAStep;

        /// <summary>
        /// Features without which a liquid would be another, by the rules of this method: physics that act at its spacing and its
        /// viscosity.
        /// </summary>
        /// <param name="input">The liquid.</param>
        /// <exception cref="ArgumentException">An input is out of range.</exception>
        public virtual FluidMethodFeatures AskedBy(in FluidRuleInput input) => FluidMethodFeatures.None;

        /// <summary>Those of <see cref="Features"/> that are forces.</summary>
        public virtual FluidMethodFeatures ForceFeatures => FluidMethodFeatures.None;

        /// <summary>Names of the passes that those forces add.</summary>
        public virtual IEnumerable<string> ForcePasses => Array.Empty<string>();

        /// <summary>
        /// The first of some features that <see cref="AskedBy"/> found and another method lacks, as the end of a sentence; null where this
        /// method knows none.
        /// </summary>
        /// <param name="missing">The features.</param>
        /// <param name="input">The liquid.</param>
        public virtual string Describe(FluidMethodFeatures missing, in FluidRuleInput input) => null;

        /// <summary>Whether Automatic may pick it; then it makes <see cref="Offers"/>.</summary>
        public virtual bool MayBePicked => false;

        /// <summary>
        /// The ways in which Automatic may compute a liquid by this method, the most faithful first; none where it never picks the method.
        /// </summary>
        /// <param name="question">The liquid and the frame.</param>
        /// <exception cref="ArgumentException">An input is out of range.</exception>
        public virtual IReadOnlyList<MethodOffer> Offers(in MethodQuestion question) => Array.Empty<MethodOffer>();

        /// <summary>Whether the method has a feature.</summary>
        public bool Has(FluidMethodFeatures feature) => (Features & feature) != 0;

        /// <summary>Checks that the method can compute with the constants.</summary>
        /// <exception cref="ArgumentException">A constant is out of range; the message names it.</exception>
        public void Check(in FluidSolverSettings settings)
        {
            settings.Validate();
            CheckForces(settings);
            CheckFaces(settings.Boundaries);
        }

        /// <summary>Checks the constants of the method's forces.</summary>
        /// <exception cref="ArgumentException">A constant is out of range; the message names it.</exception>
        protected virtual void CheckForces(in FluidSolverSettings settings)
        {
        }

        /// <summary>Checks that the method can compute with faces of the domain.</summary>
        /// <exception cref="ArgumentException">A face cannot be computed with; the message names it and the cure.</exception>
        public void CheckFaces(in FluidBoundaries faces)
        {
            faces.Validate();
            if (faces.Open != FluidFaces.None && !Has(FluidMethodFeatures.OpenFaces))
            {
                throw new ArgumentException($"Boundaries.Open has {faces.Open}, but with the method {Kind} all faces are walls. " +
                    $"Use the method {FluidMethodKind.Standard} or {FluidMethodKind.Robust}, or set Boundaries.Open to None.");
            }
        }
    }
}
