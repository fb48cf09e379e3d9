namespace Headless.Engine;

internal enum ShaderValueKind
{
    Float,
    Integer,
    Vector,
    Color,
    Matrix,
    FloatArray,
    VectorArray,
    MatrixArray,
}
