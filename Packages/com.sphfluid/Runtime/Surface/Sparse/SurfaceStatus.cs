using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>What became of a sparse surface, as the GPU counted it; a few frames old.</summary>
    public readonly struct SurfaceStatus
    {
        internal SurfaceStatus(uint[] counters)
        {
            Blocks = (int)counters[SurfaceCounters.BlocksRequested];
            LateBlocks = (int)counters[SurfaceCounters.BlocksLate];
            Vertices = counters[SurfaceCounters.VerticesRequested];
            Triangles = counters[SurfaceCounters.IndicesRequested] / 3;
            OpenFaces = (int)counters[SurfaceCounters.OpenFaces];
            NonFiniteParticles = (int)counters[SurfaceCounters.NonFinite];
            Number = (int)counters[SurfaceCounters.Number];
            IsComplete = counters[SurfaceCounters.Complete] != 0;
        }

        /// <summary>Blocks near the surface, whether they fitted or not.</summary>
        public int Blocks { get; }

        /// <summary>Blocks among them that only their neighbours' surface led to; none is expected.</summary>
        public int LateBlocks { get; }

        /// <summary>Vertices that the surface has; 0 while its blocks do not fit.</summary>
        public long Vertices { get; }

        /// <summary>Triangles that the surface has; 0 while its blocks do not fit.</summary>
        public long Triangles { get; }

        /// <summary>Faces of blocks where the surface ends; none is expected.</summary>
        public int OpenFaces { get; }

        /// <summary>Particles that were skipped because their position is not a number.</summary>
        public int NonFiniteParticles { get; }

        /// <summary>Which recording this is about: 1 for a surface's first.</summary>
        internal int Number { get; }

        /// <summary>Whether all of it fitted the buffers. If not, the last complete surface is still drawn.</summary>
        public bool IsComplete { get; }
    }

    /// <summary>What a user must know about a sparse surface: each kind of problem is reported once.</summary>
    internal sealed class SurfaceWarnings
    {
        private readonly Queue<string> pending = new Queue<string>();
        private bool obstacleReported;
        private bool gapsReported;
        private bool nonFiniteReported;

        /// <summary>The next sentence that nobody took; null when there is none.</summary>
        public string Dequeue() => pending.Count > 0 ? pending.Dequeue() : null;

        /// <param name="status">A surface that was read back.</param>
        /// <param name="obstacle">Why it will not fit, or null.</param>
        public void Check(in SurfaceStatus status, string obstacle)
        {
            if (!status.IsComplete && obstacle != null)
            {
                Report(ref obstacleReported, obstacle + " Until then the last complete surface stays.");
            }
            if (status.OpenFaces > 0)
            {
                Report(ref gapsReported,
                    $"The surface has gaps at {status.OpenFaces} faces between its blocks: no particle was found near them. " +
                    "Choose smaller cells, and please report the scene, as this should not happen.");
            }
            if (status.NonFiniteParticles > 0)
            {
                Report(ref nonFiniteReported,
                    $"The surface skips {status.NonFiniteParticles} particles whose position is not a number. " +
                    "Add a Fluid Diagnostics component to find out why, or choose a smaller time step.");
            }
        }

        private void Report(ref bool reported, string sentence)
        {
            if (reported) return;
            reported = true;
            pending.Enqueue(sentence);
        }
    }
}
