using UnityEngine;

namespace SphFluid
{
    /// <summary>Calls a recorder once a frame, after the liquids.</summary>
    [AddComponentMenu("")]
    [DefaultExecutionOrder(300)]
    internal sealed class FluidExportFrames : MonoBehaviour
    {
        private FluidExportRecorder recorder;

        public static FluidExportFrames Begin(FluidExportRecorder recorder)
        {
            var holder = new GameObject("Fluid Export") { hideFlags = HideFlags.HideAndDontSave };
            DontDestroyOnLoad(holder);
            var frames = holder.AddComponent<FluidExportFrames>();
            frames.recorder = recorder;
            return frames;
        }

        private void LateUpdate() => recorder.Advance();
    }
}
