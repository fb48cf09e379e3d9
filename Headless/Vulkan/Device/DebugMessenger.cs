using System.Runtime.InteropServices;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Collects the validation layer's warnings and errors.</summary>
internal sealed unsafe class DebugMessenger : IDisposable
{
    private readonly VkInstance instance;
    private readonly VkExtensions extensions;
    private readonly List<string> messages = [];
    private readonly VkDebugUtilsMessengerEXT handle;
    private GCHandle self;

    public DebugMessenger(VkInstance instance, VkExtensions extensions)
    {
        this.instance = instance;
        this.extensions = extensions;
        self = GCHandle.Alloc(this);
        VkDebugUtilsMessengerCreateInfoEXT info = new()
        {
            messageSeverity = VkDebugUtilsMessageSeverityFlagsEXT.Warning | VkDebugUtilsMessageSeverityFlagsEXT.Error,
            messageType = VkDebugUtilsMessageTypeFlagsEXT.Validation | VkDebugUtilsMessageTypeFlagsEXT.General,
            pfnUserCallback = (nint)(delegate* unmanaged<uint, uint, VkDebugUtilsMessengerCallbackDataEXT*, void*, uint>)&OnMessage,
            pUserData = (void*)GCHandle.ToIntPtr(self),
        };
        VkDebugUtilsMessengerEXT created;
        extensions.vkCreateDebugUtilsMessengerEXT(instance, &info, null, &created).Check("Listening to the validation layer");
        handle = created;
    }

    public IReadOnlyList<string> Snapshot()
    {
        lock (messages)
        {
            return messages.ToArray();
        }
    }

    public void Dispose()
    {
        extensions.vkDestroyDebugUtilsMessengerEXT(instance, handle, null);
        self.Free();
    }

    [UnmanagedCallersOnly]
    private static uint OnMessage(uint severity, uint kind, VkDebugUtilsMessengerCallbackDataEXT* data, void* user)
    {
        DebugMessenger messenger = (DebugMessenger)GCHandle.FromIntPtr((nint)user).Target!;
        lock (messenger.messages)
        {
            messenger.messages.Add(Utf8Texts.Read(data->pMessage));
        }

        return 0;
    }
}
