using System.Runtime.InteropServices;
using System.Text;
using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Reads what VK_KHR_pipeline_executable_properties says of a pipeline.</summary>
internal sealed unsafe class ExecutableReader(DeviceContext context)
{
    private readonly VkDevice device = context.Handle;
    private readonly VkExtensions extensions = context.Instance.LoadExecutableFunctions();

    public IReadOnlyList<GpuExecutable> Read(GpuPipeline pipeline)
    {
        VkPipelineInfoKHR info = new() { pipeline = pipeline.Handle };
        uint count;
        extensions.vkGetPipelineExecutablePropertiesKHR(device, &info, &count, null).Check(What(pipeline));
        VkPipelineExecutablePropertiesKHR[] all = new VkPipelineExecutablePropertiesKHR[count];
        Array.Fill(all, new VkPipelineExecutablePropertiesKHR());
        List<GpuExecutable> executables = [];
        fixed (VkPipelineExecutablePropertiesKHR* first = all)
        {
            extensions.vkGetPipelineExecutablePropertiesKHR(device, &info, &count, first).Check(What(pipeline));
            for (uint i = 0; i < count; i++)
            {
                VkPipelineExecutableInfoKHR which = new() { pipeline = pipeline.Handle, executableIndex = i };
                executables.Add(new GpuExecutable(
                    Utf8Texts.Read(first[i].name), (int)first[i].subgroupSize, Statistics(which, pipeline), Listings(which, pipeline)));
            }
        }

        return executables;
    }

    private static string What(GpuPipeline pipeline) => $"Reading the compiled program of '{pipeline.Name}'";

    private Dictionary<string, double> Statistics(VkPipelineExecutableInfoKHR which, GpuPipeline pipeline)
    {
        uint count;
        extensions.vkGetPipelineExecutableStatisticsKHR(device, &which, &count, null).Check(What(pipeline));
        VkPipelineExecutableStatisticKHR[] all = new VkPipelineExecutableStatisticKHR[count];
        Array.Fill(all, new VkPipelineExecutableStatisticKHR());
        Dictionary<string, double> values = [];
        fixed (VkPipelineExecutableStatisticKHR* first = all)
        {
            extensions.vkGetPipelineExecutableStatisticsKHR(device, &which, &count, first).Check(What(pipeline));
            for (uint i = 0; i < count; i++)
            {
                VkPipelineExecutableStatisticValueKHR value = first[i].value;
                values[Utf8Texts.Read(first[i].name)] = first[i].format switch
                {
                    VkPipelineExecutableStatisticFormatKHR.Bool32 => value.b32,
                    VkPipelineExecutableStatisticFormatKHR.Int64 => value.i64,
                    VkPipelineExecutableStatisticFormatKHR.Uint64 => value.u64,
                    _ => value.f64,
                };
            }
        }

        return values;
    }

    // Sizes come with the first call, texts with the second.
    private Dictionary<string, string> Listings(VkPipelineExecutableInfoKHR which, GpuPipeline pipeline)
    {
        uint count;
        extensions.vkGetPipelineExecutableInternalRepresentationsKHR(device, &which, &count, null).Check(What(pipeline));
        VkPipelineExecutableInternalRepresentationKHR[] all = new VkPipelineExecutableInternalRepresentationKHR[count];
        Array.Fill(all, new VkPipelineExecutableInternalRepresentationKHR());
        Dictionary<string, string> texts = [];
        fixed (VkPipelineExecutableInternalRepresentationKHR* first = all)
        {
            extensions.vkGetPipelineExecutableInternalRepresentationsKHR(device, &which, &count, first).Check(What(pipeline));
            byte[][] data = [.. all.Select(r => GC.AllocateUninitializedArray<byte>((int)r.dataSize, pinned: true))];
            for (uint i = 0; i < count; i++)
            {
                first[i].pData = (void*)Marshal.UnsafeAddrOfPinnedArrayElement(data[i], 0);
            }

            extensions.vkGetPipelineExecutableInternalRepresentationsKHR(device, &which, &count, first).Check(What(pipeline));
            for (uint i = 0; i < count; i++)
            {
                if (first[i].isText != 0)
                {
                    texts[Utf8Texts.Read(first[i].name)] = Encoding.UTF8.GetString(data[i]).TrimEnd('\0');
                }
            }
        }

        return texts;
    }
}
