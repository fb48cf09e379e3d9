using System.Collections.Generic;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>Letters and words of the causes in tables and pictures: upper case for failed, lower case for degraded.</summary>
    public static class StabilityCauses
    {
        static readonly (StabilityCause Cause, string Letter, string Name, string Title)[] entries =
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
        public static IEnumerable<StabilityCause> All => entries.Skip(1).Select(e => e.Cause);

        /// <summary>One letter for a cell of a picture; empty for none.</summary>
        public static string Letter(StabilityCause cause) => Entry(cause).Letter;

        /// <summary>Word in tables; empty for none.</summary>
        public static string Name(StabilityCause cause) => Entry(cause).Name;

        /// <summary>Words in legends.</summary>
        public static string Title(StabilityCause cause) => Entry(cause).Title;

        /// <summary>The cause of a word in a table.</summary>
        /// <exception cref="System.FormatException">There is none.</exception>
        public static StabilityCause Find(string name)
        {
            foreach (var entry in entries)
            {
                if (entry.Name == name)
                    return entry.Cause;
            }
            throw new System.FormatException($"there is no cause '{name}'");
        }

        static (StabilityCause Cause, string Letter, string Name, string Title) Entry(StabilityCause cause) => entries.First(e => e.Cause == cause);
    }
}
