using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace SphFluid
{
    /// <summary>The Built-in pipeline: a command buffer on each camera copies its picture before transparent things are drawn.</summary>
    internal sealed class BuiltInSceneTextures : ISceneTextureSource
    {
        private const CameraEvent Moment = CameraEvent.BeforeForwardAlpha;

        private readonly Dictionary<Camera, Before> cameras = new Dictionary<Camera, Before>();
        private readonly List<Camera> destroyed = new List<Camera>();
        private CommandBuffer copy;

        /// <summary>Cameras that are served; destroyed ones are forgotten with the next new one.</summary>
        public int Count => cameras.Count;

        public RendererLimit Limit => RendererLimit.None;

        public SceneTextures Request(Camera camera)
        {
            if (!cameras.ContainsKey(camera)) Attach(camera);
            camera.depthTextureMode |= DepthTextureMode.Depth;
            return new SceneTextures(SceneColourSource.Copy, true);
        }

        /// <summary>
        /// Records what a camera that is about to draw copies: its picture so far with caustics, and the spray and whitewater that it sees.
        /// </summary>
        public void RecordCopy(Camera camera)
        {
            copy.Clear();
            WaterCaustics.Record(copy, camera);
            var target = new RenderTargetIdentifier(RenderShaderIds.FluidSceneColour);
            if (EyeDraws.TryGetPicture(camera, out RenderTextureDescriptor both))
            {
                both.depthBufferBits = 0;
                both.msaaSamples = 1;
                both.colorFormat = RenderTextureFormat.DefaultHDR;
                copy.GetTemporaryRT(RenderShaderIds.FluidSceneColour, both, FilterMode.Bilinear);
                target = new RenderTargetIdentifier(target, 0, CubemapFace.Unknown, RenderTargetIdentifier.AllDepthSlices);
            }
            else
            {
                copy.GetTemporaryRT(RenderShaderIds.FluidSceneColour, -1, -1, 0, FilterMode.Bilinear, RenderTextureFormat.DefaultHDR);
            }
            copy.Blit(BuiltinRenderTextureType.CurrentActive, target);
            copy.SetRenderTarget(target);
            WaterCameras.RecordBehind(copy, camera, camera.pixelHeight);
        }

        public void Release()
        {
            foreach (KeyValuePair<Camera, Before> entry in cameras)
            {
                Camera camera = entry.Key;
                if (camera == null) continue;
                camera.RemoveCommandBuffer(Moment, copy);
                camera.forceIntoRenderTexture = entry.Value.IntoTexture;
                if (!entry.Value.Depth) camera.depthTextureMode &= ~DepthTextureMode.Depth;
            }
            cameras.Clear();
            copy?.Dispose();
            copy = null;
        }

        // Copies of the screen itself may lie upside down; of a texture they never do.
        private void Attach(Camera camera)
        {
            ForgetDestroyed();
            copy = copy ?? new CommandBuffer { name = "Fluid Scene Colour" };
            cameras.Add(camera, new Before
            {
                IntoTexture = camera.forceIntoRenderTexture,
                Depth = (camera.depthTextureMode & DepthTextureMode.Depth) != 0,
            });
            camera.forceIntoRenderTexture = true;
            camera.AddCommandBuffer(Moment, copy);
        }

        // A scene that makes and destroys cameras would otherwise fill the table.
        private void ForgetDestroyed()
        {
            foreach (Camera camera in cameras.Keys)
                if (camera == null) destroyed.Add(camera);
            foreach (Camera camera in destroyed) cameras.Remove(camera);
            destroyed.Clear();
        }

        // What a camera was like before.
        private struct Before
        {
            public bool IntoTexture;
            public bool Depth;
        }
    }
}
