using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// What is drawn after the water, and into the picture of the scene that the water refracts too.
    /// </summary>
    internal interface IBehindWater
    {
        /// <summary>Whether there is something in this frame that a camera may show.</summary>
        bool IsSeenBy(Camera camera);

        /// <summary>Records it into the picture of the scene, which is the render target, with the camera's matrices.</summary>
        /// <param name="cmd">Where it is recorded.</param>
        /// <param name="eye">1 for the right eye of a camera that draws both at once, else 0.</param>
        void RecordBehindWater(CommandBuffer cmd, int eye);
    }
}
