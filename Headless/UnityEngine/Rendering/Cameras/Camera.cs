using System.Linq;
using System;
using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class Camera : Behaviour
{
    public static CameraCallback? onPreCull;
    public static CameraCallback? onPreRender;
    public static CameraCallback? onPostRender;

    private float? aspectOverride;
    private Rect viewRect = new(0f, 0f, 1f, 1f);

    public delegate void CameraCallback(Camera cam);

    public static Camera? main => CameraList.Ordered.FirstOrDefault(c => c.gameObject.CompareTag("MainCamera"));
    public static Camera? current { get; internal set; }
    public static Camera[] allCameras => [.. CameraList.Ordered];
    public static int allCamerasCount => CameraList.Ordered.Count;

    public CameraClearFlags clearFlags { get; set; } = CameraClearFlags.Skybox;
    public Color backgroundColor { get; set; } = new(0.19215687f, 0.3019608f, 0.4745098f, 0f);
    public float nearClipPlane { get; set; } = 0.3f;
    public float farClipPlane { get; set; } = 1000f;
    public float fieldOfView { get; set; } = 60f;
    public bool orthographic { get; set; }
    public float orthographicSize { get; set; } = 5f;
    public float depth { get; set; }
    public int cullingMask { get; set; } = -1;
    public int eventMask { get; set; } = -1;
    public CameraType cameraType { get; set; } = CameraType.Game;
    public RenderTexture? targetTexture { get; set; }
    public int targetDisplay { get; set; }
    public bool allowHDR { get; set; } = true;
    public bool allowMSAA { get; set; } = true;
    public bool useOcclusionCulling { get; set; } = true;
    public bool forceIntoRenderTexture { get; set; }
    public DepthTextureMode depthTextureMode { get; set; }
    public RenderingPath renderingPath { get; set; } = RenderingPath.UsePlayerSettings;
    public RenderingPath actualRenderingPath => RenderingPath.Forward;
    public OpaqueSortMode opaqueSortMode { get; set; }
    public TransparencySortMode transparencySortMode { get; set; }
    public RenderTexture? activeTexture => targetTexture;

    public Rect rect
    {
        get => viewRect;
        set => viewRect = value;
    }

    public Rect pixelRect
    {
        get
        {
            (int w, int h) = TargetSize;
            return new Rect(Mathf.Round(viewRect.x * w), Mathf.Round(viewRect.y * h), Mathf.Round(viewRect.width * w), Mathf.Round(viewRect.height * h));
        }
        set
        {
            (int w, int h) = TargetSize;
            viewRect = new Rect(value.x / w, value.y / h, value.width / w, value.height / h);
        }
    }

    public int pixelWidth => (int)pixelRect.width;
    public int pixelHeight => (int)pixelRect.height;
    public int scaledPixelWidth => pixelWidth;
    public int scaledPixelHeight => pixelHeight;

    public float aspect
    {
        get => aspectOverride ?? (pixelHeight > 0 ? pixelWidth / (float)pixelHeight : 1f);
        set => aspectOverride = value;
    }

    private (int Width, int Height) TargetSize => targetTexture != null
        ? (targetTexture.width, targetTexture.height)
        : stereoEnabled ? (Stereo.EyeWidth, Stereo.EyeHeight) : (ScreenTarget.Width, ScreenTarget.Height);

    public static int GetAllCameras(Camera[] cameras)
    {
        Camera[] all = allCameras;
        if (cameras.Length < all.Length)
        {
            throw new ArgumentException("Passed in array to fill with cameras is to small to hold the number of cameras. Use Camera.allCamerasCount to get the needed size.");
        }

        all.CopyTo(cameras, 0);
        return all.Length;
    }

    public static void SetupCurrent(Camera cur) => current = cur;

    public void Render()
    {
        TargetState.Finish();
        FrameRenderer.Render(this);
    }

    public void ResetAspect() => aspectOverride = null;

    public void Reset()
    {
        ResetAspect();
        ResetProjectionMatrix();
        ResetWorldToCameraMatrix();
        ResetCullingMatrix();
    }

    public void CopyFrom(Camera other)
    {
        ArgumentNullException.ThrowIfNull(other);
        (clearFlags, backgroundColor, cullingMask, depth) = (other.clearFlags, other.backgroundColor, other.cullingMask, other.depth);
        (nearClipPlane, farClipPlane, fieldOfView) = (other.nearClipPlane, other.farClipPlane, other.fieldOfView);
        (orthographic, orthographicSize, viewRect, targetTexture) = (other.orthographic, other.orthographicSize, other.viewRect, other.targetTexture);
        (allowHDR, allowMSAA, depthTextureMode) = (other.allowHDR, other.allowMSAA, other.depthTextureMode);
        (aspectOverride, projectionOverride, viewOverride) = (other.aspectOverride, other.projectionOverride, other.viewOverride);
        transform.SetPositionAndRotation(other.transform.position, other.transform.rotation);
    }

    internal override void OnAdded() => CameraList.Add(this);

    internal override void OnRemoved() => CameraList.Remove(this);
}
