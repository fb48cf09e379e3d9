using System;
using System.Collections.Generic;
using System.Linq;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>Visible objects that filters let through, in their order, with the passes that the drawing settings name.</summary>
internal sealed class ObjectRendererList : RendererListContent
{
    private readonly CulledScene scene;
    private readonly DrawingSettings drawing;
    private readonly FilteringSettings filtering;
    private readonly ListedPasses passes;
    private readonly StateOverrides states;
    private List<ListedDraw>? draws;

    public ObjectRendererList(ContextCommands owner, CulledScene scene, in RendererListParams parameters)
        : base(owner)
    {
        (this.scene, drawing, filtering) = (scene, parameters.drawSettings, parameters.filteringSettings);
        passes = new ListedPasses(drawing);
        states = new StateOverrides(parameters);
    }

    public override bool IsEmpty => Draws.Count == 0;

    /// <summary>In the order in which they are drawn.</summary>
    public List<ListedDraw> Draws => draws ??= Find();

    public override void Prepare() => _ = Draws;

    public override void Draw()
    {
        foreach (ListedDraw draw in Draws)
        {
            ObjectValues.Apply(draw.Request, drawing.perObjectData, scene.Lights, drawing.mainLightIndex);
            draw.Draw();
        }

        ObjectValues.Clear();
        if ((drawing.perObjectData & PerObjectData.ReflectionProbes) != 0)
        {
            ReflectionSettings.ApplyDefault();
        }
    }

    private List<ListedDraw> Find()
    {
        var found = new List<ListedDraw>();
        foreach (DrawRequest request in SortedDraws.Of(scene.Visible.Where(Passes), drawing.sortingSettings))
        {
            foreach ((Material material, ShaderProgramSet programs, PassProgram pass) in passes.Of(request.Material))
            {
                found.Add(new ListedDraw(request, material, programs, pass, states.For(request.Material, pass)));
            }
        }

        return found;
    }

    private bool Passes(DrawRequest draw) =>
        filtering.renderQueueRange.Contains(Math.Clamp(draw.Material.renderQueue, RenderQueueRange.minimumBound, RenderQueueRange.maximumBound))
        && (filtering.layerMask & (1 << draw.Layer)) != 0
        && (filtering.renderingLayerMask & draw.RenderingLayers) != 0
        && filtering.sortingLayerRange.Contains(draw.SortingLayer)
        && !(filtering.excludeMotionVectorObjects && draw.Motion == MotionVectorGenerationMode.Object);
}
