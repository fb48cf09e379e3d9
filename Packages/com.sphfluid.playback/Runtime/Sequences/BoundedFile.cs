using System;
using System.IO;

namespace SphFluid
{
    /// <summary>Reads files whose content nobody vouches for: regular ones only, and no more of them than is asked for.</summary>
    internal static class BoundedFile
    {
        /// <summary>
        /// Opens a file or what a link leads to. A pipe waits for a writer and a device has no end. .NET tells neither from a file; but
        /// neither has a length, and a pipe that is opened for both directions does not wait.
        /// </summary>
        /// <param name="path">The file.</param>
        /// <returns>A stream with a length above zero, without a buffer of its own.</returns>
        /// <exception cref="IOException">It is empty or no regular file, or cannot be read.</exception>
        public static FileStream Open(string path)
        {
            var info = new FileInfo(path);
            if (info.Length == 0) throw Empty(path);
            FileStream stream = null;
            try
            {
                if ((info.Attributes & FileAttributes.ReparsePoint) != 0) stream = Open(path, FileAccess.ReadWrite);
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException)
            {
                // What may only be read is opened as such.
            }
            stream ??= Open(path, FileAccess.Read);
            if (stream.CanSeek && stream.Length > 0) return stream;
            stream.Dispose();
            throw Empty(path);
        }

        /// <summary>Reads a text file.</summary>
        /// <param name="path">The file.</param>
        /// <param name="most">Most bytes.</param>
        /// <returns>Null where it has more.</returns>
        /// <exception cref="IOException">It is empty or no regular file, or cannot be read.</exception>
        public static string ReadText(string path, int most)
        {
            using (FileStream stream = Open(path))
            {
                if (stream.Length > most) return null;
                var bytes = new byte[stream.Length];
                int read = Fill(stream, bytes, bytes.Length);
                using (var reader = new StreamReader(new MemoryStream(bytes, 0, read))) return reader.ReadToEnd();
            }
        }

        /// <summary>Reads bytes until there are as many as asked for, or no more.</summary>
        /// <returns>How many there are.</returns>
        public static int Fill(Stream stream, byte[] bytes, int count)
        {
            int read = 0, part;
            while (read < count && (part = stream.Read(bytes, read, count - read)) > 0) read += part;
            return read;
        }

        private static FileStream Open(string path, FileAccess access) => new FileStream(path, FileMode.Open, access, FileShare.Read, 1);

        private static IOException Empty(string path) => new IOException($"{Path.GetFileName(path)} is empty, or no regular file");
    }
}
