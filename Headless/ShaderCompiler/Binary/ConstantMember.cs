namespace Headless.Shaders;

/// <summary>One member of a constant buffer, at its D3D11 offset.</summary>
/// <remarks>
/// Matrices are column-major unless declared row_major, as in D3D11: column c of a matrix begins at
/// Offset + 16 * c and holds Rows values. A writer of Unity's Matrix4x4 (itself column-major) copies its 64 bytes
/// as they are, and <c>mul(M, v)</c> is then M times the column v. With <see cref="RowMajor"/>, row r begins at
/// Offset + 16 * r and holds Columns values. Array elements begin ArrayStride bytes apart (a multiple of 16).
/// A member of a nested struct is listed by itself under its path: "light.colour", "lights[2].colour".
/// </remarks>
/// <param name="Offset">Bytes from the start of the constant buffer.</param>
/// <param name="Size">Bytes from the first to the last byte used; trailing padding of arrays is not counted.</param>
/// <param name="ArrayLength">Elements, 0 for a member that is no array.</param>
/// <param name="ArrayStride">Bytes between elements, 0 for a member that is no array.</param>
/// <param name="Type">HLSL scalar name: float, int, uint, double.</param>
public sealed record ConstantMember(
    string Name, int Offset, int Size, int ArrayLength, int ArrayStride, string Type, bool IsMatrix, int Rows, int Columns)
{
    public bool RowMajor { get; init; }

    /// <summary>Whether the shader reads it; a constant buffer has what it only declares, too.</summary>
    public bool IsRead { get; init; } = true;
}
