using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

internal sealed class DrawListCommand(RendererList list) : GpuCommand
{
    public override void Run(CommandContext context)
    {
        if (list.isValid)
        {
            list.Content!.Draw();
        }
        else
        {
            Debug.LogError("DrawRendererList: the renderer list is not valid. A list is of the frame and the ScriptableRenderContext that made it.");
        }
    }
}
