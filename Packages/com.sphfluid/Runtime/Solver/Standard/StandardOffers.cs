using System;
using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>
    /// The Standard method as Automatic may pick it: as the profile asks, and with three times its compression at rest and in motion, which
    /// takes √3 times fewer steps where the speed of sound sets them. Worked example: 4 % and a ratio of 5 become 12 % and 3.
    /// </summary>
    internal static class StandardOffers
    {
        private const double Softening = 3.0;

        // The bounds of a profile's fields: beyond them the liquid is visibly a sponge.
        private const double LeastRatio = 3.0;
        private const double MostCompression = 0.2;

        // A frame of exactly n steps takes n, however its sum of floats was rounded.
        private const double RoundingSlack = 1e-6;

        public static IReadOnlyList<MethodOffer> For(in MethodQuestion question)
        {
            FluidRuleInput asked = question.Input, soft = question.Input;
            soft.MaxCompression = (float)Math.Max(asked.MaxCompression, Math.Min(MostCompression, Softening * asked.MaxCompression));
            soft.SoundSpeedRatio =
                (float)Math.Min(asked.SoundSpeedRatio, Math.Max(LeastRatio, asked.SoundSpeedRatio / Math.Sqrt(Softening)));
            MethodOffer faithful = Offer(asked, question.FrameTime, true), softer = Offer(soft, question.FrameTime, false);
            return softer.StepsAFrame < faithful.StepsAFrame ? new[] { faithful, softer } : new[] { faithful };
        }

        private static MethodOffer Offer(FluidRuleInput input, double frameTime, bool asTheProfileAsks)
        {
            input.Method = FluidMethodKind.Standard;
            FluidSolverSettings settings = StandardRules.Derive(input);
            return new MethodOffer
            {
                Method = FluidMethodKind.Standard,
                MaxCompression = input.MaxCompression,
                SoundSpeedRatio = input.SoundSpeedRatio,
                CostRatio = 1.0,
                StepsAFrame = Math.Max(1.0, Math.Ceiling(frameTime / settings.TimeStep - RoundingSlack)),
                SoundSpeed = settings.SoundSpeed,
                AsTheProfileAsks = asTheProfileAsks,
            };
        }
    }
}
