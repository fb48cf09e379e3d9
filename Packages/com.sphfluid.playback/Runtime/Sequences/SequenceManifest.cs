using System;
using System.Globalization;
using UnityEngine;

namespace SphFluid
{
    /// <summary>The file sequence.json of a sequence, as it stands there.</summary>
    [Serializable]
    internal sealed class SequenceManifest
    {
        public const string FileName = "sequence.json", FormatName = "sphfluid-sequence";
        public const int Version = 1;

        [Tooltip("Always sphfluid-sequence.")]
        public string format = "";
        [Tooltip("Version of the format.")]
        public int version;
        [Tooltip("What the sequence was made by, for people.")]
        public string source = "";
        [Tooltip("Particle spacing in metres.")]
        public double spacing;
        [Tooltip("Edge lengths of the domain in metres.")]
        public float[] domainSize;
        [Tooltip("The frames in the order of their times.")]
        public SequenceManifestFrame[] frames;

        /// <summary>Edge lengths of the domain [m].</summary>
        public Vector3 Size => new Vector3(domainSize[0], domainSize[1], domainSize[2]);

        /// <summary>Reads and checks the text of a manifest.</summary>
        /// <param name="text">The text.</param>
        /// <exception cref="SequenceException">It is none that can be played.</exception>
        public static SequenceManifest Parse(string text)
        {
            SequenceManifest manifest;
            try
            {
                manifest = JsonUtility.FromJson<SequenceManifest>(text);
            }
            catch (Exception exception) when (exception is ArgumentException || exception is FormatException ||
                exception is OverflowException || exception is InvalidOperationException ||
                exception is InvalidCastException)
            {
                throw new SequenceException("is no JSON that can be read");
            }
            if (manifest == null) throw new SequenceException("is empty");
            manifest.Check();
            return manifest;
        }

        private void Check()
        {
            if (format != FormatName)
            {
                throw new SequenceException($"has the format '{format}', not '{FormatName}'", "Give the folder of a sequence.");
            }
            if (version != Version)
            {
                throw new SequenceException($"has the version {version}, and this version of the package plays {Version}",
                    "Write the sequence anew.");
            }
            if (!(spacing > 0.0) || double.IsInfinity(spacing)) throw Wrong("spacing", "the particle spacing in metres");
            if (domainSize == null || domainSize.Length != 3) throw Wrong("domainSize", "three edge lengths in metres");
            foreach (float length in domainSize)
                if (!(length > 0f) || float.IsInfinity(length)) throw Wrong("domainSize", "three edge lengths in metres");
            if (frames == null || frames.Length == 0) throw new SequenceException("names no frames", "Write one frame or more.");
            for (int i = 0; i < frames.Length; i++) frames[i].Check(i, i > 0 ? frames[i - 1].time : double.NegativeInfinity);
        }

        private static SequenceException Wrong(string field, string meant) =>
            new SequenceException($"has no {field} that can be used", $"Give {field} {meant}.");
    }

    /// <summary>A frame in <see cref="SequenceManifest"/>.</summary>
    [Serializable]
    internal sealed class SequenceManifestFrame
    {
        [Tooltip("Name of the file in the folder.")]
        public string file = "";
        [Tooltip("Time in seconds.")]
        public double time;
        [Tooltip("Number of particles.")]
        public long particles;
        [Tooltip("Length of the file.")]
        public long bytes;
        [Tooltip("CRC-32 of the whole file, eight hexadecimal digits.")]
        public string crc32 = "";

        /// <summary>The check of the whole file.</summary>
        public uint Crc => uint.Parse(crc32, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture);

        /// <summary>Checks the entry.</summary>
        /// <param name="number">Its place, from 0 on.</param>
        /// <param name="before">Time of the frame before [s].</param>
        public void Check(int number, double before)
        {
            if (!IsName(file))
            {
                throw new SequenceException($"names '{file}' as the file of frame {number}",
                    "Name a file in the folder itself, without a path.");
            }
            if (!(time > before) || double.IsInfinity(time))
            {
                throw new SequenceException(
                    FormattableString.Invariant($"has the time {time} s for frame {number}, which is not after the frame before"),
                    "Write frames in the order of their times.");
            }
            if (particles < 0 || particles > int.MaxValue || bytes < 0 || bytes > int.MaxValue)
            {
                throw new SequenceException($"has {particles} particles and {bytes} bytes for frame {number}",
                    "Files of 2 GiB and more cannot be played: use a coarser spacing.");
            }
            if (crc32 == null || crc32.Length != 8 ||
                !uint.TryParse(crc32, NumberStyles.AllowHexSpecifier, CultureInfo.InvariantCulture, out _))
            {
                throw new SequenceException($"has the crc32 '{crc32}' for frame {number}", "Write eight hexadecimal digits.");
            }
        }

        private static bool IsName(string file) => !string.IsNullOrEmpty(file) && file != "." && file != ".." &&
            file.IndexOfAny(new[] { '/', '\\', ':', '\0' }) < 0;
    }
}
