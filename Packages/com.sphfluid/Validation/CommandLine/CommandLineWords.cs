using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>What the verbs' flags share.</summary>
    static class CommandLineWords
    {
        /// <summary>Index of the lone <c>--</c> that ends the playing program's own flags, or −1.</summary>
        public static int Separator(IReadOnlyList<string> commandLine)
        {
            for (int i = 0; i < commandLine.Count; i++)
            {
                if (commandLine[i] == "--")
                    return i;
            }
            return -1;
        }

        /// <summary>The word behind a flag; the index moves on to it.</summary>
        /// <exception cref="CommandLineException">There is none, or it is another flag.</exception>
        public static string Value(IReadOnlyList<string> commandLine, ref int index)
        {
            string flag = commandLine[index];
            if (index + 1 >= commandLine.Count || commandLine[index + 1].StartsWith("--", StringComparison.Ordinal))
                throw new CommandLineException($"{flag} needs a value.");
            return commandLine[++index];
        }

        /// <exception cref="CommandLineException">The value is not among those allowed.</exception>
        public static void RequireOneOf(string flag, string value, string[] allowed)
        {
            if (Array.IndexOf(allowed, value) < 0)
                throw new CommandLineException($"{flag} must be one of {string.Join(", ", allowed)} in this version, found '{value}'.");
        }
    }
}
