namespace UnityEngine.Rendering.Universal;

public struct CameraData
{
    private readonly ContextContainer frame;

    internal CameraData(ContextContainer frameData) => frame = frameData;

    public readonly ref Camera camera => ref Data.camera;
    public readonly ref CameraRenderType renderType => ref Data.renderType;
    public readonly ref RenderTexture? targetTexture => ref Data.targetTexture;
    public readonly ref RenderTextureDescriptor cameraTargetDescriptor => ref Data.cameraTargetDescriptor;
    public readonly ref float renderScale => ref Data.renderScale;
    public readonly ref CameraType cameraType => ref Data.cameraType;
    public readonly ref bool isHdrEnabled => ref Data.isHdrEnabled;
    public readonly ref bool requiresDepthTexture => ref Data.requiresDepthTexture;
    public readonly ref bool requiresOpaqueTexture => ref Data.requiresOpaqueTexture;
    public readonly ref float maxShadowDistance => ref Data.maxShadowDistance;
    public readonly ref bool postProcessEnabled => ref Data.postProcessEnabled;
    public readonly ref bool resolveFinalTarget => ref Data.resolveFinalTarget;
    public readonly ref SortingCriteria defaultOpaqueSortFlags => ref Data.defaultOpaqueSortFlags;
    public readonly ref ScriptableRenderer renderer => ref Data.renderer;
    public readonly ref Vector3 worldSpaceCameraPos => ref Data.worldSpaceCameraPos;
    public readonly bool isSceneViewCamera => Data.isSceneViewCamera;
    public readonly bool isPreviewCamera => Data.isPreviewCamera;

    private readonly UniversalCameraData Data => frame.Get<UniversalCameraData>();

    public readonly Matrix4x4 GetViewMatrix(int viewIndex = 0) => Data.GetViewMatrix(viewIndex);

    public readonly Matrix4x4 GetProjectionMatrix(int viewIndex = 0) => Data.GetProjectionMatrix(viewIndex);

    public readonly Matrix4x4 GetGPUProjectionMatrix(int viewIndex = 0) => Data.GetGPUProjectionMatrix(viewIndex);

    public readonly bool IsCameraProjectionMatrixFlipped() => Data.IsCameraProjectionMatrixFlipped();
}
