using System;
using Headless.Engine;
using UnityEngine.Rendering;

namespace UnityEngine;

public partial class Graphics
{
    public static RenderBuffer activeColorBuffer => new(RenderTexture.active, false);
    public static RenderBuffer activeDepthBuffer => new(RenderTexture.active, true);

    public static void ExecuteCommandBuffer(CommandBuffer buffer)
    {
        ArgumentNullException.ThrowIfNull(buffer);
        DrawTarget? before = TargetState.Current;
        Matrix4x4 view = ViewState.View;
        Matrix4x4 projection = ViewState.Projection;
        buffer.Execute(before);
        if (TargetState.Current != before)
        {
            TargetState.Set(before);
        }
        else if (before is null)
        {
            TargetState.Finish();
        }

        if (before is not null)
        {
            ViewState.Set(view, projection);
        }
    }

    public static void SetRenderTarget(RenderTexture? rt) => RenderTexture.active = rt;

    public static void SetRenderTarget(RenderBuffer colorBuffer, RenderBuffer depthBuffer) => RenderTexture.active = colorBuffer.Texture;

    public static void Blit(Texture? source, RenderTexture? dest) => Blit(source, dest, Vector2.one, Vector2.zero);

    public static void Blit(Texture? source, RenderTexture? dest, Vector2 scale, Vector2 offset) =>
        Blitter.Blit(source, Destination(dest), null, -1, scale, offset);

    public static void Blit(Texture? source, RenderTexture? dest, Material mat) => Blit(source, dest, mat, -1);

    public static void Blit(Texture? source, RenderTexture? dest, Material mat, int pass)
    {
        ArgumentNullException.ThrowIfNull(mat);
        Blitter.Blit(source, Destination(dest), mat, pass, Vector2.one, Vector2.zero);
    }

    public static void Blit(Texture? source, Material mat) => Blit(source, mat, -1);

    public static void Blit(Texture? source, Material mat, int pass) => Blit(source, RenderTexture.active, mat, pass);

    public static void CopyTexture(Texture src, Texture dst) => TextureCopies.Copy(src, dst);

    public static void CopyTexture(Texture src, int srcElement, Texture dst, int dstElement) =>
        TextureCopies.Copy(src, srcElement, 0, dst, dstElement, 0);

    public static void CopyTexture(Texture src, int srcElement, int srcMip, Texture dst, int dstElement, int dstMip) =>
        TextureCopies.Copy(src, srcElement, srcMip, dst, dstElement, dstMip);

    public static void CopyBuffer(GraphicsBuffer source, GraphicsBuffer dest)
    {
        using var commands = new CommandBuffer();
        commands.CopyBuffer(source, dest);
        commands.Execute(null);
    }

    public static void DrawMeshNow(Mesh mesh, Matrix4x4 matrix) => DrawMeshNow(mesh, matrix, 0);

    public static void DrawMeshNow(Mesh mesh, Matrix4x4 matrix, int materialIndex) =>
        ImmediateDrawing.Draw(new MeshGeometry(mesh, materialIndex, 1), matrix);

    public static void DrawMeshNow(Mesh mesh, Vector3 position, Quaternion rotation) =>
        DrawMeshNow(mesh, Matrix4x4.TRS(position, rotation, Vector3.one), 0);

    public static void DrawProceduralNow(MeshTopology topology, int vertexCount, int instanceCount = 1) =>
        ImmediateDrawing.Draw(new ProceduralGeometry(topology, vertexCount, instanceCount), Matrix4x4.identity);

    public static void DrawProceduralIndirectNow(MeshTopology topology, GraphicsBuffer bufferWithArgs, int argsOffset = 0) =>
        ImmediateDrawing.Draw(new IndirectGeometry(topology, bufferWithArgs.Storage, argsOffset, 1, null, null), Matrix4x4.identity);

    public static void DrawProceduralIndirectNow(MeshTopology topology, ComputeBuffer bufferWithArgs, int argsOffset = 0) =>
        ImmediateDrawing.Draw(new IndirectGeometry(topology, bufferWithArgs.Storage, argsOffset, 1, null, null), Matrix4x4.identity);

    /// <summary>Null stands for the camera's own target while image effects run, otherwise for the screen.</summary>
    private static DrawTarget Destination(RenderTexture? dest) => dest != null ? DrawTarget.Of(dest) : FrameRenderer.FinalTarget ?? DrawTarget.Screen;
}
