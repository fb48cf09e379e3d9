using System;
using System.IO;

namespace SphFluid
{
    /// <summary>Brings a frame into memory.</summary>
    internal interface ISequenceReader
    {
        /// <summary>Reads a frame; from one thread at a time.</summary>
        /// <param name="frame">Its number.</param>
        /// <param name="slot">Receives it.</param>
        /// <exception cref="SequenceException">It cannot be used; the message goes on behind the file's name.</exception>
        /// <exception cref="IOException">It cannot be read.</exception>
        void Read(int frame, SequenceSlot slot);
    }

    /// <summary>
    /// Reads frames from files: checks them, decodes them, and puts their particles into simulation space and in the order of their
    /// numbers.
    /// </summary>
    internal sealed class SequenceReader : ISequenceReader
    {
        private readonly ParticleSequence sequence;
        private readonly FluidSequenceAxes axes;
        private readonly float scale;
        private readonly PlyHeader header = new PlyHeader();
        private readonly byte[] bytes;

        /// <param name="sequence">What is read.</param>
        /// <param name="axes">Which way the axes of its files point.</param>
        /// <param name="scale">Metres of a unit of length in its files.</param>
        public SequenceReader(ParticleSequence sequence, FluidSequenceAxes axes = FluidSequenceAxes.AsUnity, float scale = 1f)
        {
            this.sequence = sequence;
            this.axes = axes;
            this.scale = scale;
            bytes = new byte[Math.Max(1L, sequence.MostBytes)];
        }

        /// <inheritdoc/>
        public void Read(int frame, SequenceSlot slot)
        {
            SequenceFrame asked = sequence.Frames[frame];
            ReadOnlySpan<byte> file = ReadFile(asked);
            if (asked.Crc is uint crc && Crc32.Compute(file) != crc)
            {
                throw new SequenceException("was altered since the sequence was written: its CRC-32 is another");
            }
            header.Read(file);
            if (asked.Crc != null && header.Vertex.Count != asked.Particles)
            {
                throw new SequenceException(
                    $"has {header.Vertex.Count} particles where {SequenceManifest.FileName} says {asked.Particles}");
            }
            if (sequence.HasIds && !header.HasIds)
            {
                throw new SequenceException("has particles without ids, and other frames have them",
                    "Write the property id in all frames or in none.");
            }
            Span<StoredParticle> particles = slot.Resize(header.Vertex.Count);
            PlyDecoder.Decode(file, header, particles);
            Place(particles);
            if (sequence.HasIds) ParticleIds.Sort(particles);
            else
                for (int i = 0; i < particles.Length; i++) particles[i].Id = (uint)i;
        }

        private ReadOnlySpan<byte> ReadFile(in SequenceFrame frame)
        {
            using (FileStream stream = BoundedFile.Open(frame.Path))
            {
                long length = stream.Length;
                if (length < frame.Bytes)
                {
                    throw new SequenceException(FormattableString.Invariant($"was cut: it has {length} of {frame.Bytes} bytes"));
                }
                if (length > frame.Bytes)
                {
                    throw new SequenceException(
                        FormattableString.Invariant($"has {length} bytes, more than the {frame.Bytes} that it should have"));
                }
                int read = BoundedFile.Fill(stream, bytes, (int)length);
                if (read < length)
                {
                    throw new SequenceException(FormattableString.Invariant($"was cut: it has {read} of {frame.Bytes} bytes"));
                }
                return new ReadOnlySpan<byte>(bytes, 0, read);
            }
        }

        private void Place(Span<StoredParticle> particles)
        {
            if (axes == FluidSequenceAxes.AsUnity && scale == 1f) return;
            for (int i = 0; i < particles.Length; i++)
            {
                ref StoredParticle particle = ref particles[i];
                (float px, float py, float pz) = (particle.Position.x, particle.Position.y, particle.Position.z);
                (float vx, float vy, float vz) = (particle.Velocity.x, particle.Velocity.y, particle.Velocity.z);
                if (axes == FluidSequenceAxes.RightHandedYUp) (pz, vz) = (-pz, -vz);
                else if (axes == FluidSequenceAxes.RightHandedZUp) (py, pz, vy, vz) = (pz, py, vz, vy);
                particle.Position.Set(scale * px, scale * py, scale * pz);
                particle.Velocity.Set(scale * vx, scale * vy, scale * vz);
            }
        }
    }
}
