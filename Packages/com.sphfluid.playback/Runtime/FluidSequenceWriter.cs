using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Runtime.InteropServices;
using System.Text;
using UnityEngine;

namespace SphFluid
{
    /// <summary>
    /// Writes a liquid frame by frame into a folder that a <see cref="FluidPlayback"/> plays: a binary PLY file a frame with positions,
    /// velocities and ids, and sequence.json with times and checks every few seconds and when it is disposed. It waits for the GPU in each
    /// frame: for tools and for what is recorded once and played often.
    /// </summary>
    public sealed class FluidSequenceWriter : IDisposable
    {
        private const double ManifestSeconds = 2.0;

        private readonly string folder;
        private readonly SequenceManifest manifest;
        private readonly List<SequenceManifestFrame> frames = new List<SequenceManifestFrame>();
        private readonly List<FluidParticle> particles = new List<FluidParticle>();
        private readonly Stopwatch sinceManifest = Stopwatch.StartNew();
        private byte[] bytes = Array.Empty<byte>();
        private bool isDisposed;

        /// <summary>Begins a sequence.</summary>
        /// <param name="folder">Is made where it is not there. It must not hold a sequence or .ply files.</param>
        /// <param name="domainSize">Edge lengths of the domain [m].</param>
        /// <param name="spacing">Particle spacing [m].</param>
        /// <param name="source">What the liquid was computed by, for people; may be empty.</param>
        /// <exception cref="ArgumentException">A length is not positive, or there is no folder.</exception>
        /// <exception cref="IOException">The folder cannot be made, or holds a sequence or .ply files.</exception>
        public FluidSequenceWriter(string folder, Vector3 domainSize, float spacing, string source = "")
        {
            if (string.IsNullOrEmpty(folder)) throw new ArgumentException("A sequence needs a folder.", nameof(folder));
            if (!(domainSize.x > 0f && domainSize.y > 0f && domainSize.z > 0f && AffineMath.IsFinite(domainSize)))
            {
                throw new ArgumentException($"The domain size is {domainSize}. Give three positive edge lengths in metres.",
                    nameof(domainSize));
            }
            if (!(spacing > 0f) || float.IsInfinity(spacing))
            {
                throw new ArgumentException($"The particle spacing is {spacing}. Give a positive length in metres.", nameof(spacing));
            }
            this.folder = Path.GetFullPath(folder);
            Directory.CreateDirectory(this.folder);
            if (File.Exists(ManifestFile) || Directory.GetFiles(this.folder, "*.ply").Length > 0)
            {
                throw new IOException($"'{folder}' holds a sequence or .ply files already. Name another folder, or delete them first.");
            }
            manifest = new SequenceManifest
            {
                format = SequenceManifest.FormatName,
                version = SequenceManifest.Version,
                source = source ?? "",
                spacing = double.Parse(spacing.ToString("R", System.Globalization.CultureInfo.InvariantCulture),
                    System.Globalization.CultureInfo.InvariantCulture),
                domainSize = new[] { domainSize.x, domainSize.y, domainSize.z },
            };
        }

        /// <summary>Frames that were written.</summary>
        public int FrameCount => frames.Count;

        private string ManifestFile => Path.Combine(folder, SequenceManifest.FileName);

        /// <summary>Writes the liquid of a simulation as it is now, waiting for the GPU.</summary>
        /// <param name="simulation">A simulation that runs.</param>
        /// <exception cref="ArgumentNullException">There is none.</exception>
        /// <exception cref="InvalidOperationException">It does not run, or no time has passed since the frame before.</exception>
        /// <exception cref="IOException">The file cannot be written.</exception>
        public void Write(FluidSimulation simulation)
        {
            if (simulation == null) throw new ArgumentNullException(nameof(simulation));
            if (!simulation.TryReadParticles(particles))
            {
                throw new InvalidOperationException($"'{simulation.name}' does not run, so there is nothing to write.");
            }
            Write(simulation.SimulatedTime, particles);
        }

        /// <summary>Writes particles as a frame.</summary>
        /// <param name="time">Its time [s], after that of the frame before.</param>
        /// <param name="frame">The particles, each with an id of its own, in simulation space; those that are marked as removed are passed
        /// over.</param>
        /// <exception cref="ArgumentNullException">There are none.</exception>
        /// <exception cref="ArgumentException">The time is not finite, two have the same id, or there are more than a file of 2 GiB
        /// holds.</exception>
        /// <exception cref="InvalidOperationException">The time is not after that of the frame before, or the sequence is
        /// finished.</exception>
        /// <exception cref="IOException">The file cannot be written.</exception>
        public void Write(double time, IReadOnlyList<FluidParticle> frame)
        {
            if (frame == null) throw new ArgumentNullException(nameof(frame));
            Require.Within(time, double.MinValue, double.MaxValue, nameof(time));
            if (isDisposed) throw new InvalidOperationException("The sequence is finished. Begin another one.");
            if (!(time > (frames.Count > 0 ? frames[frames.Count - 1].time : double.NegativeInfinity)))
            {
                throw new InvalidOperationException(
                    FormattableString.Invariant($"The time {time} s is not after that of the frame before. Write each moment once, in ") +
                    "order.");
            }
            StoredParticle[] live = Live(frame);
            byte[] header = Encoding.ASCII
                .GetBytes(
                    $"ply\nformat binary_little_endian 1.0\nelement vertex {live.Length}\nproperty float x\nproperty float y\nproperty " +
                    "float z\n" +
                "property float vx\nproperty float vy\nproperty float vz\nproperty uint id\nend_header\n");
            int length = header.Length + StoredParticle.Stride * live.Length;
            if (bytes.Length < length) bytes = new byte[length];
            header.CopyTo(bytes, 0);
            MemoryMarshal.AsBytes(new ReadOnlySpan<StoredParticle>(live))
                .CopyTo(new Span<byte>(bytes, header.Length, length - header.Length));
            string name = FormattableString.Invariant($"frame-{frames.Count:00000}.ply");
            // Of no frames at first, and as such refused: frames that a full disk cuts short do not pass for a sequence without
            // sequence.json.
            if (frames.Count == 0) WriteManifest();
            WriteWhole(Path.Combine(folder, name), bytes, length);
            frames.Add(new SequenceManifestFrame
            {
                file = name,
                time = time,
                particles = live.Length,
                bytes = length,
                crc32 = FormattableString.Invariant($"{Crc32.Compute(new ReadOnlySpan<byte>(bytes, 0, length)):x8}"),
            });
            if (sinceManifest.Elapsed.TotalSeconds > ManifestSeconds) WriteManifest();
        }

        /// <summary>Writes sequence.json, unless there is no frame.</summary>
        /// <exception cref="IOException">It cannot be written.</exception>
        public void Dispose()
        {
            if (isDisposed) return;
            isDisposed = true;
            if (frames.Count > 0) WriteManifest();
        }

        private void WriteManifest()
        {
            manifest.frames = frames.ToArray();
            byte[] text = Encoding.UTF8.GetBytes(JsonUtility.ToJson(manifest, true));
            WriteWhole(ManifestFile, text, text.Length);
            sinceManifest.Restart();
        }

        // Beside the old one first: a program that is ended in the middle, or a full disk, leaves one of them whole. A frame is never there
        // before.
        private void WriteWhole(string file, byte[] contents, int length)
        {
            string part = file + ".part";
            FileStream stream = File.Create(part);
            try
            {
                using (stream) stream.Write(contents, 0, length);
                if (file == ManifestFile && File.Exists(file)) File.Replace(part, file, null);
                else File.Move(part, file);
            }
            catch
            {
                File.Delete(part);
                throw;
            }
        }

        private static StoredParticle[] Live(IReadOnlyList<FluidParticle> frame)
        {
            var live = new StoredParticle[frame.Count];
            int count = 0;
            for (int i = 0; i < live.Length; i++)
                if (!frame[i].IsRemoved) live[count++] = StoredParticle.Create(frame[i]);
            if (count > (int.MaxValue - PlyHeader.MostBytes) / StoredParticle.Stride)
            {
                throw new ArgumentException($"{count} particles are more than a file of 2 GiB holds. Use a coarser spacing.",
                    nameof(frame));
            }
            Array.Resize(ref live, count);
            try
            {
                ParticleIds.Sort(live);
            }
            catch (SequenceException exception)
            {
                throw new ArgumentException($"The frame {exception.Message}. {exception.Cure}", nameof(frame));
            }
            return live;
        }
    }
}
