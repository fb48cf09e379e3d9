using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>One pass of an object of a renderer list.</summary>
/// <param name="Programs">The shader whose pass it is.</param>
internal readonly record struct ListedDraw(DrawRequest Request, Material Material, ShaderProgramSet Programs, PassProgram Pass, RenderStateBlock? State)
{
    public void Draw()
    {
        if (Request.Geometry.Prepare())
        {
            Drawer.DrawPass(Material, Programs, Pass, Request.Block, Request.Geometry, Request.Matrix, State);
        }
    }
}
