// A Vulkan layer that makes any device look like a graphics card: memory that the host cannot map, full of what was there before, and
// that ends; large alignments; and, where it is asked for, a queue whose times come from a model, so that what is measured can be compared
// with what it should be. Settings are variables of the environment:
//   CARD_MEMORY_MIB=N    memory of the card [8192]
//   CARD_DISPATCH_NS=N   times are modelled: nothing is computed or drawn, and each dispatch or draw takes N ns
//   CARD_GROUP_NS=N      and each of its groups N ns [0]
//   CARD_STAMP_NS=N      and each timestamp N ns [0]
//   CARD_IDLE_NS=N       and the queue waits N ns for each submission [0]
// At the end it says on standard error how many submissions there were, how long the longest took, and how long all.
#include <vulkan/vulkan.h>
#include <vulkan/vk_layer.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define EXPORT __attribute__((visibility("default")))
#define DIRTY 0x5a

static PFN_vkGetInstanceProcAddr next_instance_function;
static PFN_vkGetDeviceProcAddr next_device_function;
static VkInstance the_instance;

// What the next layer, or the driver, has under these names.
#define OF_INSTANCE(F) F(GetPhysicalDeviceProperties) F(GetPhysicalDeviceProperties2) F(GetPhysicalDeviceMemoryProperties) \
    F(GetPhysicalDeviceMemoryProperties2)
#define OF_DEVICE(F) F(GetBufferMemoryRequirements) F(GetImageMemoryRequirements) F(AllocateMemory) F(FreeMemory) F(MapMemory) \
    F(UnmapMemory) F(CmdWriteTimestamp) F(GetQueryPoolResults) F(BeginCommandBuffer) F(QueueSubmit) \
    F(CmdDispatch) F(CmdDispatchIndirect) F(CmdDraw) F(CmdDrawIndexed) F(CmdDrawIndirect) F(CmdDrawIndexedIndirect)
#define DECLARE(name) static PFN_vk##name next_##name;
OF_INSTANCE(DECLARE)
OF_DEVICE(DECLARE)

static double setting(const char *name, double otherwise)
{
    const char *value = getenv(name);
    return value && *value ? atof(value) : otherwise;
}

static int is_modelled(void) { return setting("CARD_DISPATCH_NS", -1) >= 0; }

// Memory. A card's own, a window of it that the host sees, and the machine's.

enum { OWN_HEAP, MACHINE_HEAP, WINDOW_HEAP, HEAPS };
enum { ALLOCATIONS = 8192 };

static const struct { uint32_t flags, heap; } types[] = {
    { 0, MACHINE_HEAP },
    { VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, OWN_HEAP },
    { VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT, MACHINE_HEAP },
    { VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, MACHINE_HEAP },
    { VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT, WINDOW_HEAP },
};
enum { TYPES = sizeof types / sizeof *types, MAPPABLE = 0x1c };

static VkDeviceSize used[HEAPS];
static struct { VkDeviceMemory memory; VkDeviceSize size; uint32_t type; } allocations[ALLOCATIONS];

static VkDeviceSize size_of_heap(uint32_t heap)
{
    switch (heap)
    {
        case OWN_HEAP: return (VkDeviceSize)(setting("CARD_MEMORY_MIB", 8192) * 1048576.0);
        case WINDOW_HEAP: return (VkDeviceSize)246 << 20;
        default: return (VkDeviceSize)64 << 30;
    }
}

static void show_memory(VkPhysicalDeviceMemoryProperties *memory)
{
    memset(memory, 0, sizeof *memory);
    memory->memoryHeapCount = HEAPS;
    for (uint32_t i = 0; i < HEAPS; i++)
    {
        memory->memoryHeaps[i].size = size_of_heap(i);
        memory->memoryHeaps[i].flags = i == MACHINE_HEAP ? 0 : VK_MEMORY_HEAP_DEVICE_LOCAL_BIT;
    }
    memory->memoryTypeCount = TYPES;
    for (uint32_t i = 0; i < TYPES; i++) memory->memoryTypes[i] = (VkMemoryType){ types[i].flags, types[i].heap };
}

static int place_of(VkDeviceMemory memory)
{
    for (int i = 0; i < ALLOCATIONS; i++)
        if (allocations[i].memory == memory) return i;
    return -1;
}

static VKAPI_ATTR void VKAPI_CALL card_GetPhysicalDeviceMemoryProperties(VkPhysicalDevice d, VkPhysicalDeviceMemoryProperties *memory)
{
    (void)d;
    show_memory(memory);
}

static VKAPI_ATTR void VKAPI_CALL card_GetPhysicalDeviceMemoryProperties2(VkPhysicalDevice d, VkPhysicalDeviceMemoryProperties2 *memory)
{
    (void)d;
    show_memory(&memory->memoryProperties);
}

static VKAPI_ATTR void VKAPI_CALL card_GetBufferMemoryRequirements(VkDevice d, VkBuffer buffer, VkMemoryRequirements *needs)
{
    next_GetBufferMemoryRequirements(d, buffer, needs);
    needs->memoryTypeBits = (1u << TYPES) - 1;
    if (needs->alignment < 256) needs->alignment = 256;
}

static VKAPI_ATTR void VKAPI_CALL card_GetImageMemoryRequirements(VkDevice d, VkImage image, VkMemoryRequirements *needs)
{
    next_GetImageMemoryRequirements(d, image, needs);
    needs->memoryTypeBits = ((1u << TYPES) - 1) & ~MAPPABLE;
    if (needs->alignment < 65536) needs->alignment = 65536;
    needs->size = (needs->size + 65535) & ~(VkDeviceSize)65535;
}

// All types are the device's first one, which the host can map.
static VKAPI_ATTR VkResult VKAPI_CALL card_AllocateMemory(
    VkDevice d, const VkMemoryAllocateInfo *info, const VkAllocationCallbacks *allocator, VkDeviceMemory *memory)
{
    uint32_t type = info->memoryTypeIndex, heap = types[type].heap;
    if (used[heap] + info->allocationSize > size_of_heap(heap)) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    int place = place_of(VK_NULL_HANDLE);
    if (place < 0) return VK_ERROR_TOO_MANY_OBJECTS;
    VkMemoryAllocateInfo first = *info;
    first.memoryTypeIndex = 0;
    VkResult result = next_AllocateMemory(d, &first, allocator, memory);
    if (result != VK_SUCCESS) return result;
    used[heap] += info->allocationSize;
    allocations[place].memory = *memory;
    allocations[place].size = info->allocationSize;
    allocations[place].type = type;
    void *bytes;
    // Where nothing is computed, nothing is read.
    if (!is_modelled() && next_MapMemory(d, *memory, 0, VK_WHOLE_SIZE, 0, &bytes) == VK_SUCCESS)
    {
        memset(bytes, DIRTY, info->allocationSize);
        next_UnmapMemory(d, *memory);
    }
    return VK_SUCCESS;
}

static VKAPI_ATTR void VKAPI_CALL card_FreeMemory(VkDevice d, VkDeviceMemory memory, const VkAllocationCallbacks *allocator)
{
    int place = memory ? place_of(memory) : -1;
    if (place >= 0)
    {
        used[types[allocations[place].type].heap] -= allocations[place].size;
        allocations[place].memory = VK_NULL_HANDLE;
    }
    next_FreeMemory(d, memory, allocator);
}

static VKAPI_ATTR VkResult VKAPI_CALL card_MapMemory(
    VkDevice d, VkDeviceMemory memory, VkDeviceSize offset, VkDeviceSize size, VkMemoryMapFlags flags, void **bytes)
{
    int place = place_of(memory);
    if (place >= 0 && !(MAPPABLE & 1u << allocations[place].type)) return VK_ERROR_MEMORY_MAP_FAILED;
    return next_MapMemory(d, memory, offset, size, flags, bytes);
}

// What the card says of itself.

static void show_card(VkPhysicalDeviceProperties *properties)
{
    properties->deviceType = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU;
    snprintf(properties->deviceName, sizeof properties->deviceName, "Imitated card");
    properties->limits.minUniformBufferOffsetAlignment = 256;
    properties->limits.minStorageBufferOffsetAlignment = 64;
    properties->limits.nonCoherentAtomSize = 64;
    properties->limits.maxMemoryAllocationCount = 4096;
    properties->limits.timestampPeriod = 1;
}

static VKAPI_ATTR void VKAPI_CALL card_GetPhysicalDeviceProperties(VkPhysicalDevice d, VkPhysicalDeviceProperties *properties)
{
    next_GetPhysicalDeviceProperties(d, properties);
    show_card(properties);
}

static VKAPI_ATTR void VKAPI_CALL card_GetPhysicalDeviceProperties2(VkPhysicalDevice d, VkPhysicalDeviceProperties2 *properties)
{
    next_GetPhysicalDeviceProperties2(d, properties);
    show_card(&properties->properties);
}

// Modelled times. A command buffer has a length; a submission begins when the one before it has ended and the queue has waited.

enum { BUFFERS = 64, STAMPS = 8192, POOLS = 64 };

static struct { VkCommandBuffer handle; double length; int count; struct { VkQueryPool pool; uint32_t query; double at; } stamps[STAMPS]; }
    buffers[BUFFERS];
static struct { VkQueryPool handle; uint64_t at[STAMPS]; } pools[POOLS];
static double queue_end, busy, longest;
static long submissions;

static int buffer_of(VkCommandBuffer handle)
{
    int i = 0;
    while (i < BUFFERS - 1 && buffers[i].handle != handle && buffers[i].handle != NULL) i++;
    buffers[i].handle = handle;
    return i;
}

static int pool_of(VkQueryPool handle)
{
    int i = 0;
    while (i < POOLS - 1 && pools[i].handle != handle && pools[i].handle != VK_NULL_HANDLE) i++;
    pools[i].handle = handle;
    return i;
}

static void work(VkCommandBuffer commands, double groups)
{
    buffers[buffer_of(commands)].length += setting("CARD_DISPATCH_NS", 0) + groups * setting("CARD_GROUP_NS", 0);
}

static VKAPI_ATTR VkResult VKAPI_CALL card_BeginCommandBuffer(VkCommandBuffer commands, const VkCommandBufferBeginInfo *info)
{
    int i = buffer_of(commands);
    buffers[i].length = 0;
    buffers[i].count = 0;
    return next_BeginCommandBuffer(commands, info);
}

static VKAPI_ATTR void VKAPI_CALL card_CmdWriteTimestamp(VkCommandBuffer commands, VkPipelineStageFlagBits s, VkQueryPool pool, uint32_t query)
{
    (void)s;
    int i = buffer_of(commands);
    buffers[i].length += setting("CARD_STAMP_NS", 0);
    if (buffers[i].count == STAMPS || query >= STAMPS) return;
    int n = buffers[i].count++;
    buffers[i].stamps[n].pool = pool;
    buffers[i].stamps[n].query = query;
    buffers[i].stamps[n].at = buffers[i].length;
}

static VKAPI_ATTR VkResult VKAPI_CALL card_QueueSubmit(VkQueue queue, uint32_t count, const VkSubmitInfo *infos, VkFence fence)
{
    queue_end += setting("CARD_IDLE_NS", 0);
    double length = 0;
    for (uint32_t a = 0; a < count; a++)
    {
        for (uint32_t b = 0; b < infos[a].commandBufferCount; b++)
        {
            int i = buffer_of(infos[a].pCommandBuffers[b]);
            for (int n = 0; n < buffers[i].count; n++)
                pools[pool_of(buffers[i].stamps[n].pool)].at[buffers[i].stamps[n].query] =
                    (uint64_t)(queue_end + length + buffers[i].stamps[n].at);
            length += buffers[i].length;
        }
    }
    submissions++;
    busy += length;
    queue_end += length;
    if (length > longest) longest = length;
    return next_QueueSubmit(queue, count, infos, fence);
}

static VKAPI_ATTR VkResult VKAPI_CALL card_GetQueryPoolResults(VkDevice d, VkQueryPool pool, uint32_t first, uint32_t count, size_t size,
    void *data, VkDeviceSize stride, VkQueryResultFlags flags)
{
    (void)d, (void)size, (void)flags;
    int i = pool_of(pool);
    for (uint32_t n = 0; n < count; n++) *(uint64_t *)((char *)data + n * stride) = pools[i].at[(first + n) % STAMPS];
    return VK_SUCCESS;
}

static VKAPI_ATTR void VKAPI_CALL card_CmdDispatch(VkCommandBuffer c, uint32_t x, uint32_t y, uint32_t z) { work(c, (double)x * y * z); }
static VKAPI_ATTR void VKAPI_CALL card_CmdDispatchIndirect(VkCommandBuffer c, VkBuffer b, VkDeviceSize o)
{
    (void)b, (void)o;
    work(c, 0);
}
static VKAPI_ATTR void VKAPI_CALL card_CmdDraw(VkCommandBuffer c, uint32_t v, uint32_t n, uint32_t f, uint32_t i)
{
    (void)v, (void)n, (void)f, (void)i;
    work(c, 0);
}
static VKAPI_ATTR void VKAPI_CALL card_CmdDrawIndexed(VkCommandBuffer c, uint32_t v, uint32_t n, uint32_t f, int32_t o, uint32_t i)
{
    (void)v, (void)n, (void)f, (void)o, (void)i;
    work(c, 0);
}
static VKAPI_ATTR void VKAPI_CALL card_CmdDrawIndirect(VkCommandBuffer c, VkBuffer b, VkDeviceSize o, uint32_t n, uint32_t s)
{
    (void)b, (void)o, (void)n, (void)s;
    work(c, 0);
}
#define card_CmdDrawIndexedIndirect card_CmdDrawIndirect

static void say_sum(void)
{
    fprintf(stderr, "[card] %ld submissions, the longest of %.0f ns, %.0f ns in all\n", submissions, longest, busy);
}

// The layer.

static void *link_of(const void *info, VkStructureType type)
{
    // Both kinds of link begin alike.
    const VkLayerDeviceCreateInfo *link = info;
    while (link && !(link->sType == type && link->function == VK_LAYER_LINK_INFO)) link = link->pNext;
    return (void *)link;
}

static VKAPI_ATTR VkResult VKAPI_CALL card_CreateInstance(
    const VkInstanceCreateInfo *info, const VkAllocationCallbacks *allocator, VkInstance *instance)
{
    VkLayerInstanceCreateInfo *link = link_of(info->pNext, VK_STRUCTURE_TYPE_LOADER_INSTANCE_CREATE_INFO);
    if (!link) return VK_ERROR_INITIALIZATION_FAILED;
    next_instance_function = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    VkResult result = ((PFN_vkCreateInstance)next_instance_function(VK_NULL_HANDLE, "vkCreateInstance"))(info, allocator, instance);
    if (result != VK_SUCCESS) return result;
    the_instance = *instance;
#define TAKE(name) next_##name = (PFN_vk##name)next_instance_function(*instance, "vk" #name);
    OF_INSTANCE(TAKE)
#undef TAKE
    static int once;
    if (is_modelled() && !once++) atexit(say_sum);
    return VK_SUCCESS;
}

static VKAPI_ATTR VkResult VKAPI_CALL card_CreateDevice(
    VkPhysicalDevice physical, const VkDeviceCreateInfo *info, const VkAllocationCallbacks *allocator, VkDevice *device)
{
    VkLayerDeviceCreateInfo *link = link_of(info->pNext, VK_STRUCTURE_TYPE_LOADER_DEVICE_CREATE_INFO);
    if (!link) return VK_ERROR_INITIALIZATION_FAILED;
    PFN_vkGetInstanceProcAddr next = link->u.pLayerInfo->pfnNextGetInstanceProcAddr;
    next_device_function = link->u.pLayerInfo->pfnNextGetDeviceProcAddr;
    link->u.pLayerInfo = link->u.pLayerInfo->pNext;
    VkResult result = ((PFN_vkCreateDevice)next(the_instance, "vkCreateDevice"))(physical, info, allocator, device);
    if (result != VK_SUCCESS) return result;
#define TAKE(name) next_##name = (PFN_vk##name)next_device_function(*device, "vk" #name);
    OF_DEVICE(TAKE)
#undef TAKE
    return VK_SUCCESS;
}

EXPORT VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL card_GetInstanceProcAddr(VkInstance instance, const char *name);
static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL card_GetDeviceProcAddr(VkDevice device, const char *name);

static PFN_vkVoidFunction own(const char *name)
{
#define OWN(f) if (!strcmp(name, "vk" #f)) return (PFN_vkVoidFunction)card_##f;
    OWN(CreateInstance) OWN(CreateDevice) OWN(GetInstanceProcAddr) OWN(GetDeviceProcAddr)
    OF_INSTANCE(OWN)
    OWN(GetBufferMemoryRequirements) OWN(GetImageMemoryRequirements) OWN(AllocateMemory) OWN(FreeMemory) OWN(MapMemory)
    if (!is_modelled()) return NULL;
    OWN(BeginCommandBuffer) OWN(CmdWriteTimestamp) OWN(QueueSubmit) OWN(GetQueryPoolResults) OWN(CmdDispatch) OWN(CmdDispatchIndirect)
    OWN(CmdDraw) OWN(CmdDrawIndexed) OWN(CmdDrawIndirect) OWN(CmdDrawIndexedIndirect)
    return NULL;
}

static VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL card_GetDeviceProcAddr(VkDevice device, const char *name)
{
    PFN_vkVoidFunction function = own(name);
    return function ? function : next_device_function(device, name);
}

EXPORT VKAPI_ATTR PFN_vkVoidFunction VKAPI_CALL card_GetInstanceProcAddr(VkInstance instance, const char *name)
{
    PFN_vkVoidFunction function = own(name);
    return function || !next_instance_function ? function : next_instance_function(instance, name);
}

EXPORT VKAPI_ATTR VkResult VKAPI_CALL vkNegotiateLoaderLayerInterfaceVersion(VkNegotiateLayerInterface *version)
{
    if (version->loaderLayerInterfaceVersion > 2) version->loaderLayerInterfaceVersion = 2;
    version->pfnGetInstanceProcAddr = card_GetInstanceProcAddr;
    version->pfnGetDeviceProcAddr = card_GetDeviceProcAddr;
    version->pfnGetPhysicalDeviceProcAddr = NULL;
    return VK_SUCCESS;
}
