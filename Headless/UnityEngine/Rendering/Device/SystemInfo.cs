using System.Runtime.InteropServices;
using System;
using Headless.Engine;
using Headless.Vulkan;
using UnityEngine.Experimental.Rendering;
using UnityEngine.Rendering;

namespace UnityEngine;

public sealed partial class SystemInfo
{
    public const string unsupportedIdentifier = "n/a";

    public static string graphicsDeviceName => GraphicsDevice.Device.Adapter.Name;
    public static string graphicsDeviceVendor => GraphicsDevice.Device.Adapter.Driver;
    public static int graphicsDeviceVendorID => GraphicsDevice.Device.Adapter.VendorId;
    public static int graphicsDeviceID => GraphicsDevice.Device.Adapter.DeviceId;
    public static string graphicsDeviceVersion => $"Direct3D 11.0 [level 11.0] on Vulkan {GraphicsDevice.Device.Adapter.ApiVersion}";
    public static GraphicsDeviceType graphicsDeviceType => GraphicsDevice.IsReady ? GraphicsDeviceType.Direct3D11 : GraphicsDeviceType.Null;
    public static int graphicsMemorySize => (int)(Limits.DeviceMemory >> 20);
    public static int graphicsShaderLevel => Limits.GeometryShader ? 50 : 45;
    public static bool graphicsMultiThreaded => false;
    public static bool graphicsUVStartsAtTop => true;
    public static bool usesReversedZBuffer => true;
    public static RenderingThreadingMode renderingThreadingMode => RenderingThreadingMode.Direct;

    public static string deviceName => Environment.MachineName;
    public static string deviceModel => RuntimeInformation.OSArchitecture.ToString();
    public static DeviceType deviceType => DeviceType.Desktop;
    public static string deviceUniqueIdentifier => unsupportedIdentifier;
    public static string operatingSystem => RuntimeInformation.OSDescription;
    public static int processorCount => Environment.ProcessorCount;
    public static string processorType => ProcessorName.Value;
    public static int systemMemorySize => (int)(GC.GetGCMemoryInfo().TotalAvailableMemoryBytes >> 20);

    public static OperatingSystemFamily operatingSystemFamily => true switch
    {
        _ when OperatingSystem.IsWindows() => OperatingSystemFamily.Windows,
        _ when OperatingSystem.IsMacOS() => OperatingSystemFamily.MacOSX,
        _ when OperatingSystem.IsLinux() => OperatingSystemFamily.Linux,
        _ => OperatingSystemFamily.Other,
    };

    public static bool supportsComputeShaders => GraphicsDevice.IsReady;
    public static bool supportsGeometryShaders => GraphicsDevice.IsReady && Limits.GeometryShader;
    public static bool supportsTessellationShaders => false;
    public static bool supportsInstancing => GraphicsDevice.IsReady;
    public static bool supportsIndirectArgumentsBuffer => GraphicsDevice.IsReady;
    public static bool supportsAsyncGPUReadback => GraphicsDevice.IsReady;
    public static bool supportsAsyncCompute => false;
    public static bool supportsGraphicsFence => false;
    public static bool supportsGpuRecorder => GraphicsDevice.IsReady && Limits.Timestamps;
    public static bool supports32bitsIndexBuffer => true;
    public static bool supports3DTextures => true;
    public static bool supports3DRenderTextures => true;
    public static bool supports2DArrayTextures => true;
    public static bool supportsShadows => true;
    public static bool supportsRawShadowDepthSampling => true;
    public static bool supportsAnisotropicFilter => true;
    public static bool supportsHardwareQuadTopology => false;
    public static bool supportsRayTracing => false;
    public static bool supportsSetConstantBuffer => true;
    public static bool supportsSeparatedRenderTargetsBlend => true;
    public static int supportsMultisampledTextures => 0;
    public static bool supportsMotionVectors => false;
    public static NPOTSupport npotSupport => NPOTSupport.Full;

    public static CopyTextureSupport copyTextureSupport =>
        CopyTextureSupport.Basic | CopyTextureSupport.Copy3D | CopyTextureSupport.TextureToRT | CopyTextureSupport.RTToTexture;

    internal static int MaxSamples
    {
        get
        {
            int counts = Limits.SampleCounts;
            return (counts & 8) != 0 ? 8 : (counts & 4) != 0 ? 4 : (counts & 2) != 0 ? 2 : 1;
        }
    }

    private static GpuLimits Limits => GraphicsDevice.Device.Limits;
}
