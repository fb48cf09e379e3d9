using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// How a running simulation spends its steps: how long they are, how many a frame takes, and whether the liquid rests and needs none.
    /// </summary>
    internal sealed class FluidPace : IDisposable
    {
        // The measured speed is a few frames old; liquid that hits something is faster by now.
        private const double SpeedMargin = 1.25;

        // s: the margin holds for frames so long. In a longer one the liquid falls on unseen.
        private const double SeenFrame = 0.06;

        // s: no frame of half of it or more is without a step, however soft the liquid.
        private const double MostStep = 1.0 / 30.0;

        // No liquid is measured to be without pressure altogether.
        private const double LeastCompression = 1e-4;

        // s: an open domain has no lowest place that liquid surely reaches. Its speed counts as it is and with what it gains by falling for
        // so long, twice as long as the speed of sound takes to follow.
        private const double FallAhead = 0.25;

        // Of the step by rule: at a million times the speed of sound there is no liquid left to compute.
        private const double ShortestStep = 1e-6;

        private readonly FluidSolver solver;
        private readonly FluidStart start;
        private readonly Func<int> keepPlaces;
        private readonly Action forgetPlaces;
        private readonly Func<double, double> stepAt; // by the speed that the constants are made for
        private readonly StepDetail detail = new StepDetail();
        private FluidSpec spec; // its rules coarser by the level of detail
        private SpeedReadback speeds;
        private AdaptiveClock adaptive;
        private SpeedReference reference;
        private SleepWatch sleep;
        private bool yields;
        private double gainInFrame;
        private double asked = double.NaN, coarsest = 1.0; // of the level of detail, and what its steps reach

        /// <summary>The pace of a solver with its first settings.</summary>
        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public FluidPace(in FluidSpec spec, FluidStart start, FluidSolver solver)
        {
            this.solver = solver;
            this.start = start;
            keepPlaces = () => speeds.KeepPlaces();
            forgetPlaces = () => speeds.ForgetPlaces();
            stepAt = speed => LongestStep(FluidConstants.Derive(this.spec, this.start, this.start.Gravity, speed), gainInFrame);
            // No pressure has built up yet.
            if (spec.StartRelaxation == FluidStartRelaxation.None) detail.Factor = StepDetail.Reached(spec, start, spec.Detail.StepFactor);
            TakeLimits(detail.AppliedTo(spec), solver.Settings);
            if (reference != null && spec.IsOpen)
            {
                reference.Begin(FluidConstants.FastestSource(spec, start.InitialSpeed) + FallAhead * spec.Gravity.magnitude);
                solver.ApplySettings(AtReference());
            }
            else if (detail.Factor != 1.0) solver.ApplySettings(Constants());
            TakeClock();
        }

        /// <summary>The clock in use.</summary>
        public IStepClock Clock { get; private set; }

        /// <summary>Whether the liquid rests and takes no steps.</summary>
        public bool IsAsleep => sleep != null && sleep.IsAsleep;

        /// <summary>Part of the particles that stood still some frames ago, 0 to 1; 0 where it is not measured.</summary>
        public float StillShare => speeds?.StillShare ?? 0f;

        /// <summary>The speed that colliders now ask the constants to be made for [m/s].</summary>
        public double Driven { get; private set; }

        /// <summary>Whether the constants follow that.</summary>
        public bool FollowsColliders => reference != null && !yields;

        /// <summary>Mean compression of the particles some frames ago; NaN where it is not measured.</summary>
        public double Compression => speeds?.Sample.Compression ?? double.NaN;

        /// <summary>That of liquid at rest that is as deep as the profile's Max Compression is for.</summary>
        public double PressedByRule => 0.5 * spec.Profile.Rules.MaxCompression;

        /// <summary>Bytes of GPU memory.</summary>
        public long GpuBytes => speeds?.GpuBytes ?? 0;

        /// <summary>Bytes of GPU memory that it takes at the start.</summary>
        public static long PlannedBytes(in FluidSpec spec) => MeasuresSpeeds(spec) ? SpeedReadback.PlannedBytes : 0L;

        /// <summary>
        /// Takes over changed settings and gives the solver its constants. A clock that still fits goes on with the rest it holds.
        /// </summary>
        /// <exception cref="ArgumentException">A constant is out of range.</exception>
        public void Update(in FluidSpec given)
        {
            asked = double.NaN;
            FluidSpec now = detail.AppliedTo(given);
            FluidSolverSettings rule = FluidConstants.Derive(now, start, start.Gravity);
            yields = false;
            TakeLimits(now, rule);
            solver.ApplySettings(reference == null ? rule : AtReference());
            TakeClock();
        }

        /// <summary>How many times longer steps are than as set up, by the level of detail.</summary>
        public double Coarseness => detail.Factor;

        /// <summary>Goes towards the level of detail by a frame; nothing wakes.</summary>
        /// <param name="given">The simulation as it is now.</param>
        /// <param name="time">Length of the frame [s].</param>
        public void Follow(in FluidSpec given, double time)
        {
            double wanted = given.Detail.StepFactor;
            if (wanted != asked) (asked, coarsest) = (wanted, StepDetail.Reached(given, start, wanted));
            if (yields || (coarsest == 1.0 && detail.Factor == 1.0)) return;
            if (detail.Update(coarsest, time)) TakeDetail(given);
            (Clock as FrameClock)?.Soften(detail.Factor * time / given.Profile.Rules.Substeps);
        }

        /// <summary>Takes over what a save had for <see cref="Coarseness"/>.</summary>
        public void Continue(in FluidSpec given, double coarseness)
        {
            detail.Factor = coarseness;
            TakeDetail(given);
        }

        /// <summary>Something touched the liquid: it takes steps again.</summary>
        public void Wake()
        {
            sleep?.Wake();
            speeds?.ForgetPlaces();
        }

        /// <summary>The liquid was put elsewhere: what was measured before does not count.</summary>
        public void Restart()
        {
            Wake();
            float speed = (float)(reference?.Most ?? solver.Settings.MaxSpeed);
            speeds?.Restart(speed, speed);
            reference?.Restart();
            if (reference != null && !yields) solver.ApplySettings(AtReference());
        }

        /// <summary>A script gave the solver settings of its own: they stay until a setting of the simulation changes.</summary>
        public void Yield() => yields = true;

        /// <summary>Steps to take for a frame.</summary>
        /// <param name="deltaTime">Its time [s].</param>
        /// <param name="bodyMotion">How far the fastest collider goes in it [m], or the liquid of an emitter.</param>
        /// <param name="loads">How the colliders drive the liquid.</param>
        public int Advance(double deltaTime, double bodyMotion, ColliderLoads loads)
        {
            if (deltaTime > 0.0) UpdateSpeed(deltaTime, bodyMotion / deltaTime, loads);
            Prepare(deltaTime, bodyMotion);
            int steps = Clock.Advance(deltaTime);
            solver.LongestStep = (float)((Clock as FrameClock)?.LongestOfLate ?? 0.0);
            return steps;
        }

        /// <summary>Takes one step, whatever the time.</summary>
        /// <param name="bodyMotion">How far the fastest collider goes in it [m].</param>
        /// <returns>One.</returns>
        public int StepOnce(double bodyMotion)
        {
            Prepare(Clock.TimeStep, bodyMotion);
            Clock.StepOnce();
            return 1;
        }

        // The speed that the liquid has or will have.
        private double Head => spec.IsOpen && !spec.BodyForce.IsOn
            ? Math.Min(speeds.Sample.Head, speeds.Sample.Bulk + FallAhead * solver.Settings.Gravity.magnitude) : speeds.Sample.Head;

        // And what holds deep liquid as stiff as it is to be, where no fall to the domain's floor does: compression goes with 1/c².
        private double Pressed => spec.IsOpen && Compression > PressedByRule
            ? reference.Speed * Math.Sqrt(Compression / PressedByRule) : 0.0;

        private void Prepare(double deltaTime, double bodyMotion)
        {
            double gain = Gain(deltaTime);
            if (speeds != null)
            {
                // By now what falls or is pressed may be as fast as its head.
                double head = Math.Min(Head, reference?.Most ?? solver.Settings.MaxSpeed);
                solver.FlowSpeed = (float)(SpeedMargin * Math.Max(speeds.Sample.Bulk, head));
                solver.PeakSpeed = (float)Math.Max(SpeedMargin * speeds.Sample.Fastest + gain,
                    deltaTime > 0.0 ? bodyMotion / deltaTime : 0.0);
            }
            if (adaptive != null) adaptive.StableStep = LongestStep(solver.Settings, gain);
        }

        // m/s: of liquid that falls through a long frame.
        private double Gain(double deltaTime) => solver.Settings.Gravity.magnitude * Math.Max(0.0, deltaTime - SeenFrame);

        // A collider that moves is known before it hits.
        private void UpdateSpeed(double deltaTime, double bodySpeed, ColliderLoads loads)
        {
            double head = Math.Min(speeds == null ? double.PositiveInfinity : Math.Max(Head, bodySpeed),
                reference?.Most ?? solver.Settings.MaxSpeed);
            FluidRuleInput rules = spec.Profile.Rules;
            double load = loads.Load * rules.Stiffness / rules.SoundSpeedRatio;
            double loaded = load > 0.0 ? Math.Sqrt(head * head + load * load) : 0.0;
            Driven = Math.Min(Math.Max(loads.Speed, loaded), FluidSpec.MostSpeed);
            if (reference == null || yields) return;
            double leap = Math.Sqrt(PressedByRule / Math.Max(Compression, LeastCompression));
            double asked = Follows(spec) ? Math.Max(Math.Max(Head, Pressed), bodySpeed) : reference.Most;
            gainInFrame = Gain(deltaTime);
            double spare = SpareSpeed.For(deltaTime, asked, reference.Most, spec.MaxSubstepsPerFrame, stepAt);
            if (reference.Update(asked, deltaTime, Driven, Math.Min(loaded, Driven), leap, spare)) solver.ApplySettings(AtReference());
        }

        /// <summary>Records what the next frames go by, after a frame's steps and the neighbour setup.</summary>
        public void Record(CommandBuffer cmd) => speeds?.Record(cmd);

        /// <summary>To be called when the steps of a frame have been given to the GPU.</summary>
        /// <param name="time">Their time [s].</param>
        public void Stepped(double time)
        {
            if (speeds == null) return;
            if (sleep != null) sleep.AddSample(speeds.Sample, time, keepPlaces, forgetPlaces);
            speeds.Request(HeadAtRest());
        }

        /// <summary>Writes what the next frames go by, once no read-back is under way.</summary>
        public void Save(SaveWriter writer)
        {
            writer.Write((Clock as StepClock)?.Pending ?? 0.0);
            (double target, double pending, double step) = adaptive?.Progress ??
                ((Clock as FrameClock)?.LongestOfLate ?? 0.0, 0.0, (Clock as FrameClock)?.TimeStep ?? 0.0);
            writer.Write(target);
            writer.Write(pending);
            writer.Write(step);
            (double speed, bool falls) = reference?.Progress ?? (double.PositiveInfinity, false);
            writer.Write(speed);
            writer.Write(falls);
            (double quiet, bool watches, bool sleeps) = sleep?.Progress ?? default;
            writer.Write(quiet);
            writer.Write(watches);
            writer.Write(sleeps);
            writer.Write(speeds != null);
            speeds?.Save(writer);
        }

        /// <summary>Goes on from a save, as far as the settings are such that it was needed then.</summary>
        public void Load(SaveReader reader)
        {
            double rest = reader.Read<double>();
            (double target, double pending, double step) = (reader.Read<double>(), reader.Read<double>(), reader.Read<double>());
            (double speed, bool falls) = (reader.Read<double>(), reader.Read<bool>());
            (double quiet, bool watches, bool sleeps) = (reader.Read<double>(), reader.Read<bool>(), reader.Read<bool>());
            if (reader.Read<bool>()) speeds?.Load(reader);
            if (reference != null) reference.Progress = (speed, falls);
            if (reference != null && !yields) solver.ApplySettings(AtReference());
            TakeClock();
            if (Clock is StepClock clock) clock.Pending = rest;
            if (Clock is FrameClock frames && step > 0.0) (frames.TimeStep, frames.LongestOfLate) = (step, target);
            if (adaptive != null && step > 0.0) adaptive.Progress = (target, pending, step);
            if (speeds != null) sleep?.Continue((quiet, watches, sleeps), keepPlaces);
        }

        /// <inheritdoc/>
        public void Dispose() => speeds?.Dispose();

        private static bool MeasuresSpeeds(in FluidSpec spec) => Follows(spec) || spec.TimeStepMode == FluidTimeStepMode.Adaptive ||
            spec.SleepsAtRest ||
            FluidMethods.Has(spec.Method, FluidMethodFeatures.KeptNeighbours | FluidMethodFeatures.StepsByFrame);

        // Such a method's steps follow the frame in either mode.
        private static bool StepsByFrame(in FluidSpec spec) => spec.TimeStepMode != FluidTimeStepMode.Fixed &&
            FluidMethods.Has(spec.Method, FluidMethodFeatures.StepsByFrame);

        private bool IsAdaptive => !StepsByFrame(spec) && (reference != null || spec.TimeStepMode == FluidTimeStepMode.Adaptive);

        private void TakeLimits(in FluidSpec now, in FluidSolverSettings rule)
        {
            spec = now;
            TakeReference(Hears(now), rule);
            TakeSleep(now, rule);
            if (MeasuresSpeeds(now)) speeds ??= new SpeedReadback(solver, now.Profile.Shaders, FirstSpeed());
            else DropSpeeds();
        }

        // When liquid rests does not depend on it.
        private void TakeDetail(in FluidSpec given)
        {
            spec = detail.AppliedTo(given);
            solver.ApplySettings(Constants());
            TakeClock();
        }

        private void TakeClock()
        {
            double step = solver.Settings.TimeStep;
            int most = spec.MaxSubstepsPerFrame;
            if (StepsByFrame(spec))
            {
                adaptive = null;
                IStepClock made = FluidMethods.Get(spec.Method).MakeClock(solver.Settings, most);
                var frames = Clock as FrameClock;
                if (frames != null && frames.IsLike(made as FrameClock)) return;
                if (frames != null) ((FrameClock)made).LongestOfLate = frames.LongestOfLate;
                Clock = made;
            }
            else if (!IsAdaptive)
            {
                adaptive = null;
                var clock = Clock as StepClock;
                if (clock != null && clock.TimeStep == step && clock.MaxSteps == most) return;
                Clock = new StepClock(step, most) { Pending = clock?.Pending ?? 0.0 };
            }
            else if (adaptive == null || adaptive.MaxSteps != most)
            {
                Clock = adaptive = new AdaptiveClock(LongestStep(solver.Settings, 0.0), most);
            }
        }

        private void TakeReference(bool follows, in FluidSolverSettings rule)
        {
            if (!follows) reference = null;
            else if (reference == null) reference = new SpeedReference(rule.MaxSpeed);
            else reference.Limit(rule.MaxSpeed);
        }

        private void TakeSleep(in FluidSpec now, in FluidSolverSettings rule)
        {
            // The longest wave of an open domain is one of deep liquid.
            double depth = now.IsOpen ? double.PositiveInfinity : FluidConstants.DepthAtRest(now, start, start.Gravity);
            if (!now.SleepsAtRest) sleep = null;
            else if (sleep == null) sleep = new SleepWatch(rule, depth);
            else sleep.Configure(rule, depth);
            solver.State.SetSleep(SleepingParts.RuleFor(now, rule));
        }

        private void DropSpeeds()
        {
            speeds?.Dispose();
            speeds = null;
        }

        private static bool Follows(in FluidSpec spec) => spec.Profile.SoundSpeedMode == FluidSoundSpeedMode.FollowsLiquid &&
            spec.TimeStepMode != FluidTimeStepMode.Fixed && FluidMethods.Has(spec.Method, FluidMethodFeatures.FollowingSoundSpeed);

        // Without a speed that follows the liquid only colliders raise the constants.
        private static bool Hears(in FluidSpec spec) => Follows(spec) || StepsByFrame(spec);

        private FluidSolverSettings Constants() => reference == null ? FluidConstants.Derive(spec, start, start.Gravity) : AtReference();

        private FluidSolverSettings AtReference() => Follows(spec)
            ? FluidConstants.Derive(spec, start, start.Gravity, reference.Speed)
            : FluidConstants.Derive(spec, start, start.Gravity, double.NaN,
                Math.Sqrt(Math.Max(0.0, reference.Speed * reference.Speed - reference.Most * reference.Most)));

        // Of a particle's share in the square of the head √(2 g D) at the surface of liquid at rest, what its speed of sound does not need:
        // √(g D/η) over the Sound Speed Ratio is enough there.
        private double HeadAtRest()
        {
            FluidRuleInput rules = spec.Profile.Rules;
            Vector3 gravity = solver.Settings.Gravity;
            double needed = 1.0 / (rules.MaxCompression * rules.SoundSpeedRatio * rules.SoundSpeedRatio);
            return Math.Max(0.0, 2.0 - needed) * gravity.magnitude *
                LiquidPotential.DepthAtRest(spec.DomainSize, spec.Spacing, gravity, 1);
        }

        // Liquid that starts at rest takes long steps until it falls.
        private float FirstSpeed() =>
            spec.TimeStepMode == FluidTimeStepMode.Automatic && solver.StepCount == 0 ? start.InitialSpeed : solver.Settings.MaxSpeed;

        // Faster particles than the constants are made for shorten the steps where the mode asks for it.
        private double LongestStep(in FluidSolverSettings settings, double gain)
        {
            double speed = SpeedMargin * speeds.Sample.Fastest + gain;
            if (spec.TimeStepMode != FluidTimeStepMode.Adaptive) speed = Math.Min(speed, settings.MaxSpeed);
            double step = FluidRules.Advise(settings, speed).Step(spec.Profile.Rules.TimeStepFraction);
            return Math.Max(Math.Min(step, MostStep), ShortestStep * settings.TimeStep);
        }
    }
}
