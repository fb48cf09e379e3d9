using System.IO;
using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>Records the first moments of a liquid into a temporary folder, and plays them from then on, to and fro.</summary>
    [RequireComponent(typeof(FluidPlayback))]
    public sealed class RecordAndPlay : MonoBehaviour
    {
        [SerializeField, Min(0.1f), Tooltip("Time that is recorded, in seconds.")] float seconds = 1f;

        FluidPlayback playback;
        FluidSimulation liquid;
        FluidSequenceWriter writer;
        string folder;
        double written = double.NegativeInfinity;

        void Start()
        {
            playback = GetComponent<FluidPlayback>();
            liquid = GetComponent<FluidSimulation>();
            folder = Path.Combine(Application.temporaryCachePath, Path.GetRandomFileName());
            writer = new FluidSequenceWriter(folder, liquid.DomainSize, liquid.Spacing, "the sample Record and Play");
            liquid.Updated += Record;
        }

        void OnDestroy()
        {
            if (folder == null) return;
            liquid.Updated -= Record;
            if (playback != null) playback.enabled = false; // closes the files
            writer.Dispose();
            Directory.Delete(folder, true);
        }

        void Record(FluidSimulation _)
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
