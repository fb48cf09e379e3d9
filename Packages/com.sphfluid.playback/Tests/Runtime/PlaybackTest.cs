using System.Linq;
using NUnit.Framework;
using UnityEngine;

namespace SphFluid.Tests
{
    /// <summary>A simulation with a Fluid Playback, and files for it.</summary>
    public abstract class PlaybackTest
    {
        protected const float Frame = 1f / 64f;
        protected const object First = null; // the first frame of a test has a time of its own

        private protected SimulationRig rig;
        private protected SequenceFiles files;
        protected FluidSimulation simulation;
        protected FluidPlayback playback;

        [SetUp]
        public void SetUp()
        {
            rig = new SimulationRig(Frame);
            files = new SequenceFiles();
        }

        [TearDown]
        public void TearDown()
        {
            rig.Dispose();
            files.Dispose();
        }

        // One particle that goes a hundredth of a metre a frame, or a thousandth in long sequences.
        protected void WriteDrift(int frames, float interval)
        {
            float step = frames < 50 ? 0.01f : 0.001f;
            files.Write(Enumerable.Range(0, frames).Select(i => i * (double)interval).ToArray(),
                i => new[] { new FluidParticle(new Vector3(step * i, 0f, 0f), new Vector3(step / interval, 0f, 0f), 5u) },
                0.4f * Vector3.one, SimulationRig.Spacing);
        }

        protected void Open(float spacing = SimulationRig.Spacing, float speed = 1f, FluidPlaybackLoop loop = FluidPlaybackLoop.None,
            float domain = 0.4f)
        {
            simulation = rig.Create("Playback", liquid: false);
            simulation.Spacing = spacing;
            simulation.DomainSize = domain * Vector3.one;
            playback = simulation.gameObject.AddComponent<FluidPlayback>();
            playback.Folder = files.Folder;
            playback.Speed = speed;
            playback.Loop = loop;
        }

        protected float CentreX()
        {
            FluidParticle[] particles = SimulationRig.Read(simulation);
            return particles.Length == 0 ? float.NaN : particles.Average(p => p.Position.x);
        }
    }
}
