using Headless.Vulkan.Native;

namespace Headless.Vulkan;

/// <summary>Writes a descriptor set from its content: three words a binding (see <see cref="DescriptorContent"/>).</summary>
internal sealed unsafe class DescriptorWriter(DeviceContext context)
{
    private VkWriteDescriptorSet[] writes = new VkWriteDescriptorSet[16];
    private VkDescriptorBufferInfo[] buffers = new VkDescriptorBufferInfo[16];
    private VkDescriptorImageInfo[] images = new VkDescriptorImageInfo[16];

    public void Write(VkDescriptorSet set, StageLayout layout, ReadOnlySpan<ulong> content)
    {
        int count = layout.Entries.Length;
        if (count > writes.Length)
        {
            writes = new VkWriteDescriptorSet[count];
            buffers = new VkDescriptorBufferInfo[count];
            images = new VkDescriptorImageInfo[count];
        }

        fixed (VkWriteDescriptorSet* write = writes)
        fixed (VkDescriptorBufferInfo* buffer = buffers)
        fixed (VkDescriptorImageInfo* image = images)
        {
            for (int i = 0; i < count; i++)
            {
                LayoutEntry entry = layout.Entries[i];
                ReadOnlySpan<ulong> words = content.Slice(i * DescriptorContent.Words, DescriptorContent.Words);
                write[i] = new VkWriteDescriptorSet
                {
                    dstSet = set,
                    dstBinding = (uint)entry.Binding,
                    descriptorCount = 1,
                    descriptorType = entry.Type,
                };
                switch (entry.Type)
                {
                    case VkDescriptorType.StorageBuffer or VkDescriptorType.UniformBufferDynamic:
                        buffer[i] = new VkDescriptorBufferInfo { buffer = new VkBuffer(words[0]), offset = words[1], range = words[2] };
                        write[i].pBufferInfo = buffer + i;
                        break;
                    case VkDescriptorType.Sampler:
                        image[i] = new VkDescriptorImageInfo { sampler = new VkSampler(words[0]) };
                        write[i].pImageInfo = image + i;
                        break;
                    default:
                        image[i] = new VkDescriptorImageInfo { imageView = new VkImageView(words[0]), imageLayout = (VkImageLayout)words[1] };
                        write[i].pImageInfo = image + i;
                        break;
                }
            }

            Vk.vkUpdateDescriptorSets(context.Handle, (uint)count, write, 0, null);
        }
    }
}
