using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>
    /// The main light's shadows for the liquids that receive them. Of each camera that is about to draw it is said where its shadows come
    /// from: in the Built-in pipeline from the map that <see cref="KeptShadowMap"/> keeps, in the Universal Render Pipeline from its own
    /// variables. Listens to cameras only while there are receivers.
    /// </summary>
    internal static class MainLightShadows
    {
        // As ReceivedShadow.hlsl has them.
        internal const float None = 0f;
        internal const float Whole = 1f;
        internal const float ByDepth = 2f;
        internal const float BySpheres = 3f;
        internal const float Universal = 4f;

        private static readonly List<Object> receivers = new List<Object>();
        private static SceneLighting lighting;
        private static KeptShadowMap map;
        private static CommandBuffer cmd;

        /// <summary>Whether anything receives shadows.</summary>
        public static bool IsListening => receivers.Count > 0;

        /// <summary>The light whose shadow map is kept, in the Built-in pipeline; null where there is none.</summary>
        public static Light Light => map?.Light;

        /// <summary>Adds a receiver; one that is there already changes nothing.</summary>
        /// <exception cref="FluidDeviceException">A shader is missing, or the device cannot run it.</exception>
        public static void Add(Object receiver, FluidShaderSet shaders)
        {
            if (receivers.Contains(receiver)) return;
            if (receivers.Count == 0) Listen(shaders);
            receivers.Add(receiver);
        }

        /// <summary>Removes a receiver, if it is there. After the last nothing is left on any light.</summary>
        public static void Remove(Object receiver)
        {
            if (receivers.Remove(receiver) && receivers.Count == 0) StopListening();
        }

        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void ResetStatics()
        {
            while (IsListening) Remove(receivers[0]);
        }

        private static void Listen(FluidShaderSet shaders)
        {
            (map, lighting) = (new KeptShadowMap(shaders), new SceneLighting());
            cmd = new CommandBuffer { name = "Fluid Shadow Source" };
            Camera.onPreCull += PrepareBuiltIn;
            RenderPipelineManager.beginCameraRendering += PrepareScriptable;
        }

        private static void StopListening()
        {
            Camera.onPreCull -= PrepareBuiltIn;
            RenderPipelineManager.beginCameraRendering -= PrepareScriptable;
            map.Dispose();
            (map, lighting) = (null, null);
            cmd.Dispose();
            cmd = null;
            Shader.SetGlobalVector(RenderShaderIds.FluidShadowSource, Vector4.zero);
        }

        // Each camera has a map of its own, or none: the light then runs no commands, and everything is lit.
        private static void PrepareBuiltIn(Camera camera)
        {
            Shader.SetGlobalVector(RenderShaderIds.FluidShadowSource, Vector4.zero);
            map.Watch(lighting.MainLight());
        }

        // The pipeline sets the strength where it draws a map for this camera, and leaves it as it is where it does not.
        private static void PrepareScriptable(ScriptableRenderContext context, Camera camera)
        {
            bool universal = DrawPipeline.Active == DrawPipelineKind.Universal;
            map.Watch(null);
            cmd.Clear();
            cmd.SetGlobalVector(RenderShaderIds.FluidShadowSource, new Vector4(universal ? Universal : None, 0f, 0f, 0f));
            if (universal) cmd.SetGlobalVector(RenderShaderIds.MainLightShadowParams, Vector4.zero);
            context.ExecuteCommandBuffer(cmd);
        }
    }
}
