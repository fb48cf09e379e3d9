namespace Headless.Player.Commands;

/// <summary>Flags that several commands of the player have.</summary>
internal static class CommonFlags
{
    public static Flag Project { get; } = new("--project", "DIR", "folder of the Unity project") { Hidden = true };
    public static Flag Assemblies { get; } = new("--assemblies", "DIR", "folder of its compiled scripts", "ScriptAssemblies beside the player") { Hidden = true };
    public static Flag Device { get; } = new("--device", "NAME|INDEX", "graphics device (./run devices lists them)", "a real GPU, else the CPU");
    public static Flag Pipeline { get; } = new("--pipeline", "NAME", "render pipeline", "the project's") { Choices = PipelineChoice.Names };
    public static Flag Validate { get; } = Flag.Switch("--validate", "with the Vulkan validation layers");

    public static Flag ExecuteMethod(string when) => new("--executeMethod", "Class.Method", $"a static method of the project, {when}") { Hidden = true };
}
