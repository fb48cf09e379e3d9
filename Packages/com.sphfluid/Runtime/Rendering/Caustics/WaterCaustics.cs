using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The liquids with caustics, for the cameras that see them.</summary>
    internal static class WaterCaustics
    {
        private static readonly List<CausticsDrawing> drawings = new List<CausticsDrawing>();

        /// <summary>How many liquids have them.</summary>
        public static int Count => drawings.Count;

        public static void Add(CausticsDrawing drawing) => drawings.Add(drawing);

        public static void Remove(CausticsDrawing drawing) => drawings.Remove(drawing);

        /// <summary>Whether a camera sees any in this frame.</summary>
        public static bool AreSeenBy(Camera camera)
        {
            foreach (CausticsDrawing drawing in drawings)
            {
                if (drawing.IsSeenBy(camera)) return true;
            }
            return false;
        }

        /// <summary>Records what a camera that is about to draw reads; leaves another render target and other matrices.</summary>
        public static void RecordMaps(CommandBuffer cmd, Camera camera)
        {
            foreach (CausticsDrawing drawing in drawings)
            {
                if (drawing.IsSeenBy(camera)) drawing.RecordMap(cmd);
            }
        }

        /// <summary>Records the light into the camera's picture, which is the render target and has its opaque things.</summary>
        public static void Record(CommandBuffer cmd, Camera camera)
        {
            foreach (CausticsDrawing drawing in drawings)
            {
                if (drawing.IsSeenBy(camera)) drawing.Record(cmd);
            }
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void ResetStatics() => drawings.Clear();
    }
}
