namespace UnityEngine;

/// <summary>No device shows two eyes here: an eye's matrices are the camera's.</summary>
public sealed partial class Camera
{
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

    public MonoOrStereoscopicEye stereoActiveEye => MonoOrStereoscopicEye.Mono;

    public Matrix4x4 GetStereoViewMatrix(StereoscopicEye eye) => worldToCameraMatrix;

    public Matrix4x4 GetStereoProjectionMatrix(StereoscopicEye eye) => projectionMatrix;
}
