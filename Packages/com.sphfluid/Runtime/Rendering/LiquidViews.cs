using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// Makes surfaces for the cameras that see them. What an enabled camera sees, or its shadow, or a reflection probe may show, is made
    /// when it is drawn. The rest waits for cameras that begin to draw later in the frame: those of the Scene view, those that
    /// scripts render, switch on or turn after the liquid. What nobody sees is not made.
    /// </summary>
    internal static class LiquidViews
    {
        private static readonly List<SurfaceSource> sources = new List<SurfaceSource>();
        private static readonly Dictionary<SurfaceSource, (DrawPlacement Placement, int Frame)> waiting =
            new Dictionary<SurfaceSource, (DrawPlacement, int)>();
        private static readonly List<SurfaceSource> seen = new List<SurfaceSource>();
        private static Camera[] cameras = new Camera[4];

        /// <summary>Listens to cameras while there are surfaces.</summary>
        public static void Add(SurfaceSource source)
        {
            if (sources.Count == 0)
            {
                Camera.onPreCull += Prepare;
                RenderPipelineManager.beginCameraRendering += PrepareScriptable;
            }
            sources.Add(source);
        }

        /// <summary>Forgets a surface.</summary>
        public static void Remove(SurfaceSource source)
        {
            waiting.Remove(source);
            if (!sources.Remove(source) || sources.Count > 0) return;
            Camera.onPreCull -= Prepare;
            RenderPipelineManager.beginCameraRendering -= PrepareScriptable;
            System.Array.Clear(cameras, 0, cameras.Length);
        }

        /// <summary>Makes a requested surface that is drawn in this frame, now or when the first camera sees it.</summary>
        public static void Show(SurfaceSource source, in DrawPlacement placement)
        {
            waiting.Remove(source);
            if (IsSeen(placement))
                source.Make();
            else
                waiting.Add(source, (placement, Time.frameCount));
        }

        /// <summary>Makes the surfaces that a camera, which is about to draw, sees and no other before it did.</summary>
        public static void Prepare(Camera camera)
        {
            foreach (KeyValuePair<SurfaceSource, (DrawPlacement Placement, int Frame)> entry in waiting)
            {
                if (entry.Value.Frame == Time.frameCount && IsSeenBy(camera, entry.Value.Placement)) seen.Add(entry.Key);
            }
            foreach (SurfaceSource source in seen)
            {
                waiting.Remove(source);
                source.Make();
            }
            seen.Clear();
        }

        /// <summary>Whether a camera may show a drawing or a shadow of it.</summary>
        public static bool IsSeenBy(Camera camera, in DrawPlacement placement)
        {
            if ((camera.cullingMask & (1 << placement.Layer)) == 0) return false;
            var volume = new ViewVolume(camera);
            return volume.Touches(placement.WorldBounds) || (placement.CastShadows && IsShadowSeen(volume, placement.WorldBounds));
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void ResetStatics()
        {
            while (sources.Count > 0) Remove(sources[0]);
            seen.Clear();
        }

        private static void PrepareScriptable(ScriptableRenderContext context, Camera camera) => Prepare(camera);

        /// <summary>Whether an enabled camera may show a drawing or a shadow of it, or a reflection probe.</summary>
        public static bool IsSeen(in DrawPlacement placement)
        {
            if (cameras.Length < Camera.allCamerasCount) cameras = new Camera[Camera.allCamerasCount];
            int count = Camera.GetAllCameras(cameras);
            for (int i = 0; i < count; i++)
            {
                if (IsSeenBy(cameras[i], placement)) return true;
            }
            return IsMirrored(placement.Layer);
        }

        // Shadows run on along a directional light without end. What other lights reach counts as seen.
        private static bool IsShadowSeen(in ViewVolume volume, Bounds bounds)
        {
            foreach (Light light in SceneObjects.All<Light>())
            {
                if (!light.isActiveAndEnabled || light.shadows == LightShadows.None) continue;
                bool reaches = light.type == LightType.Directional
                    ? volume.Touches(bounds, light.transform.forward)
                    : bounds.SqrDistance(light.transform.position) <= light.range * light.range;
                if (reaches) return true;
            }
            return false;
        }

        // Probes that are drawn while playing do not announce their cameras in every render pipeline.
        private static bool IsMirrored(int layer)
        {
            foreach (ReflectionProbe probe in SceneObjects.All<ReflectionProbe>())
            {
                if (probe.isActiveAndEnabled && probe.mode == ReflectionProbeMode.Realtime && (probe.cullingMask & (1 << layer)) != 0)
                {
                    return true;
                }
            }
            return false;
        }
    }
}
