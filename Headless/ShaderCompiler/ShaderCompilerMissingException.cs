namespace Headless.Shaders;

/// <summary>Something is not in the cache and there is no compiler to make it.</summary>
public sealed class ShaderCompilerMissingException(string owner, string program, string cacheDirectory)
    : Exception(
        $"{owner} is not in the shader cache '{cacheDirectory}' and '{program}' was not found: install the package glslang-tools, or "
        + "copy the cache from a machine that has run the project");
