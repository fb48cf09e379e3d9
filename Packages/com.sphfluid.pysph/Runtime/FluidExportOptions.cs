using System;

namespace SphFluid
{
    /// <summary>What an exported case computes and how it is run.</summary>
    public sealed class FluidExportOptions
    {
        /// <summary>Most frames of a case.</summary>
        public const int MostFrames = 1_000_000;

        /// <summary>Most processes that the scripts may ask for.</summary>
        public const int MostRanks = 1_000_000;

        /// <summary>Time that is computed [s], and over which colliders' motion is recorded; more than 0.</summary>
        public double Seconds { get; set; } = 2.0;

        /// <summary>Frames a second that are kept of it; more than 0.</summary>
        public double FrameRate { get; set; } = 30.0;

        /// <summary>Scheme that the case begins with.</summary>
        public FluidExportScheme Scheme { get; set; }

        /// <summary>Processes that the scripts start unless told otherwise; 1 or more.</summary>
        public int Ranks { get; set; } = 2;

        /// <summary>Name of the scene, for the case's heading; null: that of the liquid's own scene.</summary>
        public string Scene { get; set; }

        /// <summary>Commit of the project, for the manifest; null where none is known.</summary>
        public string Commit { get; set; }

        /// <summary>Checks that a case can be made of this.</summary>
        /// <exception cref="ArgumentException">A value is out of range; the message names it and the cure.</exception>
        internal void Validate()
        {
            if (!(Seconds > 0.0) || !(FrameRate > 0.0) || !(Seconds * FrameRate <= MostFrames))
            {
                throw new ArgumentException(FormattableString.Invariant(
                    $"Seconds is {Seconds} and FrameRate {FrameRate}; give both numbers above zero, with {MostFrames} frames at most."));
            }
            Require.Known(Scheme, nameof(Scheme));
            if (Ranks < 1 || Ranks > MostRanks) throw new ArgumentException($"Ranks is {Ranks}; give it a number from 1 to {MostRanks}.");
        }
    }
}
