using System;
using System.Collections.Generic;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>The render state of a renderer list by a tag of the shader or of the pass.</summary>
internal sealed class StateOverrides
{
    private static readonly HashSet<string> Named = [];

    private readonly List<(string Value, RenderStateBlock Block)> blocks = [];
    private readonly string tag;
    private readonly bool ofPass;

    public StateOverrides(in RendererListParams parameters)
    {
        (tag, ofPass) = (parameters.tagName.name, parameters.isPassTagName);
        if (parameters.tagValues is not { } values || parameters.stateBlocks is not { } states)
        {
            return;
        }

        for (int i = 0; i < Math.Min(values.Length, states.Length); i++)
        {
            blocks.Add((values[i].name, states[i]));
            Check(states[i]);
        }
    }

    public static void Reset() => Named.Clear();

    /// <summary>Of the first value that fits; no value fits everything.</summary>
    public RenderStateBlock? For(Material material, PassProgram pass)
    {
        if (blocks.Count == 0)
        {
            return null;
        }

        string actual = tag.Length == 0 ? string.Empty : ofPass ? pass.Tag(tag) : material.GetTag(tag, false);
        foreach ((string value, RenderStateBlock block) in blocks)
        {
            if (value.Length == 0 || value.Equals(actual, StringComparison.OrdinalIgnoreCase))
            {
                return block;
            }
        }

        return null;
    }

    private static void Check(in RenderStateBlock block)
    {
        if ((block.mask & RenderStateMask.Stencil) != 0 && block.stencilState.enabled)
        {
            Refuse("its stencil state has no effect, for render targets have no stencil here");
        }

        if ((block.mask & RenderStateMask.Blend) != 0 && block.blendState.separateMRTBlendStates)
        {
            Refuse("separateMRTBlendStates has no effect: all render targets are blended as the first");
        }
    }

    private static void Refuse(string what)
    {
        if (Named.Add(what))
        {
            Debug.LogWarning($"RenderStateBlock: {what}.");
        }
    }
}
