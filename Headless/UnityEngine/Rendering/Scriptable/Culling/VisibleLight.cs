using Headless.Engine;

namespace UnityEngine.Rendering;

/// <summary>A light that reaches something that a camera sees.</summary>
public record struct VisibleLight
{
    private readonly int instance;

    internal VisibleLight(Light light, Rect screenRect)
        : this()
    {
        instance = light.GetInstanceID();
        lightType = light.type;
        finalColor = light.FinalColor;
        this.screenRect = screenRect;
        localToWorldMatrix = Matrix4x4.TRS(light.transform.position, light.transform.rotation, Vector3.one);
        range = light.range;
        spotAngle = light.spotAngle;
    }

    public readonly Light light => (Light)ObjectRegistry.Find(instance)!;
    public LightType lightType { get; set; }

    /// <summary>Linear; intensity and color temperature included.</summary>
    public Color finalColor { get; set; }

    /// <summary>What it may light of the picture, from (0, 0) at the bottom left to (1, 1).</summary>
    public Rect screenRect { get; set; }

    public Matrix4x4 localToWorldMatrix { get; set; }
    public float range { get; set; }
    public float spotAngle { get; set; }
    public bool intersectsNearPlane { get; set; }
    public bool intersectsFarPlane { get; set; }
}
