using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>Says why parts of a liquid that are to sleep do not.</summary>
    internal static class SleepChecks
    {
        private const FluidMethodFeatures None = FluidMethodFeatures.None;

        public static void Check(in FluidSpec spec, List<FluidMessage> messages)
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
            FluidMethodFeatures forces = method.AskedBy(spec.Profile.Rules);
            if (forces == None) return;
            Add(spec, messages, $"All of the liquid takes part in each step, as Parts Sleep does nothing with " +
                $"{method.Describe(forces, spec.Profile.Rules)}.", "Use a liquid without it");
        }

        private static void Add(in FluidSpec spec, List<FluidMessage> messages, string text, string cure) =>
            messages.Add(new FluidMessage(FluidSeverity.Info, FluidIssue.PartsStayAwake, spec.Owner, text,
                cure + ", or switch Parts Sleep off."));
    }
}
