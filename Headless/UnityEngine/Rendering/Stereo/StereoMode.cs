namespace Headless.Engine;

/// <summary>How cameras that draw to the screen draw two eyes.</summary>
internal enum StereoMode
{
    /// <summary>One picture.</summary>
    Off,

    /// <summary>One eye after the other, each into a texture of its own.</summary>
    MultiPass,

    /// <summary>Both at once: the instances of each draw are doubled, and every other one goes to the second slice of an array.</summary>
    Instanced,
}
