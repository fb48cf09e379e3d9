using UnityEngine.Rendering.RenderGraphModule;

namespace UnityEngine.Rendering.Universal;

/// <summary>The camera's matrices and sizes, again after shadow maps have used the same names.</summary>
internal static class CameraProperties
{
    private static readonly int WorldSpaceCameraPos = Shader.PropertyToID("_WorldSpaceCameraPos");
    private static readonly int ScreenParams = Shader.PropertyToID("_ScreenParams");
    private static readonly int ScaledScreenParams = Shader.PropertyToID("_ScaledScreenParams");
    private static readonly int ScreenSize = Shader.PropertyToID("_ScreenSize");
    private static readonly int ZBufferParams = Shader.PropertyToID("_ZBufferParams");
    private static readonly int OrthoParams = Shader.PropertyToID("unity_OrthoParams");
    private static readonly int ProjectionParams = Shader.PropertyToID("_ProjectionParams");
    private static readonly int MipBias = Shader.PropertyToID("_GlobalMipBias");
    private static readonly int HandleScale = Shader.PropertyToID("_RTHandleScale");
    private static readonly int WorldToCamera = Shader.PropertyToID("unity_WorldToCamera");
    private static readonly int CameraToWorld = Shader.PropertyToID("unity_CameraToWorld");
    private static readonly int InverseView = Shader.PropertyToID("unity_MatrixInvV");
    private static readonly int InverseProjection = Shader.PropertyToID("unity_MatrixInvP");
    private static readonly int InverseViewProjection = Shader.PropertyToID("unity_MatrixInvVP");
    private static readonly int TimeParameters = Shader.PropertyToID("_TimeParameters");
    private static readonly int LastTimeParameters = Shader.PropertyToID("_LastTimeParameters");

    public static void Record(RenderGraph graph, ContextContainer frame)
    {
        using IUnsafeRenderGraphBuilder builder = graph.AddUnsafePass("Setup Camera Properties", out Data data);
        data.Camera = frame.Get<UniversalCameraData>();
        data.Target = frame.Get<UniversalResourceData>().activeColorTexture;
        builder.AllowPassCulling(false);
        builder.AllowGlobalStateModification(true);
        builder.SetRenderFunc(static (Data d, UnsafeGraphContext context) => Set(context.cmd, d));
    }

    private static void Set(UnsafeCommandBuffer cmd, Data data)
    {
        UniversalCameraData camera = data.Camera;
        if (camera.renderType == CameraRenderType.Base)
        {
            cmd.SetupCameraProperties(camera.camera);
        }

        cmd.SetRenderTarget(data.Target);
        SetVectors(cmd, camera);
        SetTime(cmd);
        Matrix4x4 view = camera.GetViewMatrix();
        cmd.SetViewProjectionMatrices(view, camera.GetProjectionMatrix());
        Matrix4x4 worldToCamera = Matrix4x4.Scale(new Vector3(1f, 1f, -1f)) * view;
        Matrix4x4 inverseProjection = camera.GetGPUProjectionMatrix().inverse;
        cmd.SetGlobalMatrix(WorldToCamera, worldToCamera);
        cmd.SetGlobalMatrix(CameraToWorld, worldToCamera.inverse);
        cmd.SetGlobalMatrix(InverseView, view.inverse);
        cmd.SetGlobalMatrix(InverseProjection, inverseProjection);
        cmd.SetGlobalMatrix(InverseViewProjection, view.inverse * inverseProjection);
    }

    private static void SetVectors(UnsafeCommandBuffer cmd, UniversalCameraData data)
    {
        Camera camera = data.camera;
        bool isOverlay = data.renderType == CameraRenderType.Overlay;
        (float width, float height) = isOverlay ? (data.PixelWidth, data.PixelHeight) : ((float)camera.pixelWidth, camera.pixelHeight);
        (float targetWidth, float targetHeight) = (data.cameraTargetDescriptor.width, data.cameraTargetDescriptor.height);
        (float near, float far) = (camera.nearClipPlane, camera.farClipPlane);
        cmd.SetGlobalVector(WorldSpaceCameraPos, data.worldSpaceCameraPos);
        cmd.SetGlobalVector(ScreenParams, new Vector4(width, height, 1f + (1f / width), 1f + (1f / height)));
        cmd.SetGlobalVector(ScaledScreenParams, new Vector4(targetWidth, targetHeight, 1f + (1f / targetWidth), 1f + (1f / targetHeight)));
        cmd.SetGlobalVector(ScreenSize, new Vector4(targetWidth, targetHeight, 1f / targetWidth, 1f / targetHeight));

        // With reversed depth: 1 / (z x + y) is the linear depth from 0 at the camera to 1 at the far plane.
        cmd.SetGlobalVector(ZBufferParams, new Vector4((far / near) - 1f, 1f, ((far / near) - 1f) / far, 1f / far));
        cmd.SetGlobalVector(
            OrthoParams,
            new Vector4(camera.orthographicSize * data.AspectRatio, camera.orthographicSize, 0f, camera.orthographic ? 1f : 0f));
        if (isOverlay)
        {
            cmd.SetGlobalVector(ProjectionParams, new Vector4(data.IsCameraProjectionMatrixFlipped() ? -1f : 1f, near, far, 1f / far));
        }

        float bias = Mathf.Min(-Mathf.Log(width / targetWidth, 2f), 0f);
        cmd.SetGlobalVector(MipBias, new Vector2(bias, Mathf.Pow(2f, bias)));
        cmd.SetGlobalVector(HandleScale, Vector4.one);
    }

    private static void SetTime(UnsafeCommandBuffer cmd)
    {
        float time = Time.time;
        float last = time - Time.deltaTime;
        cmd.SetGlobalVector(TimeParameters, new Vector4(time, Mathf.Sin(time), Mathf.Cos(time), 0f));
        cmd.SetGlobalVector(LastTimeParameters, new Vector4(last, Mathf.Sin(last), Mathf.Cos(last), 0f));
    }

    private sealed class Data
    {
        public UniversalCameraData Camera { get; set; } = null!;
        public TextureHandle Target { get; set; }
    }
}
