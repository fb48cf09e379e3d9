using System;
using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>How a run went, the worst last.</summary>
    public enum StabilityVerdict
    {
        /// <summary>Nothing is wrong.</summary>
        Stable,

        /// <summary>It did not fail, but is no good picture of the liquid.</summary>
        Degraded,

        /// <summary>It is no liquid any more.</summary>
        Failed,
    }

    /// <summary>What a criterion found in a run.</summary>
    public sealed class StabilityOutcome
    {
        /// <summary>How it went.</summary>
        public StabilityVerdict Verdict;

        /// <summary>What was wrong first.</summary>
        public StabilityCause Cause;

        /// <summary>The same with figures, and whether the run was cut short.</summary>
        public string Reason = "";

        /// <summary>When it failed [s]; not a number when it did not.</summary>
        public double TimeToFailure = double.NaN;

        /// <summary>Number of particles.</summary>
        public int Particles;

        /// <summary>Steps done.</summary>
        public long Steps;

        /// <summary>Whether the run ended before the map's length: it says less.</summary>
        public bool IsCut => Reason.Contains(StabilityScenario.CutText);
    }

    /// <summary>What was wrong with a run first.</summary>
    public enum StabilityCause
    {
        /// <summary>Nothing.</summary>
        None,

        /// <summary>Failed: a position or velocity is not a finite number.</summary>
        NotFinite,

        /// <summary>Failed: the energy grew beyond 1.05 of the start's without work.</summary>
        Energy,

        /// <summary>Failed: a particle is faster than three times the reference speed.</summary>
        Speed,

        /// <summary>Failed: more than 0.1 % of the particles are beyond a wall by half a spacing.</summary>
        Escape,

        /// <summary>Failed: the mean compression grew by more than 10 %.</summary>
        Compression,

        /// <summary>Degraded: what should be at rest moves.</summary>
        Restless,

        /// <summary>Degraded: more than 1 % of the particles have a neighbour within half a spacing.</summary>
        Clumped,

        /// <summary>Degraded: the column lost more height than its equation of state predicts, and 2 %.</summary>
        Sunk,

        /// <summary>Degraded: the emergency limit cut accelerations, or particles were put back onto a face of the domain.</summary>
        Clamped,

        /// <summary>Degraded: the momentum of a closed system drifted by more than 1e-3.</summary>
        Drift,
    }

    /// <summary>Letters and words of the causes in tables and pictures: upper case for failed, lower case for degraded.</summary>
    public static class StabilityLegend
    {
        private static readonly (StabilityCause Cause, string Letter, string Name, string Title)[] entries =
        {
            (StabilityCause.None, "", "", ""),
            (StabilityCause.NotFinite, "N", "not-finite", "not finite"),
            (StabilityCause.Energy, "E", "energy", "energy grew"),
            (StabilityCause.Speed, "V", "speed", "too fast"),
            (StabilityCause.Escape, "W", "escape", "through a wall"),
            (StabilityCause.Compression, "C", "compression", "compressed"),
            (StabilityCause.Restless, "r", "restless", "does not rest"),
            (StabilityCause.Clumped, "n", "clumped", "too near"),
            (StabilityCause.Sunk, "h", "sunk", "height lost"),
            (StabilityCause.Clamped, "l", "clamped", "clamped"),
            (StabilityCause.Drift, "m", "drift", "momentum"),
        };

        /// <summary>The causes that have a letter.</summary>
        public static IEnumerable<StabilityCause> Causes => entries.Skip(1).Select(e => e.Cause);

        /// <summary>One letter for a cell of a picture; empty for none.</summary>
        public static string Letter(StabilityCause cause) => Entry(cause).Letter;

        /// <summary>Word in tables; empty for none.</summary>
        public static string Name(StabilityCause cause) => Entry(cause).Name;

        /// <summary>Words in legends.</summary>
        public static string Title(StabilityCause cause) => Entry(cause).Title;

        /// <summary>The cause of a word in a table.</summary>
        /// <exception cref="FormatException">There is none.</exception>
        public static StabilityCause Find(string name)
        {
            int index = Array.FindIndex(entries, e => e.Name == name);
            return index >= 0 ? entries[index].Cause : throw new FormatException($"there is no cause '{name}'");
        }

        private static (StabilityCause Cause, string Letter, string Name, string Title) Entry(StabilityCause cause) =>
            entries.First(e => e.Cause == cause);
    }
}
