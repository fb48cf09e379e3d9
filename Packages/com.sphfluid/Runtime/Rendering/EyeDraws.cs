using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;
#if SPHFLUID_VR
using UnityEngine.XR;
#endif

namespace SphFluid
{
    /// <summary>
    /// Draws for cameras that show both eyes at once (single-pass instanced). Unity doubles the instances of ordinary draws for them, but
    /// not of draws whose arguments lie in a buffer: those reach the left eye, and are issued once more for the right one, as
    /// Shaders/Rendering/Eyes.hlsl has it. Without the module VR there are no such cameras.
    /// </summary>
    internal static class EyeDraws
    {
        [OutlivesPlay("found anew before each draw")] private static readonly List<Camera> cameras = new List<Camera>();
#if SPHFLUID_VR
        [OutlivesPlay("emptied after each search")] private static Camera[] found = new Camera[4];
#endif

        /// <summary>The picture that both eyes of a camera are drawn into.</summary>
        /// <returns>False for other cameras.</returns>
        public static bool TryGetPicture(Camera camera, out RenderTextureDescriptor picture)
        {
            picture = default;
#if SPHFLUID_VR
            if (!camera.stereoEnabled || !XRSettings.enabled) return false;
            picture = XRSettings.eyeTextureDesc;
            return picture.dimension == TextureDimension.Tex2DArray && picture.volumeDepth > 1;
#else
            return false;
#endif
        }

        /// <summary>Finds the enabled cameras that draw both eyes at once.</summary>
        /// <returns>How often something has to be drawn: once, and once more for each of them.</returns>
        public static int Begin()
        {
            cameras.Clear();
#if SPHFLUID_VR
            if (!XRSettings.enabled) return 1;
            if (found.Length < Camera.allCamerasCount) found = new Camera[Camera.allCamerasCount];
            int count = Camera.GetAllCameras(found);
            for (int i = 0; i < count; i++)
            {
                if (TryGetPicture(found[i], out _)) cameras.Add(found[i]);
            }
            System.Array.Clear(found, 0, count);
#endif
            return 1 + cameras.Count;
        }

        /// <summary>What has to be drawn at one of those times: the first for all cameras, the others for a right eye.</summary>
        public static RenderParams Of(RenderParams parameters, int time)
        {
            if (cameras.Count == 0) return parameters;
            parameters.matProps.SetFloat(RenderShaderIds.FluidEye, time > 0 ? 1f : 0f);
            if (time == 0) return parameters;
            parameters.camera = cameras[time - 1];
            parameters.shadowCastingMode = ShadowCastingMode.Off;
            return parameters;
        }
    }
}
