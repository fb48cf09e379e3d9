namespace Headless.Shaders.SpirV;

/// <summary>Numbers every resource of a stage: one set a stage, a binding of its own for each resource.</summary>
internal static class DescriptorNumbers
{
    public static void Assign(SpirVIndex index, int set)
    {
        uint binding = 0;
        foreach (SpirVInstruction variable in index.Variables.ToList())
        {
            if ((SpirVStorage)variable[2] is SpirVStorage.UniformConstant or SpirVStorage.Uniform or SpirVStorage.StorageBuffer)
            {
                index.Set(variable[1], SpirVDecoration.DescriptorSet, (uint)set);
                index.Set(variable[1], SpirVDecoration.Binding, binding++);
            }
        }
    }
}
