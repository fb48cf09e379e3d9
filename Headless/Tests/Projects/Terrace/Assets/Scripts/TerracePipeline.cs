using UnityEngine;
using UnityEngine.Rendering;

namespace Terrace
{
    /// <summary>One sun with one shadow map, opaque things, the sky, transparent things.</summary>
    public sealed class TerracePipeline : RenderPipeline
    {
        private static readonly ShaderTagId Pass = new ShaderTagId("Terrace");
        private static readonly int ShadowMap = Shader.PropertyToID("_TerraceShadows");
        private static readonly int WorldToShadow = Shader.PropertyToID("_TerraceWorldToShadow");
        private static readonly int SunColor = Shader.PropertyToID("_TerraceSunColor");

        private readonly CommandBuffer commands = new CommandBuffer { name = "Terrace" };
        private readonly RenderTexture shadows;
        private readonly float shadowDistance;

        public TerracePipeline(TerracePipelineAsset asset)
        {
            GraphicsSettings.lightsUseLinearIntensity = true;
            shadowDistance = asset.shadowDistance;
            shadows = new RenderTexture(asset.shadowResolution, asset.shadowResolution, 32, RenderTextureFormat.Shadowmap) { name = "Terrace shadows" };
        }

        protected override void Render(ScriptableRenderContext context, Camera[] cameras)
        {
            BeginFrameRendering(context, cameras);
            foreach (Camera camera in cameras)
            {
                BeginCameraRendering(context, camera);
                Draw(context, camera);
                EndCameraRendering(context, camera);
                context.Submit();
            }

            EndFrameRendering(context, cameras);
        }

        protected override void Dispose(bool disposing)
        {
            commands.Release();
            shadows.Release();
        }

        private void Draw(ScriptableRenderContext context, Camera camera)
        {
            if (!camera.TryGetCullingParameters(out ScriptableCullingParameters culling)) return;
            culling.shadowDistance = Mathf.Min(shadowDistance, camera.farClipPlane);
            CullingResults culled = context.Cull(ref culling);
            DrawShadows(context, culled);

            context.SetupCameraProperties(camera);
            commands.ClearRenderTarget(true, camera.clearFlags == CameraClearFlags.SolidColor, camera.backgroundColor.linear);
            Execute(context);
            DrawThings(context, camera, culled, SortingCriteria.CommonOpaque, RenderQueueRange.opaque);
            commands.DrawRendererList(context.CreateSkyboxRendererList(camera));
            DrawThings(context, camera, culled, SortingCriteria.CommonTransparent, RenderQueueRange.transparent);
        }

        private void DrawShadows(ScriptableRenderContext context, CullingResults culled)
        {
            commands.SetRenderTarget(shadows);
            commands.ClearRenderTarget(true, false, Color.clear);
            if (culled.visibleLights.Length > 0 && culled.visibleLights[0].lightType == LightType.Directional)
            {
                commands.SetGlobalVector(SunColor, culled.visibleLights[0].finalColor);
                if (culled.ComputeDirectionalShadowMatricesAndCullingPrimitives(
                    0, 0, 1, Vector3.one, shadows.width, 0f, out Matrix4x4 view, out Matrix4x4 projection, out ShadowSplitData split))
                {
                    var settings = new ShadowDrawingSettings(culled, 0) { splitData = split };
                    commands.SetViewProjectionMatrices(view, projection);
                    commands.SetGlobalDepthBias(1f, 2.5f);
                    commands.DrawRendererList(context.CreateShadowRendererList(ref settings));
                    commands.SetGlobalDepthBias(0f, 0f);
                    commands.SetGlobalMatrix(WorldToShadow, ToTexture(projection * view));
                }
            }

            commands.SetGlobalTexture(ShadowMap, shadows);
            Execute(context);
        }

        private void DrawThings(ScriptableRenderContext context, Camera camera, CullingResults culled, SortingCriteria order, RenderQueueRange queues)
        {
            var drawing = new DrawingSettings(Pass, new SortingSettings(camera) { criteria = order });
            var list = new RendererListParams(culled, drawing, new FilteringSettings(queues));
            commands.DrawRendererList(context.CreateRendererList(ref list));
            Execute(context);
        }

        private void Execute(ScriptableRenderContext context)
        {
            context.ExecuteCommandBuffer(commands);
            commands.Clear();
        }

        private static Matrix4x4 ToTexture(Matrix4x4 matrix)
        {
            if (SystemInfo.usesReversedZBuffer) matrix.SetRow(2, -matrix.GetRow(2));
            return Matrix4x4.Translate(Vector3.one * 0.5f) * Matrix4x4.Scale(Vector3.one * 0.5f) * matrix;
        }
    }
}
