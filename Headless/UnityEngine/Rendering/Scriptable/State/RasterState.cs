namespace UnityEngine.Rendering;

public record struct RasterState
{
    public static readonly RasterState defaultValue = new(CullMode.Back);

    public RasterState(CullMode cullingMode = CullMode.Back, int offsetUnits = 0, float offsetFactor = 0f, bool depthClip = true)
    {
        this.cullingMode = cullingMode;
        this.offsetUnits = offsetUnits;
        this.offsetFactor = offsetFactor;
        this.depthClip = depthClip;
    }

    public CullMode cullingMode { get; set; }
    public bool depthClip { get; set; }
    public bool conservative { get; set; }
    public int offsetUnits { get; set; }
    public float offsetFactor { get; set; }
}
