using System;
using System.Collections.Generic;

namespace SphFluid.Validation
{
    /// <summary>A flag of a verb, its value behind it or after an equals sign: <c>--out DIR</c> or <c>--out=DIR</c>.</summary>
    internal sealed class CommandLineFlag
    {
        private readonly IReadOnlyList<string> commandLine;
        private readonly string given;
        private readonly HashSet<string> single; // flags of one value that have theirs
        private int index;

        private CommandLineFlag(IReadOnlyList<string> commandLine, int index, HashSet<string> single)
        {
            this.commandLine = commandLine;
            this.single = single;
            this.index = index;
            string word = commandLine[index];
            int equals = word.StartsWith("--", StringComparison.Ordinal) ? word.IndexOf('=') : -1;
            Name = equals > 0 ? word.Substring(0, equals) : word;
            given = equals > 0 ? word.Substring(equals + 1) : null;
        }

        /// <summary>The flag, for instance "--out".</summary>
        public string Name { get; }

        /// <summary>
        /// Reads the whole command line of the process: the flags behind a lone <c>--</c>; without one, flags of others are passed over.
        /// </summary>
        /// <param name="commandLine">The words.</param>
        /// <param name="verb">For messages.</param>
        /// <param name="known">The verb's flags.</param>
        /// <param name="read">Takes each of them, and its value.</param>
        /// <param name="takeWord">Takes words behind <c>--</c> that are neither flags nor their values; null where there are none.</param>
        /// <exception cref="CommandLineException">A flag behind <c>--</c> is unknown, or a value is missing or wrong.</exception>
        public static void Read(IReadOnlyList<string> commandLine, string verb, string[] known, Action<CommandLineFlag> read,
            Action<string> takeWord = null)
        {
            int separator = CommandLineWords.Separator(commandLine);
            var single = new HashSet<string>();
            for (int i = separator + 1; i < commandLine.Count; i++)
            {
                var flag = new CommandLineFlag(commandLine, i, single);
                if (Array.IndexOf(known, flag.Name) >= 0)
                    read(flag);
                else if (separator >= 0 && takeWord != null && commandLine[i].Length > 0 &&
                    !commandLine[i].StartsWith("-", StringComparison.Ordinal))
                    takeWord(commandLine[i]);
                else if (separator >= 0 && !commandLine[i].StartsWith("-", StringComparison.Ordinal))
                    throw new CommandLineException(
                        $"'{CommandLineWords.Shown(commandLine[i])}' is not understood by {verb}: flags begin with --, and a scene is " +
                        "named by --scene. " +
                        $"Its flags are {string.Join(", ", known)}.");
                else if (separator >= 0)
                    throw new CommandLineException(
                        $"{CommandLineWords.Shown(commandLine[i])} is not a flag of {verb}{NearestWord.Question(flag.Name, known)} " +
                        $"Its flags are {string.Join(", ", known)}.");
                i = flag.index;
            }
        }

        /// <summary>True, of a flag without a value.</summary>
        /// <exception cref="CommandLineException">It has one.</exception>
        public bool On() => given == null ? true : throw new CommandLineException($"{Name} takes no value.");

        /// <summary>Its value.</summary>
        /// <exception cref="CommandLineException">There is none, it is empty, or the flag had one before.</exception>
        public string Value()
        {
            if (!single.Add(Name)) throw new CommandLineException($"{Name} is given twice.");
            string value = given ?? CommandLineWords.Value(commandLine, ref index);
            return string.IsNullOrWhiteSpace(value) ? throw new CommandLineException($"{Name} must not be empty.") : value;
        }

        /// <summary>Its value, a whole number.</summary>
        /// <exception cref="CommandLineException">It is none, or outside of the range.</exception>
        public int Integer(int least, int most) => CommandLineWords.Integer(Name, Value(), least, most);

        /// <summary>Its value, a number of milliseconds above zero.</summary>
        /// <exception cref="CommandLineException">It is none.</exception>
        public double Milliseconds() => CommandLineWords.Milliseconds(Name, Value());

        /// <summary>Its value, one of some words.</summary>
        /// <exception cref="CommandLineException">It is another one.</exception>
        public string OneOf(string[] allowed)
        {
            string value = Value();
            CommandLineWords.RequireOneOf(Name, value, allowed);
            return value;
        }

        /// <summary>Its value, a folder that is there or can be made.</summary>
        /// <exception cref="CommandLineException">A file stands in its place.</exception>
        public string Folder() => OutputPath.Folder(Name, Value());

        /// <summary>Its value, a file with an ending that can be written.</summary>
        /// <exception cref="CommandLineException">The ending is another one, or the file cannot be written.</exception>
        public string File(string ending) => OutputPath.File(Name, Value(), ending);

        /// <summary>Its values: words up to the next flag, each divided at its commas.</summary>
        /// <exception cref="CommandLineException">There is none, or one is empty.</exception>
        public IReadOnlyList<string> Values() => given == null ? CommandLineWords.Values(commandLine, ref index)
            : CommandLineWords.List(Name, given);
    }
}
