using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Says why parts of a liquid that are to sleep do not.</summary>
    internal static class SleepChecks
    {
        private const FluidMethodFeatures None = FluidMethodFeatures.None;

        /// <summary>Checks a simulation.</summary>
        /// <param name="spec">The simulation.</param>
        /// <param name="start">How it starts.</param>
        /// <param name="messages">Receives what keeps all of it awake.</param>
        public static void Check(in FluidSpec spec, FluidStart start, List<FluidMessage> messages)
        {
            if (!spec.PartsSleep) return;
            if (!spec.SleepsAtRest)
            {
                Add(spec, messages, "Parts Sleep does nothing while Sleeps At Rest is off.", "Switch Sleeps At Rest on");
                return;
            }
            FluidMethod method = FluidMethods.Get(spec.Method);
            if (!method.Has(FluidMethodFeatures.SleepingParts))
            {
                Add(spec, messages, $"With the method {spec.Method} all of the liquid takes part in each step: Parts Sleep does nothing.",
                    "Use the method Standard");
                return;
            }
            FluidRuleInput input = FluidConstants.Input(spec, start, start.Gravity);
            FluidMethodFeatures forces = method.AskedBy(input);
            if (forces == None) return;
            Add(spec, messages, $"Parts Sleep does nothing with {method.Describe(forces, input)}: all of it takes part in each step.",
                "Use a liquid without it");
        }

        private static void Add(in FluidSpec spec, List<FluidMessage> messages, string text, string cure) =>
            messages.Add(new FluidMessage(FluidSeverity.Info, FluidIssue.PartsStayAwake, spec.Owner, text,
                cure + ", or switch Parts Sleep off."));
    }
}
