using System.Collections.Generic;
using System.Linq;
using System;
using UnityEngine.Rendering;
using UnityEngine;

namespace Headless.Engine;

/// <summary>Everything that can be drawn this frame: enabled renderers and queued draws.</summary>
internal static class SceneDraws
{
    public static List<DrawRequest> Collect()
    {
        var all = new List<DrawRequest>();
        foreach (Renderer renderer in RegisteredRenderers.All)
        {
            if (!renderer.forceRenderingOff && renderer.MeshToDraw is { } mesh)
            {
                Add(all, renderer, mesh);
            }
        }

        all.AddRange(DrawQueue.Requests);
        return all;
    }

    /// <summary>Materials beyond the last sub-mesh draw the last one again, as in Unity.</summary>
    private static void Add(List<DrawRequest> all, Renderer renderer, Mesh mesh)
    {
        Bounds bounds = renderer.bounds;
        Material?[] materials = renderer.Materials;
        for (int i = 0; i < materials.Length; i++)
        {
            all.Add(new DrawRequest
            {
                Material = materials[i] is { } material && material != null ? material : ErrorMaterial.Instance,
                Geometry = new MeshGeometry(mesh, Math.Min(i, mesh.subMeshCount - 1), 1),
                Block = renderer.Block(i),
                Matrix = renderer.localToWorldMatrix,
                Bounds = bounds,
                Layer = renderer.gameObject.layer,
                Shadows = renderer.shadowCastingMode,
                ReceiveShadows = renderer.receiveShadows,
                Reflections = renderer.reflectionProbeUsage,
                RenderingLayers = renderer.renderingLayerMask,
                Motion = renderer.motionVectorGenerationMode,
                SortingLayer = renderer.sortingLayerID,
                SortingOrder = renderer.sortingOrder,
                Priority = renderer.rendererPriority,
            });
        }
    }

    public static List<VisibleDraw> Visible(List<DrawRequest> all, Camera camera)
    {
        var frustum = new Frustum(camera.cullingMatrix);
        Matrix4x4 view = camera.worldToCameraMatrix;
        var visible = new List<VisibleDraw>();
        for (int i = 0; i < all.Count; i++)
        {
            DrawRequest draw = all[i];
            if (draw.Material != null && draw.IsVisible && draw.SeenBy(camera, camera.cullingMask) && frustum.Touches(draw.Bounds))
            {
                float distance = -view.MultiplyPoint3x4(draw.Bounds.center).z;
                visible.Add(new VisibleDraw(draw, draw.Material.renderQueue, distance, i));
            }
        }

        return visible;
    }

    /// <summary>Opaque draws by queue and front to back.</summary>
    public static IEnumerable<VisibleDraw> Opaque(List<VisibleDraw> visible) => visible
        .Where(d => d.Queue <= (int)RenderQueue.GeometryLast)
        .OrderBy(d => d.Queue).ThenBy(d => d.Request.SortingOrder).ThenBy(d => d.Request.Priority).ThenBy(d => d.Distance).ThenBy(d => d.Order);

    /// <summary>Transparent draws by queue and back to front.</summary>
    public static IEnumerable<VisibleDraw> Transparent(List<VisibleDraw> visible) => visible
        .Where(d => d.Queue > (int)RenderQueue.GeometryLast)
        .OrderBy(d => d.Queue).ThenBy(d => d.Request.SortingOrder).ThenBy(d => d.Request.Priority).ThenByDescending(d => d.Distance).ThenBy(d => d.Order);
}
