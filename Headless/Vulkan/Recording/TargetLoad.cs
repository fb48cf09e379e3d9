namespace Headless.Vulkan;

/// <summary>What happens to a target's content when drawing begins.</summary>
public enum TargetLoad
{
    /// <summary>Kept.</summary>
    Load,

    /// <summary>Set to the clear value.</summary>
    Clear,

    /// <summary>Undefined; every texel will be drawn.</summary>
    Discard,
}
