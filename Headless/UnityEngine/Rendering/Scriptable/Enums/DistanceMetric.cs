namespace UnityEngine.Rendering;

public enum DistanceMetric
{
    Perspective = 0,
    Orthographic = 1,
    CustomAxis = 2,
}
