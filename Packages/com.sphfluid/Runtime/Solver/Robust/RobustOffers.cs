using System;

namespace SphFluid
{
    /// <summary>
    /// The Robust method as Automatic may pick it: with as many substeps as the budget of a frame holds, no fewer than the profile's.
    /// Worked example: at 0.5 ms a substep and 4 at least, a budget of 1 ms gives 4, one of 3.2 ms gives 6.
    /// </summary>
    internal static class RobustOffers
    {
        /// <summary>Most substeps that are picked: with more, Standard's steps are as few.</summary>
        public const int MostSubsteps = 16;

        /// <summary>
        /// Speed of sound over √(g D) at which settled liquid is compressed by a ninth at its bottom; below, it sinks in visibly.
        /// </summary>
        public const double StiffEnough = 3.0;

        // A frame of exactly n steps takes n, however its sum of floats was rounded.
        private const double RoundingSlack = 1e-6;

        public static MethodOffer For(FluidMethod method, in MethodQuestion question)
        {
            int least = question.Input.Substeps;
            MethodOffer best = Offer(method, question, least);
            if (question.Input.FixedTimeStep > 0f || !(question.Affordable > 0.0)) return best;
            for (int substeps = least + 1; substeps <= MostSubsteps; substeps++)
            {
                MethodOffer offer = Offer(method, question, substeps);
                if (offer.StepsAFrame * offer.CostRatio <= question.Affordable) best = offer;
            }
            return best;
        }

        private static MethodOffer Offer(FluidMethod method, in MethodQuestion question, int substeps)
        {
            FluidRuleInput input = question.Input;
            (input.Method, input.Substeps) = (method.Kind, substeps);
            FluidSolverSettings settings = RobustRules.Derive(input);
            bool isFixed = input.FixedTimeStep > 0f;
            int steps = isFixed ? (int)Math.Max(1.0, Math.Ceiling(question.FrameTime / input.FixedTimeStep - RoundingSlack))
                : FrameClock.StepsOf(question.FrameTime, substeps, RobustRules.LongestFrame / substeps);
            double step = isFixed ? input.FixedTimeStep : question.FrameTime / steps;
            return new MethodOffer
            {
                Method = method.Kind,
                MaxCompression = input.MaxCompression,
                SoundSpeedRatio = input.SoundSpeedRatio,
                Substeps = isFixed ? 0 : substeps,
                CostRatio = method.PassesOf(settings, step, settings.MaxSpeed) / method.PassesAStep,
                StepsAFrame = steps,
                SoundSpeed = method.EffectiveSoundSpeed(settings, step, settings.MaxSpeed),
                LeastSoundSpeed = StiffEnough * settings.Own<RobustSettings>().DepthSpeed,
                AsTheProfileAsks = true,
            };
        }
    }
}
