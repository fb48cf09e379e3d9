using UnityEngine;

namespace Headless.Engine;

/// <summary>The sky behind both eyes.</summary>
internal static class EyeSky
{
    public static void Draw(Material material)
    {
        if (!LayeredDraws.Knows(material.Usable.Programs.Passes[0]))
        {
            LayeredDraws.EachEye(Sky.Draw);
            return;
        }

        bool flipped = TargetState.Current!.Flipped;
        var both = new Matrix4x4[2];
        for (int eye = 0; eye < both.Length; eye++)
        {
            CameraView seen = EyeViews.Of(eye);
            Matrix4x4 turn = seen.View;
            turn.SetColumn(3, new Vector4(0f, 0f, 0f, 1f));
            both[eye] = ViewState.Gpu(Sky.AtFarPlane(seen.Projection), flipped) * turn;
        }

        GlobalProperties.Sheet.SetMatrices(EyeViews.ViewProjections, both);
        Drawer.Draw(material, -1, null, new MeshGeometry(BuiltinMeshes.Get(PrimitiveType.Cube), 0, 1), Matrix4x4.identity);
        EyeViews.Apply(flipped);
    }
}
