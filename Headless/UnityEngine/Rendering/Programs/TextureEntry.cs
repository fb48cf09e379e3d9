namespace Headless.Engine;

/// <param name="Register">Number n of register(un) of a texture that is written; -1 for others.</param>
/// <param name="Dimension">"2D", "3D", "Cube", "2DArray"... as the shader declares it.</param>
internal readonly record struct TextureEntry(int NameId, string Name, int Binding, bool Storage, string Dimension, int Register);
