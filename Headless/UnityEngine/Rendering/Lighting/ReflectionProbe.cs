using System;
using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

/// <summary>
/// A cubemap that shiny surfaces inside its box mirror. Nothing is baked here: a baked or custom probe shows the texture that was assigned.
/// A realtime probe draws the sky or its background color; things are left out, and it says so where its culling mask asks for them.
/// </summary>
public sealed class ReflectionProbe : Behaviour
{
    private RenderTexture? drawn;
    private int drawnAt = -1;
    private int renders;

    public static int minBakedCubemapResolution => 16;
    public static int maxBakedCubemapResolution => 2048;

    /// <summary>What is mirrored where no probe is: RenderSettings' own cubemap or the sky.</summary>
    public static Texture defaultTexture => DefaultReflection.Texture;

    /// <summary>x times the color, to the power of y for the alpha of encoded textures; includes RenderSettings.reflectionIntensity.</summary>
    public static Vector4 defaultTextureHDRDecodeValues => DefaultReflection.HdrDecode;

    public ReflectionProbeMode mode { get; set; }
    public ReflectionProbeRefreshMode refreshMode { get; set; }
    public ReflectionProbeTimeSlicingMode timeSlicingMode { get; set; }
    public ReflectionProbeClearFlags clearFlags { get; set; } = ReflectionProbeClearFlags.Skybox;
    public Color backgroundColor { get; set; } = new(0.19215687f, 0.3019608f, 0.4745098f, 0f);
    public int cullingMask { get; set; } = -1;
    public int resolution { get; set; } = 128;
    public bool hdr { get; set; } = true;
    public float nearClipPlane { get; set; } = 0.3f;
    public float farClipPlane { get; set; } = 1000f;
    public float shadowDistance { get; set; } = 100f;
    public bool renderDynamicObjects { get; set; }
    public Vector3 center { get; set; }
    public Vector3 size { get; set; } = new(10f, 10f, 10f);
    public float blendDistance { get; set; } = 1f;
    public bool boxProjection { get; set; }
    public int importance { get; set; } = 1;
    public float intensity { get; set; } = 1f;
    public Texture? bakedTexture { get; set; }
    public Texture? customBakedTexture { get; set; }
    public RenderTexture? realtimeTexture { get; set; }

    /// <summary>World space, along the world's axes whatever the transform's rotation and scale.</summary>
    public Bounds bounds => new(transform.position + center, size);

    public Texture? texture => mode switch
    {
        ReflectionProbeMode.Realtime => realtimeTexture != null ? realtimeTexture : Realtime(),
        ReflectionProbeMode.Custom => customBakedTexture,
        _ => bakedTexture,
    };

    /// <summary>As DecodeHDR takes them; includes the intensity.</summary>
    public Vector4 textureHDRDecodeValues => new(intensity, 1f, 0f, 0f);

    public int RenderProbe() => RenderProbe(null);

    public int RenderProbe(RenderTexture? targetTexture)
    {
        if (mode != ReflectionProbeMode.Realtime)
        {
            Debug.LogWarning($"Reflection probe '{name}': probes are not baked here. Assign a cubemap to customBakedTexture and set the mode to Custom.", this);
            return -1;
        }

        Draw(targetTexture);
        return ++renders;
    }

    public bool IsFinishedRendering(int renderId) => true;

    // On awake is when something first asks for it.
    private RenderTexture? Realtime()
    {
        bool due = refreshMode switch
        {
            ReflectionProbeRefreshMode.OnAwake => drawn == null,
            ReflectionProbeRefreshMode.EveryFrame => drawn == null || drawnAt != Time.frameCount,
            _ => false,
        };
        if (due && isActiveAndEnabled && QualitySettings.realtimeReflectionProbes)
        {
            Draw(null);
        }

        return drawn;
    }

    private void Draw(RenderTexture? target)
    {
        if (cullingMask != 0 && drawn == null)
        {
            Debug.LogWarning($"Reflection probe '{name}': only its sky is drawn here, not the things of its culling mask.", this);
        }

        if (target == null)
        {
            drawn = drawn == null || drawn.width != resolution ? SkyCube.New(resolution, $"Reflection of {name}") : drawn;
            drawnAt = Time.frameCount;
        }

        bool skybox = clearFlags == ReflectionProbeClearFlags.Skybox;
        SkyCube.Draw(target != null ? target : drawn!, skybox ? Color.black : backgroundColor, skybox);
    }

    public void Reset()
    {
        (center, size, blendDistance, importance, intensity) = (Vector3.zero, new Vector3(10f, 10f, 10f), 1f, 1, 1f);
        (mode, resolution, hdr, boxProjection) = (ReflectionProbeMode.Baked, 128, true, false);
    }

    internal override void OnAdded() => ReflectionProbeList.Add(this);

    internal override void OnRemoved() => ReflectionProbeList.Remove(this);
}
