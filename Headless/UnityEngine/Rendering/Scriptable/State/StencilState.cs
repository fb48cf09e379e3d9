namespace UnityEngine.Rendering;

public record struct StencilState
{
    public StencilState(
        bool enabled = true, byte readMask = 255, byte writeMask = 255, CompareFunction compareFunction = CompareFunction.Always,
        StencilOp passOperation = StencilOp.Keep, StencilOp failOperation = StencilOp.Keep, StencilOp zFailOperation = StencilOp.Keep)
        : this(
            enabled, readMask, writeMask, compareFunction, passOperation, failOperation, zFailOperation,
            compareFunction, passOperation, failOperation, zFailOperation)
    {
    }

    public StencilState(
        bool enabled, byte readMask, byte writeMask,
        CompareFunction compareFunctionFront, StencilOp passOperationFront, StencilOp failOperationFront, StencilOp zFailOperationFront,
        CompareFunction compareFunctionBack, StencilOp passOperationBack, StencilOp failOperationBack, StencilOp zFailOperationBack)
    {
        this.enabled = enabled;
        this.readMask = readMask;
        this.writeMask = writeMask;
        this.compareFunctionFront = compareFunctionFront;
        this.passOperationFront = passOperationFront;
        this.failOperationFront = failOperationFront;
        this.zFailOperationFront = zFailOperationFront;
        this.compareFunctionBack = compareFunctionBack;
        this.passOperationBack = passOperationBack;
        this.failOperationBack = failOperationBack;
        this.zFailOperationBack = zFailOperationBack;
    }

    public static StencilState defaultValue => new(true);

    public bool enabled { get; set; }
    public byte readMask { get; set; }
    public byte writeMask { get; set; }
    public CompareFunction compareFunctionFront { get; set; }
    public StencilOp passOperationFront { get; set; }
    public StencilOp failOperationFront { get; set; }
    public StencilOp zFailOperationFront { get; set; }
    public CompareFunction compareFunctionBack { get; set; }
    public StencilOp passOperationBack { get; set; }
    public StencilOp failOperationBack { get; set; }
    public StencilOp zFailOperationBack { get; set; }

    public void SetCompareFunction(CompareFunction value) => (compareFunctionFront, compareFunctionBack) = (value, value);

    public void SetPassOperation(StencilOp value) => (passOperationFront, passOperationBack) = (value, value);

    public void SetFailOperation(StencilOp value) => (failOperationFront, failOperationBack) = (value, value);

    public void SetZFailOperation(StencilOp value) => (zFailOperationFront, zFailOperationBack) = (value, value);
}
