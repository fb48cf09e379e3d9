using System;

namespace SphFluid
{
    /// <summary>
    /// How many times longer a running liquid's steps are than as set up. It goes to what a level asks for in many swings of a pool's
    /// compression, so that liquid at rest settles and rises with it: at once, it would be pressed or let go, and jump.
    /// </summary>
    internal sealed class StepDetail
    {
        // s, in which the factor changes by e.
        private const double Time = 2.0;

        // s: a single long frame counts for no more.
        private const double LongestFrame = 0.1;

        /// <summary>The factor in use, 1 or more.</summary>
        public double Factor { get; set; } = 1.0;

        /// <summary>Goes on by a frame.</summary>
        /// <param name="target">The factor that is asked for.</param>
        /// <param name="time">Length of the frame [s].</param>
        /// <returns>Whether it changed.</returns>
        public bool Update(double target, double time)
        {
            double before = Factor, most = Math.Exp(Math.Min(time, LongestFrame) / Time);
            Factor = Math.Min(Math.Max(target, before / most), before * most);
            return Factor != before;
        }

        /// <summary>A simulation whose rules are made for the factor in use.</summary>
        public FluidSpec AppliedTo(FluidSpec spec)
        {
            spec.Profile.Rules = FluidMethods.Get(spec.Method).Coarsen(spec.Profile.Rules, Factor);
            return spec;
        }

        /// <summary>What of the factor that its level asks for a simulation's steps can take.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="start">Where its liquid started.</param>
        /// <param name="asked">The factor, 1 or more.</param>
        public static double Reached(in FluidSpec spec, FluidStart start, double asked) =>
            asked <= 1.0 || spec.TimeStepMode == FluidTimeStepMode.Fixed || spec.Playback != null ? 1.0
                : FluidMethods.Get(spec.Method).CoarsestFactor(FluidConstants.Input(spec, start, start.Gravity), asked);
    }
}
