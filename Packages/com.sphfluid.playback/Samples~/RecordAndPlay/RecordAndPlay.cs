using System.IO;
using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>Records the first moments of a liquid into a temporary folder, and plays them from then on, to and fro.</summary>
    [RequireComponent(typeof(FluidPlayback))]
    public sealed class RecordAndPlay : MonoBehaviour
    {
        [SerializeField, Min(0.1f), Tooltip("Time that is recorded, in seconds.")] private float seconds = 1f;

        private FluidPlayback playback;
        private FluidSimulation liquid;
        private FluidSequenceWriter writer;
        private string folder;
        private double written = double.NegativeInfinity;

        private void Start()
        {
            playback = GetComponent<FluidPlayback>();
            liquid = GetComponent<FluidSimulation>();
            folder = Path.Combine(Application.temporaryCachePath, Path.GetRandomFileName());
            writer = new FluidSequenceWriter(folder, liquid.DomainSize, liquid.Spacing, "the sample Record and Play");
            liquid.Updated += Record;
        }

        private void OnDestroy()
        {
            if (folder == null) return;
            liquid.Updated -= Record;
            if (playback != null) playback.enabled = false; // closes the files
            writer.Dispose();
            Directory.Delete(folder, true);
        }

        private void Record(FluidSimulation _)
        {
            if (liquid.SimulatedTime <= written) return; // no step in this frame
            written = liquid.SimulatedTime;
            writer.Write(liquid);
            if (written < seconds) return;
            liquid.Updated -= Record;
            writer.Dispose();
            playback.Folder = folder;
            playback.Loop = FluidPlaybackLoop.PingPong;
            playback.enabled = true;
        }
    }
}
