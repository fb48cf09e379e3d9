using System;

namespace UnityEngine.Rendering.Universal;

/// <summary>A camera as the pipeline draws it.</summary>
public class UniversalCameraData : ContextItem
{
    public Camera camera = null!;
    public Camera baseCamera = null!;
    public CameraType cameraType;
    public CameraRenderType renderType;
    public RenderTexture? targetTexture;
    public RenderTextureDescriptor cameraTargetDescriptor;
    public Color backgroundColor;
    public Vector3 worldSpaceCameraPos;
    public SortingCriteria defaultOpaqueSortFlags;
    public AntialiasingMode antialiasing;
    public AntialiasingQuality antialiasingQuality;
    public ScriptableRenderer renderer = null!;
    public LayerMask volumeLayerMask;
    public Transform? volumeTrigger;
    public float renderScale = 1f;
    public float maxShadowDistance;
    public bool clearDepth;
    public bool isHdrEnabled;
    public bool isDefaultViewport;
    public bool postProcessEnabled;
    public bool requiresDepthTexture;
    public bool requiresOpaqueTexture;
    public bool resolveFinalTarget;
    public bool xrRendering;

    private readonly Matrix4x4[] views = new Matrix4x4[2];
    private readonly Matrix4x4[] projections = new Matrix4x4[2];

    public bool isGameCamera => cameraType == CameraType.Game;
    public bool isSceneViewCamera => cameraType == CameraType.SceneView;
    public bool isPreviewCamera => cameraType == CameraType.Preview;
    public int scaledWidth => Math.Max(1, (int)(PixelWidth * renderScale));
    public int scaledHeight => Math.Max(1, (int)(PixelHeight * renderScale));

    internal int ViewCount => Math.Max(1, cameraTargetDescriptor.volumeDepth);
    internal Rect PixelRect { get; set; }
    internal int PixelWidth => (int)PixelRect.width;
    internal int PixelHeight => (int)PixelRect.height;
    internal float AspectRatio => PixelRect.width / PixelRect.height;

    public Matrix4x4 GetViewMatrix(int viewIndex = 0) => views[viewIndex];

    public Matrix4x4 GetProjectionMatrix(int viewIndex = 0) => projections[viewIndex];

    /// <summary>As for the target that the camera draws into: upside down for textures.</summary>
    public Matrix4x4 GetGPUProjectionMatrix(int viewIndex = 0) => GL.GetGPUProjectionMatrix(projections[viewIndex], IsCameraProjectionMatrixFlipped());

    public bool IsCameraProjectionMatrixFlipped() => SystemInfo.graphicsUVStartsAtTop && renderer.DrawsIntoTexture(this);

    public bool IsHandleYFlipped(RTHandle handle) => SystemInfo.graphicsUVStartsAtTop && (handle.rt != null || targetTexture != null);

    public override void Reset()
    {
        (camera, baseCamera, renderer, targetTexture, volumeTrigger) = (null!, null!, null!, null, null);
        (cameraType, renderType, antialiasing, renderScale) = (default, default, default, 1f);
    }

    internal void SetMatrices(Matrix4x4 view, Matrix4x4 projection, int viewIndex = 0) =>
        (views[viewIndex], projections[viewIndex]) = (view, projection);
}
