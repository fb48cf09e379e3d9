namespace UnityEngine.Rendering;

public record struct DepthState
{
    public DepthState(bool writeEnabled = true, CompareFunction compareFunction = CompareFunction.Less)
    {
        this.writeEnabled = writeEnabled;
        this.compareFunction = compareFunction;
    }

    public static DepthState defaultValue => new(true);

    public bool writeEnabled { get; set; }
    public CompareFunction compareFunction { get; set; }
}
