using UnityEngine;

namespace SphFluid
{
    /// <summary>The matrices that a camera draws with: one view, or both eyes at once.</summary>
    internal readonly struct CameraViews
    {
        private readonly Matrix4x4 view, projection, rightView, rightProjection;

        /// <summary>One view, the whole camera's or an eye's.</summary>
        public CameraViews(Matrix4x4 view, Matrix4x4 projection)
            : this(view, projection, default, default) => Count = 1;

        /// <summary>The left eye's and the right eye's.</summary>
        public CameraViews(Matrix4x4 view, Matrix4x4 projection, Matrix4x4 rightView, Matrix4x4 rightProjection)
        {
            (this.view, this.projection) = (view, projection);
            (this.rightView, this.rightProjection) = (rightView, rightProjection);
            Count = 2;
        }

        /// <summary>1, or 2 for both eyes at once.</summary>
        public int Count { get; }

        /// <summary>World to camera.</summary>
        public Matrix4x4 View(int eye) => eye == 0 ? view : rightView;

        /// <summary>The camera's projection.</summary>
        public Matrix4x4 Projection(int eye) => eye == 0 ? projection : rightProjection;

        /// <summary>Those that the Built-in pipeline draws a camera with now.</summary>
        public static CameraViews Of(Camera camera)
        {
            if (!camera.stereoEnabled) return new CameraViews(camera.worldToCameraMatrix, camera.projectionMatrix);
            const Camera.StereoscopicEye left = Camera.StereoscopicEye.Left;
            const Camera.StereoscopicEye right = Camera.StereoscopicEye.Right;
            if (EyeDraws.TryGetPicture(camera, out _))
            {
                return new CameraViews(camera.GetStereoViewMatrix(left), camera.GetStereoProjectionMatrix(left),
                    camera.GetStereoViewMatrix(right), camera.GetStereoProjectionMatrix(right));
            }
            Camera.StereoscopicEye eye = camera.stereoActiveEye == Camera.MonoOrStereoscopicEye.Right ? right : left;
            return new CameraViews(camera.GetStereoViewMatrix(eye), camera.GetStereoProjectionMatrix(eye));
        }
    }
}
