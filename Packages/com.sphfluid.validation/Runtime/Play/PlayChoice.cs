using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>What the method Automatic has picked, as summary.json has it.</summary>
    internal static class PlayChoice
    {
        /// <summary>The pick, its reason and what else was considered.</summary>
        public static JsonObject Of(FluidMethodChoice choice)
        {
            var considered = new List<JsonObject>();
            foreach (FluidMethodCandidate candidate in choice.Considered) considered.Add(Of(candidate));
            return new JsonObject()
                .Add("reason", choice.Reason)
                .Add("fits_budget", choice.FitsBudget ? 1 : 0)
                .Add("budget_ms", choice.FrameBudget)
                .Add("frame_rate", choice.FrameRate)
                .Add("particles", choice.Particles)
                .Add("proposed_spacing_m", choice.ProposedSpacing)
                .Append(Of(choice.Pick))
                .Add("considered", considered);
        }

        /// <summary>A method's name, as flags have it.</summary>
        public static string NameOf(FluidMethodKind method) => $"{method}".ToLowerInvariant();

        private static JsonObject Of(in FluidMethodCandidate candidate) => new JsonObject()
            .Add("method", NameOf(candidate.Method))
            .Add("max_compression", candidate.MaxCompression)
            .Add("sound_speed_m_s", candidate.SoundSpeed)
            .Add("steps_a_frame", candidate.StepsAFrame)
            .Add("ms_a_step", candidate.MillisecondsAStep)
            .Add("ms_a_frame", candidate.MillisecondsAFrame)
            .Add("cost_source", $"{candidate.CostSource}")
            .Add("obstacle", candidate.Obstacle);
    }
}
