namespace Headless.Shaders.SpirV;

internal enum SpirVDecoration : uint
{
    Block = 2,
    BufferBlock = 3,
    RowMajor = 4,
    ColMajor = 5,
    ArrayStride = 6,
    MatrixStride = 7,
    BuiltIn = 11,
    Flat = 14,
    NonWritable = 24,
    Location = 30,
    Component = 31,
    Binding = 33,
    DescriptorSet = 34,
    Offset = 35,
    NoContraction = 42,
    CounterBuffer = 5634,
    UserSemantic = 5635,
    UserType = 5636,
}

internal enum SpirVStorage : uint
{
    UniformConstant = 0,
    Input = 1,
    Uniform = 2,
    Output = 3,
    Workgroup = 4,
    Private = 6,
    Function = 7,
    StorageBuffer = 12,
}

internal enum SpirVExecutionMode : uint
{
    LocalSize = 17,
    InputPoints = 19,
    InputLines = 20,
    InputLinesAdjacency = 21,
    Triangles = 22,
    InputTrianglesAdjacency = 23,
}
