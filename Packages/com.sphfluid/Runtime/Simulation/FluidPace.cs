using System;

namespace SphFluid
{
    /// <summary>How long the steps of a running simulation are and how many a frame takes.</summary>
    internal sealed class FluidPace
    {
        // The measured speed is a few frames old; liquid that hits something is faster by now.
        const double SpeedMargin = 1.25;

        // Of the step by rule: at a million times the speed of sound there is no liquid left to compute.
        const double ShortestStep = 1e-6;

        readonly FluidSolver solver;
        readonly SpeedReadback speeds;
        AdaptiveClock adaptive;
        double stepFraction;

        /// <summary>The pace of a solver with its first settings.</summary>
        public FluidPace(in FluidSpec spec, FluidSolver solver)
        {
            this.solver = solver;
            speeds = new SpeedReadback(solver);
            Update(spec);
        }

        /// <summary>The clock in use.</summary>
        public IStepClock Clock { get; private set; }

        /// <summary>Takes over changed settings. A clock that still fits goes on with the rest it holds.</summary>
        public void Update(in FluidSpec spec)
        {
            stepFraction = spec.Profile.Rules.TimeStepFraction;
            double step = solver.Settings.TimeStep;
            int most = spec.MaxSubstepsPerFrame;
            if (spec.TimeStepMode != FluidTimeStepMode.Adaptive)
            {
                adaptive = null;
                if (!(Clock is StepClock clock) || clock.TimeStep != step || clock.MaxSteps != most) Clock = new StepClock(step, most);
                return;
            }
            if (adaptive == null || adaptive.MaxSteps != most) Clock = adaptive = new AdaptiveClock(LongestStep(), most);
        }

        /// <summary>Steps to take for a frame's time [s].</summary>
        public int Advance(double deltaTime)
        {
            solver.FlowSpeed = (float)(SpeedMargin * speeds.Speed);
            if (adaptive != null) adaptive.StableStep = LongestStep();
            return Clock.Advance(deltaTime);
        }

        /// <summary>To be called when the steps of a frame have been given to the GPU.</summary>
        public void Stepped() => speeds.Request();

        double LongestStep()
        {
            FluidSolverSettings settings = solver.Settings;
            double step = FluidRules.Advise(settings, SpeedMargin * speeds.Speed).Step(stepFraction);
            return Math.Max(step, ShortestStep * settings.TimeStep);
        }
    }
}
