using UnityEngine;

namespace Headless.Engine;

/// <summary>Draws one pass of a material; the property block is the one of the time of recording.</summary>
internal sealed class DrawCommand(Material material, int pass, PropertySheet? block, DrawGeometry geometry, Matrix4x4 matrix) : GpuCommand
{
    public override void Run(CommandContext context) => Drawer.Draw(material, pass, block, geometry, matrix);
}
