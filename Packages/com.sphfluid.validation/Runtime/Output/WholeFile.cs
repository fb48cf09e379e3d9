using System;
using System.IO;

namespace SphFluid.Validation
{
    /// <summary>
    /// Files that have their name only when they are whole: whoever stops the program, or fills the disk, finds the last whole one.
    /// </summary>
    internal static class WholeFile
    {
        /// <summary>Of a file that is being written.</summary>
        public const string Unfinished = ".tmp";

        /// <summary>Writes a file.</summary>
        /// <param name="file">The file; its folder is made if there is none.</param>
        /// <param name="write">Writes its contents.</param>
        /// <exception cref="IOException">It cannot be written; nothing is left of the attempt.</exception>
        public static void Write(string file, Action<Stream> write)
        {
            Directory.CreateDirectory(Path.GetDirectoryName(Path.GetFullPath(file)));
            string unfinished = file + Unfinished;
            var stream = new FileStream(unfinished, FileMode.Create, FileAccess.Write, FileShare.None, 1 << 16);
            try
            {
                using (stream)
                    write(stream);
                if (File.Exists(file))
                    File.Replace(unfinished, file, null);
                else
                    File.Move(unfinished, file);
            }
            catch
            {
                File.Delete(unfinished);
                throw;
            }
        }
    }
}
