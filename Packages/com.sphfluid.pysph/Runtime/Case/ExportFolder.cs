using System;
using System.Collections.Generic;
using System.IO;
using System.Security.Cryptography;
using System.Text;
using UnityEngine;

namespace SphFluid
{
    /// <summary>A folder that an export is written to. Only what an export wrote is replaced.</summary>
    internal sealed class ExportFolder
    {
        public const string ManifestName = "manifest.json";

        private const int MostManifestBytes = 1 << 26;

        private readonly string path;
        private readonly List<ExportManifest.Entry> files = new List<ExportManifest.Entry>();

        private ExportFolder(string path)
        {
            this.path = path;
        }

        /// <summary>What was written, in its order.</summary>
        public List<ExportManifest.Entry> Files => files;

        /// <summary>Bytes that were written.</summary>
        public long Bytes
        {
            get
            {
                long sum = 0;
                foreach (ExportManifest.Entry file in files) sum += file.bytes;
                return sum;
            }
        }

        /// <summary>Makes the folder, or removes what an earlier export left there.</summary>
        /// <param name="path">The folder.</param>
        /// <exception cref="IOException">It holds what no export wrote, or cannot be written.</exception>
        public static ExportFolder Open(string path)
        {
            if (File.Exists(path)) throw new IOException($"'{path}' is a file; name a folder.");
            Directory.CreateDirectory(path);
            string manifest = Path.Combine(path, ManifestName);
            if (File.Exists(manifest)) RemoveFilesOf(path, manifest);
            else if (Directory.GetFileSystemEntries(path).Length > 0)
                throw new IOException($"The folder '{path}' holds files that no export wrote. Name another folder, or empty it.");
            return new ExportFolder(path);
        }

        /// <summary>Writes a file and takes its hash.</summary>
        /// <param name="name">Its name.</param>
        /// <param name="write">Writes its contents.</param>
        public void Write(string name, Action<Stream> write)
        {
            string file = Path.Combine(path, name);
            using (var stream = new FileStream(file, FileMode.Create, FileAccess.Write, FileShare.None, 1 << 20)) write(stream);
            using (var stream = new FileStream(file, FileMode.Open, FileAccess.Read, FileShare.Read, 1 << 20))
            using (var hash = SHA256.Create())
            {
                string hex = BitConverter.ToString(hash.ComputeHash(stream)).Replace("-", "").ToLowerInvariant();
                files.Add(new ExportManifest.Entry { name = name, bytes = stream.Length, sha256 = hex });
            }
        }

        /// <summary>Writes a text file: UTF-8, line feeds.</summary>
        public void WriteText(string name, string text) =>
            Write(name, stream => stream.Write(Encoding.UTF8.GetBytes(text.Replace("\r\n", "\n"))));

        /// <summary>Writes the manifest, last: a folder that has it is whole.</summary>
        public void Close(ExportManifest manifest)
        {
            (manifest.format, manifest.files) = (ExportManifest.FormatName, files);
            File.WriteAllText(Path.Combine(path, ManifestName), JsonUtility.ToJson(manifest, true) + "\n");
        }

        private static void RemoveFilesOf(string path, string manifest)
        {
            ExportManifest earlier = null;
            try
            {
                // A pipe has no length, and neither it nor a link is written by an export.
                var file = new FileInfo(manifest);
                bool isPlain = (file.Attributes & FileAttributes.ReparsePoint) == 0 && file.Length > 0 && file.Length <= MostManifestBytes;
                if (isPlain) earlier = JsonUtility.FromJson<ExportManifest>(File.ReadAllText(manifest));
            }
            catch (Exception exception) when (exception is ArgumentException || exception is IOException)
            {
                // No JSON, or no file: not ours.
            }
            if (earlier?.format != ExportManifest.FormatName)
            {
                throw new IOException(
                    $"The folder '{path}' holds a {ManifestName} that no export wrote. Name another folder, or empty it.");
            }
            File.Delete(manifest);
            foreach (ExportManifest.Entry file in earlier.files)
                if (file.name == Path.GetFileName(file.name)) File.Delete(Path.Combine(path, file.name));
        }
    }
}
