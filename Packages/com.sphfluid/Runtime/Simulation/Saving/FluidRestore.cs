using System;
using System.IO;

namespace SphFluid
{
    /// <summary>Makes a running liquid of a save.</summary>
    internal static class FluidRestore
    {
        private const int MostNames = 3;

        /// <summary>Reads and checks a save and makes its liquid, beside the one that runs.</summary>
        /// <param name="asked">The simulation; where its method is chosen automatically, the save brings it.</param>
        /// <param name="stream">The save.</param>
        /// <param name="report">Receives what is wrong or worth knowing.</param>
        /// <returns>Null when an error was reported.</returns>
        public static FluidRun TryMake(in FluidSpec asked, Stream stream, Action<FluidMessage> report)
        {
            FluidSpec spec = asked;
            try
            {
                FluidSave save = FluidSave.Read(stream);
                if (asked.Automatic.IsOn) spec = (save.Start.Choice = save.ChoiceFor(asked)).Apply(asked.AsSet());
                if (Refusal(spec, save) is FluidMessage refusal) report(refusal);
                else
                {
                    FluidRun run = FluidStarter.TryContinue(spec, save, report);
                    if (run != null) ReportDifferences(spec, save, report);
                    return run;
                }
            }
            catch (Exception exception) when (exception is InvalidDataException || exception is IOException)
            {
                report(Refused(spec, $"The save {exception.Message}, so it was not restored.", "Restore another save."));
            }
            return null;
        }

        private static FluidMessage? Refusal(in FluidSpec spec, FluidSave save)
        {
            if (save.Identity.Difference(SaveIdentity.Create(spec), out string cure) is string difference)
            {
                return Refused(spec, difference, cure);
            }
            long most = LiquidChecks.MostParticles(spec, out string reason);
            return save.Live.Length > most
                ? Refused(spec, FormattableString.Invariant($"The save has {save.Live.Length} particles, but {reason}."),
                    "Raise Max Particles of the profile.")
                : (FluidMessage?)null;
        }

        private static void ReportDifferences(in FluidSpec spec, FluidSave save, Action<FluidMessage> report)
        {
            if (save.Device != FluidSave.PresentDevice)
            {
                report(new FluidMessage(FluidSeverity.Info, FluidIssue.SaveDiffers, spec.Owner,
                    $"The save was made on {save.Device}; here the liquid goes on from it, but not to the last bit as it would have there.",
                    ""));
            }
            if (save.Missing.Count == 0) return;
            string names = string.Join("', '", System.Linq.Enumerable.Take(save.Missing, MostNames));
            report(new FluidMessage(FluidSeverity.Warning, FluidIssue.SaveDiffers, spec.Owner,
                $"The save names '{names}'{(save.Missing.Count > MostNames ? $" and {save.Missing.Count - MostNames} more" : "")}, " +
                "which the scene does not have: the liquid goes on without.",
                "Bring the scene's objects to where they were, under the same names, before the liquid is restored."));
        }

        private static FluidMessage Refused(in FluidSpec spec, string text, string cure) =>
            new FluidMessage(FluidSeverity.Error, FluidIssue.SaveInvalid, spec.Owner, text, cure);
    }
}
