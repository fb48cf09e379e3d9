using System;
using System.Collections.Generic;
using UnityEngine;

namespace SphFluid
{
    /// <summary>One frame of a sequence, as it should be found on disk.</summary>
    internal readonly struct SequenceFrame
    {
        public SequenceFrame(string path, double time, long particles, long bytes, uint? crc)
        {
            Path = path;
            Time = time;
            Particles = particles;
            Bytes = bytes;
            Crc = crc;
        }

        /// <summary>The file.</summary>
        public string Path { get; }

        /// <summary>Name of the file, for messages.</summary>
        public string Name => System.IO.Path.GetFileName(Path);

        /// <summary>Its time [s].</summary>
        public double Time { get; }

        /// <summary>Number of particles.</summary>
        public long Particles { get; }

        /// <summary>Length of the file.</summary>
        public long Bytes { get; }

        /// <summary>CRC-32 of the file; null where nobody wrote one down.</summary>
        public uint? Crc { get; }
    }

    /// <summary>A folder of particle files, one a frame: what is in it, as far as it is known without reading the particles.</summary>
    internal sealed class ParticleSequence
    {
        /// <param name="folder">The folder.</param>
        /// <param name="frames">The frames in the order of their times, one or more.</param>
        /// <param name="hasIds">Whether particles have numbers, by which they are found again.</param>
        /// <param name="hasVelocities">Whether they have velocities.</param>
        public ParticleSequence(string folder, IReadOnlyList<SequenceFrame> frames, bool hasIds, bool hasVelocities)
        {
            Folder = folder;
            Frames = frames;
            HasIds = hasIds;
            HasVelocities = hasVelocities;
            foreach (SequenceFrame frame in frames)
            {
                MostParticles = Math.Max(MostParticles, frame.Particles);
                MostBytes = Math.Max(MostBytes, frame.Bytes);
            }
        }

        /// <summary>The folder.</summary>
        public string Folder { get; }

        /// <summary>The frames, in the order of their times.</summary>
        public IReadOnlyList<SequenceFrame> Frames { get; }

        /// <summary>Whether particles have numbers.</summary>
        public bool HasIds { get; }

        /// <summary>Whether particles have velocities.</summary>
        public bool HasVelocities { get; }

        /// <summary>The particle spacing that it was made with [m]; 0 where that is not known.</summary>
        public float Spacing { get; set; }

        /// <summary>Edge lengths of the domain that it was made in [m]; 0 where they are not known.</summary>
        public Vector3 DomainSize { get; set; }

        /// <summary>Who made it; empty where that is not known.</summary>
        public string Source { get; set; } = "";

        /// <summary>Most particles of a frame.</summary>
        public long MostParticles { get; }

        /// <summary>Length of the longest file.</summary>
        public long MostBytes { get; }

        /// <summary>Time of the first frame [s].</summary>
        public double Start => Frames[0].Time;

        /// <summary>Time from the first frame to the last [s].</summary>
        public double Duration => Frames[Frames.Count - 1].Time - Start;

        /// <summary>The last frame that is not after a time, by halving; the first where all are.</summary>
        /// <param name="time">The time [s].</param>
        public int FrameAt(double time)
        {
            int low = 0, high = Frames.Count - 1;
            while (low < high)
            {
                int middle = (low + high + 1) / 2;
                if (Frames[middle].Time <= time) low = middle;
                else high = middle - 1;
            }
            return low;
        }
    }
}
