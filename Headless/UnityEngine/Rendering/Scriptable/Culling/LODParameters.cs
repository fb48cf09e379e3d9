namespace UnityEngine.Rendering;

/// <summary>From where levels of detail are chosen.</summary>
public record struct LODParameters
{
    public bool isOrthographic { get; set; }
    public Vector3 cameraPosition { get; set; }
    public float fieldOfView { get; set; }
    public float orthoSize { get; set; }
    public int cameraPixelHeight { get; set; }
}
