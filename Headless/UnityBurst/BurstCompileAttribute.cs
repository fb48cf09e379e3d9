namespace Unity.Burst;

/// <summary>Marks a job for Unity's compiler; nothing reads it here.</summary>
[AttributeUsage(AttributeTargets.Class | AttributeTargets.Struct | AttributeTargets.Method | AttributeTargets.Assembly)]
public class BurstCompileAttribute : Attribute
{
    public BurstCompileAttribute() { }

    public BurstCompileAttribute(FloatPrecision floatPrecision, FloatMode floatMode)
    {
        FloatPrecision = floatPrecision;
        FloatMode = floatMode;
    }

    public FloatMode FloatMode { get; set; }
    public FloatPrecision FloatPrecision { get; set; }
    public OptimizeFor OptimizeFor { get; set; }
    public bool CompileSynchronously { get; set; }
    public bool Debug { get; set; }
    public bool DisableSafetyChecks { get; set; }
}
