namespace UnityEngine.Rendering;

/// <summary>The order of the objects of a renderer list.</summary>
public record struct SortingSettings
{
    /// <summary>For a camera: distances along its view where it is orthographic, from its place otherwise.</summary>
    public SortingSettings(Camera camera)
    {
        worldToCameraMatrix = camera.worldToCameraMatrix;
        cameraPosition = camera.transform.position;
        distanceMetric = camera.transparencySortMode switch
        {
            TransparencySortMode.Orthographic => DistanceMetric.Orthographic,
            TransparencySortMode.Perspective => DistanceMetric.Perspective,
            _ => camera.orthographic ? DistanceMetric.Orthographic : DistanceMetric.Perspective,
        };
        customAxis = Vector3.forward;
    }

    public Matrix4x4 worldToCameraMatrix { get; set; }
    public Vector3 cameraPosition { get; set; }
    public Vector3 customAxis { get; set; }
    public SortingCriteria criteria { get; set; }
    public DistanceMetric distanceMetric { get; set; }

    internal readonly float Distance(Vector3 place) => distanceMetric switch
    {
        DistanceMetric.Orthographic => -worldToCameraMatrix.MultiplyPoint3x4(place).z,
        DistanceMetric.CustomAxis => Vector3.Dot(place - cameraPosition, customAxis),
        _ => Vector3.Distance(place, cameraPosition),
    };
}
