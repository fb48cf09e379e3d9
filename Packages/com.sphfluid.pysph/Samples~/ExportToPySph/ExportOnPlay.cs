using System.Collections.Generic;
using System.IO;
using UnityEngine;

namespace SphFluid.Samples
{
    /// <summary>
    /// Exports the liquids of the scene as cases of PySPH, with the motion that colliders have during the first moments of play.
    /// </summary>
    public sealed class ExportOnPlay : MonoBehaviour
    {
        [SerializeField, Min(0.1f), Tooltip("Time that PySPH is to compute, in seconds.")] private float seconds = 0.5f;

        private FluidExportRecorder recorder;

        private void Start()
        {
            var options = new FluidExportOptions { Seconds = seconds, FrameRate = 30.0 };
            recorder = FluidExportRecorder.Begin(new List<FluidSimulation>(FluidSimulation.Active), options, Write);
        }

        private void OnDestroy() => recorder?.Dispose();

        private static void Write(IReadOnlyList<FluidExport> exports)
        {
            for (int i = 0; i < exports.Count; i++)
            {
                foreach (FluidMessage message in exports[i].Messages) message.Log();
                if (!exports[i].HasLiquid) continue;
                string folder = Path.Combine(Application.temporaryCachePath, "Export to PySPH", $"{i}");
                exports[i].Write(folder);
                Debug.Log(
                    $"{exports[i].ParticleCount} particles of liquid and {exports[i].WallParticleCount} of walls are exported. Run them: " +
                    $"bash '{folder}/run.sh'");
            }
        }
    }
}
