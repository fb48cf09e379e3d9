using System.Collections.Generic;

namespace UnityEngine.Rendering;

public static class CommandBufferPool
{
    private static readonly Stack<CommandBuffer> Free = [];

    public static CommandBuffer Get() => Get(string.Empty);

    public static CommandBuffer Get(string name)
    {
        CommandBuffer buffer = Free.TryPop(out CommandBuffer? free) ? free : new CommandBuffer();
        buffer.name = name;
        return buffer;
    }

    public static void Release(CommandBuffer buffer)
    {
        buffer.Clear();
        Free.Push(buffer);
    }
}
