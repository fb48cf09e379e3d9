using UnityEngine;

namespace Headless.Engine;

/// <summary>The background where a camera clears to the skybox: RenderSettings.skybox on a cube around the viewer, at the far plane.</summary>
internal static class Sky
{
    // What surfaces that face up, sideways and down receive from it, linear; about as bright as Unity's default sky.
    public static readonly Color AmbientUp = new(0.15f, 0.18f, 0.23f);
    public static readonly Color AmbientLevel = new(0.11f, 0.12f, 0.14f);
    public static readonly Color AmbientDown = new(0.05f, 0.045f, 0.04f);

    // An orthographic camera sees one direction everywhere.
    private const float OneDirection = 0.05f;

    /// <summary>With the view and the light that are set; without a skybox nothing.</summary>
    public static void Draw()
    {
        Material? material = RenderSettings.skybox;
        if (material == null)
        {
            return;
        }

        if (LayeredDraws.AreOn)
        {
            EyeSky.Draw(material);
            return;
        }

        Matrix4x4 projection = AtFarPlane(ViewState.Projection);
        bool flipped = TargetState.Current?.Flipped ?? false;
        GlobalProperties.Sheet.SetMatrix(BuiltinNames.MatrixVP, ViewState.Gpu(projection, flipped) * ViewState.View);
        Matrix4x4 around = Matrix4x4.Translate(ViewState.View.inverse.GetColumn(3));
        Drawer.Draw(material, -1, null, new MeshGeometry(BuiltinMeshes.Get(PrimitiveType.Cube), 0, 1), around);
        ViewState.Apply();
    }

    /// <summary>z = w, whatever the distance.</summary>
    public static Matrix4x4 AtFarPlane(Matrix4x4 projection)
    {
        if (GlobalProperties.Sheet.GetVector(BuiltinNames.OrthoParams).w > 0.5f)
        {
            projection = Matrix4x4.Perspective(OneDirection, 1f, 0.1f, 10f);
        }

        projection.SetRow(2, projection.GetRow(3));
        return projection;
    }
}
