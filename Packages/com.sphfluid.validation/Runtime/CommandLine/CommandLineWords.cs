using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>What the verbs' flags share.</summary>
    internal static class CommandLineWords
    {
        /// <summary>Index of the lone <c>--</c> that ends the playing program's own flags, or −1.</summary>
        public static int Separator(IReadOnlyList<string> commandLine)
        {
            for (int i = 0; i < commandLine.Count; i++)
            {
                if (commandLine[i] == "--") return i;
            }
            return -1;
        }

        /// <summary>The word behind a flag; the index moves on to it.</summary>
        /// <exception cref="CommandLineException">There is none, or it is another flag.</exception>
        public static string Value(IReadOnlyList<string> commandLine, ref int index)
        {
            string flag = commandLine[index];
            if (index + 1 >= commandLine.Count || commandLine[index + 1].StartsWith("--", StringComparison.Ordinal))
            {
                throw new CommandLineException($"{flag} needs a value.");
            }
            return commandLine[++index];
        }

        /// <summary>The words behind a flag up to the next flag, each divided at its commas; the index moves on to the last one.</summary>
        /// <exception cref="CommandLineException">There is none, or one is empty.</exception>
        public static IReadOnlyList<string> Values(IReadOnlyList<string> commandLine, ref int index)
        {
            string flag = commandLine[index];
            var values = new List<string>(List(flag, Value(commandLine, ref index)));
            while (index + 1 < commandLine.Count && !commandLine[index + 1].StartsWith("-", StringComparison.Ordinal))
            {
                values.AddRange(List(flag, commandLine[++index]));
            }
            return values;
        }

        /// <summary>A value divided at its commas.</summary>
        /// <exception cref="CommandLineException">A part is empty.</exception>
        public static IReadOnlyList<string> List(string flag, string value)
        {
            string[] words = value.Split(',');
            for (int i = 0; i < words.Length; i++)
            {
                words[i] = words[i].Trim();
                if (words[i].Length == 0) throw new CommandLineException($"{flag} has an empty name in '{Shown(value)}'.");
            }
            return words;
        }

        /// <exception cref="CommandLineException">The value is not among those allowed.</exception>
        public static void RequireOneOf(string flag, string value, string[] allowed)
        {
            if (Array.IndexOf(allowed, value) < 0)
            {
                throw new CommandLineException(
                    $"{flag} must be one of {string.Join(", ", allowed)}, found '{Shown(value)}'{NearestWord.Question(value, allowed)}");
            }
        }

        /// <summary>Adds what has a name to what is chosen.</summary>
        /// <exception cref="CommandLineException">There is none of the name, or it is chosen already.</exception>
        public static void Choose<T>(List<T> chosen, string flag, string name, IReadOnlyList<T> known, Func<T, string> nameOf)
        {
            RequireOneOf(flag, name, known.Select(nameOf).ToArray());
            T found = known.First(item => nameOf(item) == name);
            if (chosen.Contains(found)) throw new CommandLineException($"{flag} has {name} twice.");
            chosen.Add(found);
        }

        /// <summary>A whole number in a range.</summary>
        /// <exception cref="CommandLineException">It is none.</exception>
        public static int Integer(string flag, string value, int least, int most)
        {
            if (int.TryParse(value, NumberStyles.AllowLeadingSign, CultureInfo.InvariantCulture, out int number) && number >= least &&
                number <= most)
            {
                return number;
            }
            throw new CommandLineException($"{flag} must be a whole number from {least} to {most}, found '{Shown(value)}'.");
        }

        /// <summary>A number above zero, at most 1e9.</summary>
        /// <exception cref="CommandLineException">It is none.</exception>
        public static double Positive(string flag, string value)
        {
            if (TryNumber(value, out double number)) return number;
            throw new CommandLineException($"{flag} must be a number above zero and at most 1000000000, found '{Shown(value)}'.");
        }

        /// <summary>A part of one: "5%" and "0.05" are the same.</summary>
        /// <exception cref="CommandLineException">It is none.</exception>
        public static double Share(string flag, string value)
        {
            bool percent = value.EndsWith("%", StringComparison.Ordinal);
            if (TryNumber((percent ? value.Substring(0, value.Length - 1) : value).Trim(), out double number))
            {
                return percent ? 0.01 * number : number;
            }
            throw new CommandLineException($"{flag} must be a part above zero, such as 5% or 0.05, found '{Shown(value)}'.");
        }

        private static bool TryNumber(string value, out double number) =>
            double.TryParse(value, NumberStyles.AllowDecimalPoint | NumberStyles.AllowExponent, CultureInfo.InvariantCulture, out number) &&
                number > 0.0 && number <= 1e9;

        /// <summary>A number of milliseconds above zero.</summary>
        /// <exception cref="CommandLineException">It is none.</exception>
        public static double Milliseconds(string flag, string value)
        {
            if (!double.TryParse(value, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double milliseconds) ||
                !(milliseconds >= 1e-3) || milliseconds > 1e6)
            {
                throw new CommandLineException($"{flag} must be a number of milliseconds from 0.001 to 1000000, found '{Shown(value)}'.");
            }
            return milliseconds;
        }

        /// <summary>A number of minutes above zero.</summary>
        /// <exception cref="CommandLineException">It is none.</exception>
        public static TimeSpan Minutes(string flag, string value)
        {
            if (!double.TryParse(value, NumberStyles.AllowDecimalPoint, CultureInfo.InvariantCulture, out double minutes) ||
                !(minutes >= 1e-6) || minutes > 1e6)
            {
                throw new CommandLineException(
                    $"{flag} must be a number of minutes above zero and at most 1000000, found '{Shown(value)}'.");
            }
            return TimeSpan.FromMinutes(minutes);
        }

        /// <summary>A word as a message may show it: on one line, not longer than is read.</summary>
        public static string Shown(string word)
        {
            const int Longest = 240; // of most paths the end is what tells
            string line = new string(word.Select(c => char.IsControl(c) ? ' ' : c).ToArray());
            return line.Length <= Longest ? line : line.Substring(0, Longest) + "...";
        }
    }
}
