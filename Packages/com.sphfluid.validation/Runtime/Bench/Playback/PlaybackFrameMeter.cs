using System.Collections.Generic;
using System.Diagnostics;
using UnityEngine;

namespace SphFluid.Validation
{
    /// <summary>
    /// Takes what the playback and the simulation of an object take of each LateUpdate: begins before the one and ends when the other says
    /// that it is done.
    /// </summary>
    [AddComponentMenu("")]
    [DefaultExecutionOrder(39)]
    internal sealed class PlaybackFrameMeter : MonoBehaviour
    {
        private readonly Stopwatch clock = new Stopwatch();
        private FluidPlayback playback;
        private FluidSimulation simulation;
        private long steps;

        /// <summary>Frames, whatever they showed.</summary>
        public int Frames { get; private set; }

        /// <summary>Milliseconds of each frame that showed other particles; place for what is measured is made before.</summary>
        public List<double> Milliseconds { get; } = new List<double>(4096);

        /// <summary>Frames in which the particles stayed because the next ones were not read yet.</summary>
        public int Held { get; private set; }

        /// <summary>Forgets what was measured.</summary>
        public void Clear()
        {
            Milliseconds.Clear();
            Frames = Held = 0;
        }

        private void Start()
        {
            playback = GetComponent<FluidPlayback>();
            simulation = GetComponent<FluidSimulation>();
            simulation.Updated += _ => End();
        }

        private void LateUpdate() => clock.Restart();

        private void End()
        {
            double took = clock.Elapsed.TotalMilliseconds;
            Frames++;
            if (playback.IsBuffering) Held++;
            if (simulation.StepCount != steps) Milliseconds.Add(took);
            steps = simulation.StepCount;
        }
    }
}
