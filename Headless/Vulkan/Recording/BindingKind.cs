namespace Headless.Vulkan;

internal enum BindingKind : byte
{
    Empty,
    Buffer,
    Texture,
    Sampler,
    Uniform,
}
