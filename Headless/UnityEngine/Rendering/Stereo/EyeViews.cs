using UnityEngine;

namespace Headless.Engine;

/// <summary>The matrices of both eyes in shaders, while a camera draws both at once.</summary>
internal static class EyeViews
{
    public static readonly int ViewProjections = ShaderNames.Id("unity_StereoMatrixVP");
    private static readonly int Projections = ShaderNames.Id("unity_StereoMatrixP");
    private static readonly int Views = ShaderNames.Id("unity_StereoMatrixV");
    private static readonly int InverseViews = ShaderNames.Id("unity_StereoMatrixInvV");
    private static readonly int CameraProjections = ShaderNames.Id("unity_StereoCameraProjection");
    private static readonly int CameraInverseProjections = ShaderNames.Id("unity_StereoCameraInvProjection");
    private static readonly int WorldToCameras = ShaderNames.Id("unity_StereoWorldToCamera");
    private static readonly int CamerasToWorld = ShaderNames.Id("unity_StereoCameraToWorld");
    private static readonly int Places = ShaderNames.Id("unity_StereoWorldSpaceCameraPos");
    private static readonly int ScaleOffsets = ShaderNames.Id("unity_StereoScaleOffset");

    /// <summary>The camera; null while one eye is drawn.</summary>
    public static Camera? Camera { get; set; }

    public static CameraView Of(int eye) => CameraView.Of(Camera!, (Camera.StereoscopicEye)eye);

    /// <summary>Writes them for a target that may be upside down.</summary>
    public static void Apply(bool flipped)
    {
        if (Camera == null)
        {
            return;
        }

        CameraView left = Of(0);
        CameraView right = Of(1);
        Matrix4x4 forwards = Matrix4x4.Scale(new Vector3(1f, 1f, -1f));
        Matrix4x4 leftGpu = ViewState.Gpu(left.Projection, flipped);
        Matrix4x4 rightGpu = ViewState.Gpu(right.Projection, flipped);
        PropertySheet sheet = GlobalProperties.Sheet;
        sheet.SetMatrices(Projections, [leftGpu, rightGpu]);
        sheet.SetMatrices(Views, [left.View, right.View]);
        sheet.SetMatrices(InverseViews, [left.View.inverse, right.View.inverse]);
        sheet.SetMatrices(ViewProjections, [leftGpu * left.View, rightGpu * right.View]);
        sheet.SetMatrices(CameraProjections, [left.Projection, right.Projection]);
        sheet.SetMatrices(CameraInverseProjections, [left.Projection.inverse, right.Projection.inverse]);
        sheet.SetMatrices(WorldToCameras, [forwards * left.View, forwards * right.View]);
        sheet.SetMatrices(CamerasToWorld, [(forwards * left.View).inverse, (forwards * right.View).inverse]);
        sheet.SetVectors(Places, [left.Position, right.Position]);
        sheet.SetVectors(ScaleOffsets, [new Vector4(1f, 1f, 0f, 0f), new Vector4(1f, 1f, 0f, 0f)]);
    }
}
