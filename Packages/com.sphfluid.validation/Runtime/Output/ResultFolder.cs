using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace SphFluid.Validation
{
    /// <summary>
    /// The folder of a measurement's results: a new one, an empty one, or one that a measurement wrote to before. A list in it names what
    /// measurements wrote there; only that is replaced. Without the list, as in a fresh clone of committed results, a table with the
    /// measurement's columns and a script with its first line count as such, and so do the pictures that the script draws. The user's
    /// own files stay: where one has a name that is needed, nothing is measured.
    /// </summary>
    internal sealed class ResultFolder
    {
        /// <summary>The list: a name a line.</summary>
        public const string ListName = ".sphfluid-files";

        /// <summary>
        /// Open and locked while a measurement writes to the folder; the system unlocks it when the process ends, however that is.
        /// </summary>
        public const string LockName = ".sphfluid-lock";

        private const int LongestFirstLine = 10000;

        private readonly string folder;
        private FileStream held;
        private readonly Dictionary<string, ResultFile> files;
        private readonly HashSet<string> listed;

        private ResultFolder(string folder, IEnumerable<ResultFile> files)
        {
            this.folder = folder;
            this.files = files.ToDictionary(f => f.Name);
            string list = PathOf(ListName);
            listed = new HashSet<string>(File.Exists(list) ? File.ReadLines(list).Where(n => n.Length > 0) : Enumerable.Empty<string>());
        }

        /// <summary>Makes the folder and claims the names in it.</summary>
        /// <param name="folder">The value of --out.</param>
        /// <param name="files">All files that may be written.</param>
        /// <exception cref="CommandLineException">The folder cannot be written, is in use, or holds what no measurement wrote.</exception>
        public static ResultFolder Open(string folder, IEnumerable<ResultFile> files)
        {
            ResultFolder result = null;
            try
            {
                Directory.CreateDirectory(folder);
                result = new ResultFolder(folder, files);
                result.Refuse();
                result.Hold();
                result.listed.UnionWith(result.files.Keys);
                result.WriteList(result.listed);
                return result;
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException)
            {
                result?.held?.Dispose();
                throw new CommandLineException(
                    $"--out: the folder '{CommandLineWords.Shown(folder)}' cannot be written: {exception.Message}");
            }
        }

        /// <summary>Lets another of this program's measurements write to the folder.</summary>
        public void Release() => held.Dispose();

        /// <summary>
        /// Gives the folder up, and takes names off the list that were not needed, so that a file that gets one of them later is the
        /// user's.
        /// </summary>
        public void Close()
        {
            Release();
            try
            {
                WriteList(listed.Where(n => File.Exists(PathOf(n))));
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException)
            {
                // The longer list stays.
            }
        }

        private void Hold()
        {
            string file = PathOf(LockName);
            try
            {
                held = new FileStream(file, FileMode.OpenOrCreate, FileAccess.ReadWrite, FileShare.None, 1, FileOptions.DeleteOnClose);
            }
            catch (IOException) when (File.Exists(file))
            {
                throw new CommandLineException(
                    $"--out: another measurement writes to '{CommandLineWords.Shown(folder)}'. Wait for its end, or name another folder.");
            }
        }

        private void Refuse()
        {
            string[] foreign = files.Values.Where(f => !IsOurs(f)).Select(f => f.Name).OrderBy(n => n, StringComparer.Ordinal).ToArray();
            if (foreign.Length == 0)
            {
                if (listed.Count == 0 && !files.Values.Any(f => File.Exists(PathOf(f.Name))) &&
                    Directory.EnumerateFileSystemEntries(folder).Any(e => Path.GetFileName(e) != LockName))
                {
                    throw new CommandLineException(
                        $"--out: '{CommandLineWords.Shown(folder)}' is not empty, and no measurement made it. Name a new folder, or an " +
                        "empty one.");
                }
                return;
            }
            string more = foreign.Length > 1 ? $" and {foreign.Length - 1} more" : "";
            throw new CommandLineException(
                $"--out: '{CommandLineWords.Shown(folder)}' holds {foreign[0]}{more}, which no measurement wrote and this one would " +
                "replace. " +
                "Name another folder, or move the files away.");
        }

        // True where there is none.
        private bool IsOurs(ResultFile file)
        {
            string path = PathOf(file.Name);
            if (Directory.Exists(path) || IsBelowAFile(file.Name)) return false;
            if (listed.Contains(file.Name)) return true;
            if (File.Exists(path + WholeFile.Unfinished)) return false;
            return !File.Exists(path) || HasFirstLine(file) || file.Script != null && HasFirstLine(files[file.Script]);
        }

        private bool HasFirstLine(ResultFile file)
        {
            string path = PathOf(file.Name);
            if (file.FirstLine == null || !File.Exists(path)) return false;
            using (var reader = new StreamReader(path))
            {
                var start = new char[Math.Min(LongestFirstLine, file.FirstLine.Length + 1)];
                int count = reader.ReadBlock(start, 0, start.Length);
                string line = new string(start, 0, count);
                return line == file.FirstLine || line.TrimEnd('\r', '\n') == file.FirstLine;
            }
        }

        // "curves" of "curves/a.csv" is a file.
        private bool IsBelowAFile(string name)
        {
            string parent = Path.GetDirectoryName(name);
            return !string.IsNullOrEmpty(parent) && File.Exists(PathOf(parent));
        }

        private void WriteList(IEnumerable<string> names)
        {
            string[] lines = names.OrderBy(n => n, StringComparer.Ordinal).ToArray();
            if (lines.Length > 0)
                File.WriteAllLines(PathOf(ListName), lines);
            else
                File.Delete(PathOf(ListName));
        }

        private string PathOf(string name) => Path.Combine(folder, name);
    }
}
