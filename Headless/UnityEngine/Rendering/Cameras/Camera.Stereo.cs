using Headless.Engine;

namespace UnityEngine;

public sealed partial class Camera
{
    private readonly Matrix4x4?[] stereoViews = new Matrix4x4?[2];
    private readonly Matrix4x4?[] stereoProjections = new Matrix4x4?[2];

    public enum StereoscopicEye
    {
        Left = 0,
        Right = 1,
    }

    public enum MonoOrStereoscopicEye
    {
        Left = 0,
        Right = 1,
        Mono = 2,
    }

    public bool stereoEnabled => Stereo.Shows(this);
    public StereoTargetEyeMask stereoTargetEye { get; set; } = StereoTargetEyeMask.Both;

    /// <summary>Between the eyes, in metres.</summary>
    public float stereoSeparation { get; set; } = 0.022f;

    /// <summary>Distance at which both eyes see a point in the same place of their pictures, in metres.</summary>
    public float stereoConvergence { get; set; } = 10f;

    /// <summary>Left where no eye is drawn, or both at once.</summary>
    public MonoOrStereoscopicEye stereoActiveEye =>
        !stereoEnabled ? MonoOrStereoscopicEye.Mono : (MonoOrStereoscopicEye)(Stereo.EyeOf(this) ?? StereoscopicEye.Left);

    public Matrix4x4 GetStereoViewMatrix(StereoscopicEye eye) =>
        stereoViews[(int)eye] ?? Matrix4x4.Translate(new Vector3(-Side(eye), 0f, 0f)) * worldToCameraMatrix;

    public void SetStereoViewMatrix(StereoscopicEye eye, Matrix4x4 matrix) => stereoViews[(int)eye] = matrix;

    public void ResetStereoViewMatrices() => (stereoViews[0], stereoViews[1]) = (null, null);

    public Matrix4x4 GetStereoProjectionMatrix(StereoscopicEye eye) => stereoProjections[(int)eye] ?? Towards(projectionMatrix, Side(eye));

    public Matrix4x4 GetStereoNonJitteredProjectionMatrix(StereoscopicEye eye) => GetStereoProjectionMatrix(eye);

    public void SetStereoProjectionMatrix(StereoscopicEye eye, Matrix4x4 matrix) => stereoProjections[(int)eye] = matrix;

    public void ResetStereoProjectionMatrices() => (stereoProjections[0], stereoProjections[1]) = (null, null);

    private float Side(StereoscopicEye eye) => (eye == StereoscopicEye.Left ? -0.5f : 0.5f) * stereoSeparation;

    /// <summary>Turns the view of an eye beside the camera to what lies ahead of it.</summary>
    private Matrix4x4 Towards(Matrix4x4 projection, float side)
    {
        if (!orthographic)
        {
            projection.m02 -= projection.m00 * side / stereoConvergence;
        }

        return projection;
    }
}
