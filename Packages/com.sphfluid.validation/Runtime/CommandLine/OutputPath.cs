using System;
using System.IO;

namespace SphFluid.Validation
{
    /// <summary>Checks where results will go before anything is computed for them.</summary>
    internal static class OutputPath
    {
        /// <summary>A folder that is there or can be made.</summary>
        /// <exception cref="CommandLineException">It cannot.</exception>
        public static string Folder(string flag, string value)
        {
            string full = Full(flag, value);
            if (System.IO.File.Exists(full))
            {
                throw new CommandLineException($"{flag}: '{CommandLineWords.Shown(value)}' is a file; name a folder.");
            }
            RequireWritable(flag, value, Path.Combine(full, "new"));
            return value;
        }

        /// <summary>A file that is there or can be made.</summary>
        /// <exception cref="CommandLineException">It has another ending, or cannot be written.</exception>
        public static string File(string flag, string value, string ending)
        {
            if (!value.EndsWith(ending, StringComparison.OrdinalIgnoreCase) || Path.GetFileName(value).Length == ending.Length)
            {
                throw new CommandLineException($"{flag} must be a file ending in {ending}, found '{CommandLineWords.Shown(value)}'.");
            }
            string full = Full(flag, value);
            if (Directory.Exists(full))
            {
                throw new CommandLineException($"{flag}: '{CommandLineWords.Shown(value)}' is a folder; name a file.");
            }
            RequireWritable(flag, value, full);
            return value;
        }

        // By an empty file beside the first part of the path that is not there yet, which goes at once.
        private static void RequireWritable(string flag, string value, string full)
        {
            string parent = Path.GetDirectoryName(full);
            for (; !string.IsNullOrEmpty(parent) && !Directory.Exists(parent); parent = Path.GetDirectoryName(parent))
            {
                if (System.IO.File.Exists(parent))
                {
                    throw new CommandLineException(
                        $"{flag}: '{CommandLineWords.Shown(value)}' cannot be made, because '{parent}' is a file.");
                }
                full = parent;
            }
            try
            {
                string trial = full + WholeFile.Unfinished;
                if (!System.IO.File.Exists(trial))
                {
                    new FileStream(trial, FileMode.CreateNew, FileAccess.Write, FileShare.None, 1, FileOptions.DeleteOnClose).Dispose();
                }
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException)
            {
                throw new CommandLineException($"{flag}: '{CommandLineWords.Shown(value)}' cannot be written: {exception.Message}");
            }
        }

        private static string Full(string flag, string value)
        {
            try
            {
                return Path.GetFullPath(value);
            }
            catch (Exception exception) when (exception is ArgumentException || exception is NotSupportedException ||
                exception is PathTooLongException)
            {
                throw new CommandLineException($"{flag}: '{CommandLineWords.Shown(value)}' is no path: {exception.Message}");
            }
        }
    }
}
