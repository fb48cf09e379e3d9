using System;

namespace SphFluid.Validation
{
    /// <summary>
    /// How the liquid in question differs from its case in size. Flows of one shape are alike where their speeds over √(gL) are: a liquid
    /// four times as long moves twice as fast, and its steps at the same number of particles along it are twice as long.
    /// </summary>
    internal readonly struct ChoiceScale
    {
        private readonly double volume;

        private ChoiceScale(double length, double time, double volume, double framesPerSecond)
        {
            Length = length;
            Time = time;
            FramesPerSecond = framesPerSecond;
            this.volume = volume;
        }

        /// <summary>The liquid's length [m].</summary>
        public double Length { get; }

        /// <summary>A time of the liquid over that of the case.</summary>
        public double Time { get; }

        /// <summary>Frames a second.</summary>
        public double FramesPerSecond { get; }

        /// <summary>The scale of a question.</summary>
        public static ChoiceScale Of(ChoiceQuestion question)
        {
            var basis = new ChartConfig(question.Case, question.Case.Base(CaseMethod.Find("standard")), ChartFactor.Base);
            double own = basis.Spacing * basis.Parameters(1).Resolution;
            double length = double.IsNaN(question.Length) ? own : question.Length, size = length / own;
            double speed = !double.IsNaN(question.Speed) ? question.Speed / basis.Speed : basis.HasGravity ? Math.Sqrt(size) : 1.0;
            return new ChoiceScale(length, size / speed, question.Volume, question.FramesPerSecond);
        }

        /// <summary>Number of particles: of the volume that is asked for, else the case's.</summary>
        public double ParticlesOf(ChoiceCurve curve, double resolution)
        {
            double dx = Length / resolution;
            return double.IsNaN(volume) ? curve.ParticlesAt(resolution) : volume / (dx * dx * dx);
        }
    }
}
