using System;
using System.IO;

namespace SphFluid.Validation
{
    /// <summary>Checks where results will go before anything is computed for them.</summary>
    static class OutputPath
    {
        /// <summary>A folder that is there or can be made.</summary>
        /// <exception cref="CommandLineException">It cannot.</exception>
        public static string Folder(string flag, string value)
        {
            string full = Full(flag, value);
            if (System.IO.File.Exists(full))
                throw new CommandLineException($"{flag}: '{CommandLineWords.Shown(value)}' is a file; name a folder.");
            RequireParents(flag, value, full);
            return value;
        }

        /// <summary>A file that is there or can be made.</summary>
        /// <exception cref="CommandLineException">It has another ending, or cannot be written.</exception>
        public static string File(string flag, string value, string ending)
        {
            if (!value.EndsWith(ending, StringComparison.OrdinalIgnoreCase) || Path.GetFileName(value).Length == ending.Length)
                throw new CommandLineException($"{flag} must be a file ending in {ending}, found '{CommandLineWords.Shown(value)}'.");
            string full = Full(flag, value);
            if (Directory.Exists(full))
                throw new CommandLineException($"{flag}: '{CommandLineWords.Shown(value)}' is a folder; name a file.");
            RequireParents(flag, value, full);
            return value;
        }

        // A folder cannot be made below a file.
        static void RequireParents(string flag, string value, string full)
        {
            for (string parent = Path.GetDirectoryName(full); !string.IsNullOrEmpty(parent) && !Directory.Exists(parent); parent = Path.GetDirectoryName(parent))
            {
                if (System.IO.File.Exists(parent))
                    throw new CommandLineException($"{flag}: '{CommandLineWords.Shown(value)}' cannot be made, because '{parent}' is a file.");
            }
        }

        static string Full(string flag, string value)
        {
            try
            {
                return Path.GetFullPath(value);
            }
            catch (Exception exception) when (exception is ArgumentException || exception is NotSupportedException || exception is PathTooLongException)
            {
                throw new CommandLineException($"{flag}: '{CommandLineWords.Shown(value)}' is no path: {exception.Message}");
            }
        }
    }
}
