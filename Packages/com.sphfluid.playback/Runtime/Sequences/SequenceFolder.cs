using System;
using System.Collections.Generic;
using System.IO;
using System.Security;
using UnityEngine;

namespace SphFluid
{
    /// <summary>Finds out what a folder of particle files holds.</summary>
    internal static class SequenceFolder
    {
        private const int MostManifestBytes = 1 << 26;

        /// <summary>Opens a folder: by its sequence.json, or where it has none all its .ply files in the order of their names.</summary>
        /// <param name="folder">Path, absolute or from StreamingAssets.</param>
        /// <param name="frameRate">Frames a second of a folder without sequence.json.</param>
        /// <exception cref="SequenceException">It cannot be played; the message goes on behind the folder's name.</exception>
        public static ParticleSequence Open(string folder, double frameRate)
        {
            try
            {
                string full = FullPath(folder);
                if (!Directory.Exists(full))
                {
                    throw new SequenceException("is no folder",
                        "Set Folder to a folder with particle files; it is looked for below StreamingAssets unless its path is absolute.");
                }
                string manifest = Path.Combine(full, SequenceManifest.FileName);
                return File.Exists(manifest) ? OpenManifest(full, manifest) : OpenFiles(full, frameRate);
            }
            catch (Exception exception) when (exception is IOException || exception is UnauthorizedAccessException ||
                exception is SecurityException ||
                exception is ArgumentException || exception is NotSupportedException)
            {
                throw new SequenceException($"cannot be read ({exception.Message.TrimEnd('.')})",
                    "See that its files are whole and may be read, or set Folder to another folder.");
            }
        }

        /// <summary>A folder as an absolute path.</summary>
        public static string FullPath(string folder) => Path.GetFullPath(Path.Combine(Application.streamingAssetsPath, folder ?? ""));

        /// <summary>Which of two names comes first: numbers in them count as numbers, so that frame-2 is before frame-10.</summary>
        public static int Compare(string a, string b)
        {
            int i = 0, j = 0;
            while (i < a.Length && j < b.Length)
            {
                int order = IsDigit(a[i]) && IsDigit(b[j]) ? CompareNumbers(a, ref i, b, ref j) : a[i++].CompareTo(b[j++]);
                if (order != 0) return order;
            }
            int rest = (a.Length - i).CompareTo(b.Length - j);
            return rest != 0 ? rest : string.CompareOrdinal(a, b);
        }

        private static ParticleSequence OpenManifest(string folder, string file)
        {
            string text = BoundedFile.ReadText(file, MostManifestBytes) ?? throw new SequenceException(
                $"has a {SequenceManifest.FileName} of more than {MostManifestBytes >> 20} MiB",
                "Divide the sequence among folders, with fewer frames each.");
            SequenceManifest manifest;
            try
            {
                manifest = SequenceManifest.Parse(text);
            }
            catch (SequenceException exception)
            {
                throw new SequenceException($"has a {SequenceManifest.FileName} that {exception.Message}", exception.Cure);
            }
            SequenceFrame[] frames = Array.ConvertAll(manifest.frames,
                f => new SequenceFrame(Path.Combine(folder, f.file), f.time, f.particles, f.bytes, f.Crc));
            return new ParticleSequence(folder, frames, true, true)
            {
                Spacing = (float)manifest.spacing, DomainSize = manifest.Size,
                Source = manifest.source ?? ""
            };
        }

        private static ParticleSequence OpenFiles(string folder, double frameRate)
        {
            if (!(frameRate > 0.0) || double.IsInfinity(frameRate))
            {
                throw new SequenceException("has no sequence.json and so no times", "Give Frame Rate a number greater than zero.");
            }
            string[] files = Directory.GetFiles(folder, "*.ply");
            Array.Sort(files, (a, b) => Compare(Path.GetFileName(a), Path.GetFileName(b)));
            if (files.Length == 0)
            {
                throw new SequenceException("has no sequence.json and no .ply files", "Set Folder to a folder with particle files.");
            }
            var frames = new List<SequenceFrame>();
            var header = new PlyHeader();
            var begin = new byte[PlyHeader.MostBytes];
            bool hasIds = true, hasVelocities = true;
            foreach (string file in files)
            {
                long particles = 0;
                if (TryRead(file, begin, header, out long bytes))
                {
                    particles = header.Vertex.Count;
                    hasIds &= header.HasIds;
                    hasVelocities &= header.HasVelocities;
                }
                if (particles > bytes || bytes > int.MaxValue) particles = 0; // reading it will tell
                frames.Add(new SequenceFrame(file, frames.Count / frameRate, particles, Math.Min(bytes, int.MaxValue), null));
            }
            return new ParticleSequence(folder, frames, hasIds, hasVelocities);
        }

        // A file that cannot be read, or with another header, is named when its frame is read.
        private static bool TryRead(string file, byte[] begin, PlyHeader header, out long bytes)
        {
            bytes = 0;
            try
            {
                using (FileStream stream = BoundedFile.Open(file))
                {
                    bytes = stream.Length;
                    header.Read(new ReadOnlySpan<byte>(begin, 0, BoundedFile.Fill(stream, begin, begin.Length)));
                    return true;
                }
            }
            catch (Exception exception) when (exception is IOException || exception is SequenceException)
            {
                return false;
            }
        }

        private static bool IsDigit(char c) => c >= '0' && c <= '9';

        private static int CompareNumbers(string a, ref int i, string b, ref int j)
        {
            int beginA = SkipZeros(a, ref i), beginB = SkipZeros(b, ref j);
            int length = (i - beginA).CompareTo(j - beginB);
            return length != 0 ? length : string.CompareOrdinal(a, beginA, b, beginB, i - beginA);
        }

        // To the end of a number; where its first digit is that counts.
        private static int SkipZeros(string text, ref int place)
        {
            while (place < text.Length && text[place] == '0') place++;
            int begin = place;
            while (place < text.Length && IsDigit(text[place])) place++;
            return begin;
        }
    }
}
