using System;
using UnityEngine;
using UnityEngine.Rendering;

namespace Headless.Engine;

/// <summary>What culling for a camera keeps.</summary>
internal static class CameraCulling
{
    public static ScriptableCullingParameters Parameters(Camera camera)
    {
        ReadOnlySpan<Vector4> planes = new Frustum(camera.cullingMatrix).Planes;
        var parameters = new ScriptableCullingParameters
        {
            Camera = camera,
            View = CameraView.Of(camera),
            cullingPlaneCount = planes.Length,
            isOrthographic = camera.orthographic,
            cullingMask = (uint)camera.cullingMask,
            cullingMatrix = camera.cullingMatrix,
            origin = camera.transform.position,
            shadowDistance = Mathf.Min(QualitySettings.shadowDistance, camera.farClipPlane),
            maximumVisibleLights = -1,
            cullingOptions = CullingOptions.NeedsLighting | CullingOptions.NeedsReflectionProbes | CullingOptions.ShadowCasters,
            reflectionProbeSortingCriteria = ReflectionProbeSortingCriteria.ImportanceThenSize,
            lodParameters = new LODParameters
            {
                isOrthographic = camera.orthographic,
                cameraPosition = camera.transform.position,
                fieldOfView = camera.fieldOfView,
                orthoSize = camera.orthographicSize,
                cameraPixelHeight = camera.pixelHeight,
            },
        };
        for (int i = 0; i < planes.Length; i++)
        {
            parameters.SetCullingPlane(i, new Plane { normal = planes[i], distance = planes[i].w });
        }

        float[] distances = camera.layerCullDistances;
        for (int layer = 0; layer < distances.Length; layer++)
        {
            parameters.SetLayerCullingDistance(layer, distances[layer]);
        }

        return parameters;
    }

    public static Frustum Planes(in ScriptableCullingParameters parameters)
    {
        var planes = new Vector4[parameters.cullingPlaneCount];
        for (int i = 0; i < planes.Length; i++)
        {
            Plane plane = parameters.GetCullingPlane(i);
            planes[i] = new Vector4(plane.normal.x, plane.normal.y, plane.normal.z, plane.distance);
        }

        return new Frustum(planes);
    }
}
