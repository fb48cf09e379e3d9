using System.Collections.Generic;

namespace SphFluid
{
    /// <summary>What a user must know about a sparse surface: each kind of trouble is told once.</summary>
    sealed class SurfaceWarnings
    {
        readonly Queue<string> untold = new Queue<string>();
        bool capReported;
        bool openReported;
        bool nonFiniteReported;

        /// <summary>The next sentence that nobody took; null when there is none.</summary>
        public string Take() => untold.Count > 0 ? untold.Dequeue() : null;

        /// <param name="status">A surface that was read back.</param>
        /// <param name="obstacle">Why it will not fit, or null.</param>
        public void Check(in SurfaceStatus status, string obstacle)
        {
            if (!status.IsComplete && obstacle != null)
                Tell(ref capReported, obstacle + " Until then the last complete surface stays.");
            if (status.OpenFaces > 0)
            {
                Tell(ref openReported, $"The surface has gaps at {status.OpenFaces} faces between its blocks, where no particle was found near. Smaller cells close them; " +
                    "please report the scene, as this should not happen.");
            }
            if (status.NonFiniteParticles > 0)
            {
                Tell(ref nonFiniteReported, $"The surface passes over {status.NonFiniteParticles} particles whose position is not a number. " +
                    "Add a Fluid Diagnostics component to find out why, or choose a smaller time step.");
            }
        }

        void Tell(ref bool told, string sentence)
        {
            if (told)
                return;
            told = true;
            untold.Enqueue(sentence);
        }
    }
}
