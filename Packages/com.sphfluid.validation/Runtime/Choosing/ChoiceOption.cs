using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>A way to compute the liquid in question, with its expected error and cost.</summary>
    public sealed class ChoiceOption
    {
        internal ChoiceOption(ChoiceCurve curve, int resolution, ChoiceScale scale)
        {
            Curve = curve;
            Resolution = resolution;
            Spacing = scale.Length / resolution;
            Particles = scale.ParticlesOf(curve, resolution);
            StepsPerFrame = curve.StepsPerSecond(resolution) / scale.Time / scale.FramesPerSecond;
            Error = curve.Error.At(resolution);
            Milliseconds = curve.StepTime(Particles).Times(StepsPerFrame);
            IsBeyondMeasured = curve.IsBeyondMeasured(Particles);
            Beside = curve.BesideAt(resolution);
        }

        internal ChoiceCurve Curve { get; }

        /// <summary>Name of the method.</summary>
        public string Method => Curve.First.Method;

        /// <summary>κ = R/dx.</summary>
        public double SupportRatio => Curve.First.SupportRatio;

        /// <summary>Speed of sound over the fastest speed.</summary>
        public double SoundSpeedRatio => Curve.First.SoundSpeedRatio;

        /// <summary>Compression by motion, (v/c)², with the speed of sound that the liquid has in its steps.</summary>
        public double Compression => Curve.Compression;

        /// <summary>Particles along the liquid's length.</summary>
        public int Resolution { get; }

        /// <summary>Particle spacing dx [m].</summary>
        public double Spacing { get; }

        /// <summary>Number of particles.</summary>
        public double Particles { get; }

        /// <summary>Steps of a frame.</summary>
        public double StepsPerFrame { get; }

        /// <summary>The case's error.</summary>
        public Estimate Error { get; }

        /// <summary>GPU time of a frame [ms].</summary>
        public Estimate Milliseconds { get; }

        /// <summary>Whether the device was timed with less than half as many particles: the cost is an extrapolation.</summary>
        public bool IsBeyondMeasured { get; }

        /// <summary>
        /// How far each of the case's <see cref="ValidationCase.AlsoHeld"/> is from what is right, in their order; not a number where
        /// one was not measured.
        /// </summary>
        public IReadOnlyList<double> Beside { get; }

        /// <summary>Whether what is also held errs by no more than this.</summary>
        internal bool Holds(double error) => Beside.All(off => off <= error);

        /// <summary>The constants, for instance "standard, κ 2.25, dx 0.05 m, compression 4 %".</summary>
        public override string ToString() => string.Format(CultureInfo.InvariantCulture, "{0}, κ {1:G4}, dx {2:G3} m, compression {3:G2} %",
            Method, SupportRatio, Spacing, 100.0 * Compression);

        /// <summary>The case with these constants.</summary>
        internal ChartConfig ConfigOf(ValidationCase validationCase)
        {
            CaseParameters parameters = validationCase.Base(CaseMethod.Find(Method));
            (parameters.Resolution, parameters.SupportRatio, parameters.SoundSpeedRatio) = (Resolution, SupportRatio, SoundSpeedRatio);
            return new ChartConfig(validationCase, parameters, ChartFactor.Several);
        }
    }
}
