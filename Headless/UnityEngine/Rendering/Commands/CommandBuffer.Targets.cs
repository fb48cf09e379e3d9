using System;
using System.Linq;
using Headless.Engine;

namespace UnityEngine.Rendering;

public partial class CommandBuffer
{
    public void SetRenderTarget(RenderTargetIdentifier rt) => Add(c => SwitchTo(c.Target(rt)));

    public void SetRenderTarget(RenderTargetIdentifier rt, int mipLevel) => SetRenderTarget(rt, mipLevel, CubemapFace.Unknown, 0);

    public void SetRenderTarget(RenderTargetIdentifier rt, int mipLevel, CubemapFace cubemapFace) => SetRenderTarget(rt, mipLevel, cubemapFace, 0);

    public void SetRenderTarget(RenderTargetIdentifier rt, int mipLevel, CubemapFace cubemapFace, int depthSlice) =>
        SetRenderTarget(new RenderTargetIdentifier(rt, mipLevel, cubemapFace, depthSlice));

    public void SetRenderTarget(RenderTargetIdentifier rt, RenderBufferLoadAction loadAction, RenderBufferStoreAction storeAction) =>
        SetRenderTarget(rt, loadAction, storeAction, loadAction, storeAction);

    public void SetRenderTarget(
        RenderTargetIdentifier rt, RenderBufferLoadAction colorLoadAction, RenderBufferStoreAction colorStoreAction,
        RenderBufferLoadAction depthLoadAction, RenderBufferStoreAction depthStoreAction) => Add(c =>
        {
            SwitchTo(c.Target(rt));
            TargetState.Discard(colorLoadAction == RenderBufferLoadAction.DontCare, depthLoadAction == RenderBufferLoadAction.DontCare);
        });

    public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth) => SetRenderTarget([color], depth);

    public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth, int mipLevel) =>
        SetRenderTarget(color, depth, mipLevel, CubemapFace.Unknown, 0);

    public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth, int mipLevel, CubemapFace cubemapFace) =>
        SetRenderTarget(color, depth, mipLevel, cubemapFace, 0);

    public void SetRenderTarget(RenderTargetIdentifier color, RenderTargetIdentifier depth, int mipLevel, CubemapFace cubemapFace, int depthSlice) =>
        SetRenderTarget([color], depth, mipLevel, cubemapFace, depthSlice);

    public void SetRenderTarget(RenderTargetIdentifier[] colors, RenderTargetIdentifier depth)
    {
        RenderTargetIdentifier[] copy = [.. colors];
        Add(c => SwitchTo(c.Target(copy, depth)));
    }

    public void SetRenderTarget(RenderTargetIdentifier[] colors, RenderTargetIdentifier depth, int mipLevel, CubemapFace cubemapFace, int depthSlice) =>
        SetRenderTarget(
            Array.ConvertAll(colors, c => new RenderTargetIdentifier(c, mipLevel, cubemapFace, depthSlice)),
            new RenderTargetIdentifier(depth, mipLevel, cubemapFace, depthSlice));

    public void SetRenderTarget(
        RenderTargetIdentifier color, RenderBufferLoadAction colorLoadAction, RenderBufferStoreAction colorStoreAction,
        RenderTargetIdentifier depth, RenderBufferLoadAction depthLoadAction, RenderBufferStoreAction depthStoreAction) =>
        SetRenderTarget(new RenderTargetBinding(color, colorLoadAction, colorStoreAction, depth, depthLoadAction, depthStoreAction));

    public void SetRenderTarget(RenderTargetBinding binding)
    {
        SetRenderTarget(binding.colorRenderTargets, binding.depthRenderTarget);
        bool colors = Array.TrueForAll(binding.colorLoadActions, a => a == RenderBufferLoadAction.DontCare);
        bool depths = binding.depthLoadAction == RenderBufferLoadAction.DontCare;
        Add(_ => TargetState.Discard(colors, depths));
    }

    public void SetRenderTarget(RenderTargetBinding binding, int mipLevel, CubemapFace cubemapFace, int depthSlice) => SetRenderTarget(binding with
    {
        colorRenderTargets = Array.ConvertAll(binding.colorRenderTargets, c => new RenderTargetIdentifier(c, mipLevel, cubemapFace, depthSlice)),
        depthRenderTarget = new RenderTargetIdentifier(binding.depthRenderTarget, mipLevel, cubemapFace, depthSlice),
    });

    public void ClearRenderTarget(bool clearDepth, bool clearColor, Color backgroundColor) =>
        ClearRenderTarget(clearDepth, clearColor, backgroundColor, 1f);

    public void ClearRenderTarget(bool clearDepth, bool clearColor, Color backgroundColor, float depth) =>
        Add(_ => TargetState.Clear(clearColor, clearDepth, backgroundColor, 1f - depth));

    public void ClearRenderTarget(RTClearFlags clearFlags, Color backgroundColor, float depth, uint stencil) =>
        ClearRenderTarget((clearFlags & RTClearFlags.Depth) != 0, (clearFlags & RTClearFlags.Color) != 0, backgroundColor, depth);

    public void SetViewport(Rect pixelRect) => Add(_ => TargetState.SetViewport(pixelRect));

    public void EnableScissorRect(Rect scissor) => Add(_ => TargetState.SetScissor(scissor));

    public void DisableScissorRect() => Add(_ => TargetState.SetScissor(null));

    public void SetInvertCulling(bool invertCulling) => Add(_ => Drawer.InvertCulling = invertCulling);

    public void SetViewMatrix(Matrix4x4 view) => Add(_ => ViewState.Set(view, ViewState.Projection));

    public void SetProjectionMatrix(Matrix4x4 proj) => Add(_ => ViewState.Set(ViewState.View, proj));

    public void SetViewProjectionMatrices(Matrix4x4 view, Matrix4x4 proj) => Add(_ => ViewState.Set(view, proj));

    public void GetTemporaryRT(int nameID, RenderTextureDescriptor desc) => GetTemporaryRT(nameID, desc, FilterMode.Point);

    public void GetTemporaryRT(int nameID, RenderTextureDescriptor desc, FilterMode filter) =>
        Add(c => c.Temporaries.Get(nameID, desc, filter));

    public void GetTemporaryRT(int nameID, int width, int height) => GetTemporaryRT(nameID, width, height, 0);

    public void GetTemporaryRT(int nameID, int width, int height, int depthBuffer) =>
        GetTemporaryRT(nameID, width, height, depthBuffer, FilterMode.Point);

    public void GetTemporaryRT(int nameID, int width, int height, int depthBuffer, FilterMode filter) =>
        GetTemporaryRT(nameID, width, height, depthBuffer, filter, RenderTextureFormat.Default);

    public void GetTemporaryRT(int nameID, int width, int height, int depthBuffer, FilterMode filter, RenderTextureFormat format) =>
        GetTemporaryRT(nameID, width, height, depthBuffer, filter, format, RenderTextureReadWrite.Default);

    public void GetTemporaryRT(
        int nameID, int width, int height, int depthBuffer, FilterMode filter, RenderTextureFormat format, RenderTextureReadWrite readWrite) =>
        GetTemporaryRT(nameID, width, height, depthBuffer, filter, format, readWrite, 1, false);

    public void GetTemporaryRT(
        int nameID, int width, int height, int depthBuffer, FilterMode filter, RenderTextureFormat format, RenderTextureReadWrite readWrite,
        int antiAliasing, bool enableRandomWrite) =>

        // -1 and -2 ask for the camera's size and for fractions of it.
        Add(c => c.Temporaries.Get(
            nameID,
            new RenderTextureDescriptor(CameraSize(width, Camera.current?.pixelWidth ?? ScreenTarget.Width), CameraSize(height, Camera.current?.pixelHeight ?? ScreenTarget.Height), format, depthBuffer)
            {
                graphicsFormat = TextureFormats.Of(format, readWrite),
                msaaSamples = antiAliasing,
                enableRandomWrite = enableRandomWrite,
            },
            filter));

    public void ReleaseTemporaryRT(int nameID) => Add(c => c.Temporaries.Release(nameID));

    private static int CameraSize(int size, int camera) => size < 0 ? camera / -size : size;

    private static void SwitchTo(DrawTarget? target)
    {
        if (target is not null)
        {
            TargetState.Set(target);
            ViewState.Apply();
        }
    }
}
