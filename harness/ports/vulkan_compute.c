/* Vulkan, headless: storage buffer 0 holds the inputs, buffer 1 the outputs, a push constant the rows.
 * Everything a run makes is destroyed after it; the device stays open between runs. */
#include "device.h"
#include "read_whole.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <vulkan/vulkan.h>

const char *const device_suffix = "spv";

enum { GROUP = 64 }; /* local_size_x of the generated shaders */

static VkInstance instance;
static VkPhysicalDevice physical;
static VkDevice device;
static VkQueue queue;
static uint32_t family;
static VkPhysicalDeviceProperties properties;

const char *device_name(void) { return properties.deviceName; }

/* The software rasteriser before any other: it is what every machine can install, so its rows compare. */
static int choose_physical(void)
{
    VkPhysicalDevice all[16];
    uint32_t n = 16, i;
    if (vkEnumeratePhysicalDevices(instance, &n, all) < 0 || n == 0)
        return 0;
    physical = all[0];
    for (i = 0; i < n; i++) {
        vkGetPhysicalDeviceProperties(all[i], &properties);
        if (properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU) {
            physical = all[i];
            break;
        }
    }
    vkGetPhysicalDeviceProperties(physical, &properties);
    return 1;
}

static int choose_family(void)
{
    VkQueueFamilyProperties all[16];
    uint32_t n = 16;
    vkGetPhysicalDeviceQueueFamilyProperties(physical, &n, all);
    for (family = 0; family < n; family++)
        if (all[family].queueFlags & VK_QUEUE_COMPUTE_BIT)
            return 1;
    return 0;
}

const char *device_open(void)
{
    const float priority = 1.0f;
    VkApplicationInfo app = {.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO, .apiVersion = VK_API_VERSION_1_1};
    VkInstanceCreateInfo ici = {.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO, .pApplicationInfo = &app};
    VkDeviceQueueCreateInfo qci = {
        .sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO, .queueCount = 1, .pQueuePriorities = &priority};
    VkDeviceCreateInfo dci = {
        .sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, .queueCreateInfoCount = 1, .pQueueCreateInfos = &qci};
    if (vkCreateInstance(&ici, NULL, &instance))
        return "no Vulkan driver";
    if (!choose_physical())
        return "no Vulkan device";
    if (!choose_family())
        return "the Vulkan device has no compute queue";
    qci.queueFamilyIndex = family;
    if (vkCreateDevice(physical, &dci, NULL, &device))
        return "the Vulkan device does not open";
    vkGetDeviceQueue(device, family, 0, &queue);
    return NULL;
}

void device_close(void)
{
    if (device)
        vkDestroyDevice(device, NULL);
    if (instance)
        vkDestroyInstance(instance, NULL);
}

struct buffer {
    VkBuffer handle;
    VkDeviceMemory memory;
    void *bytes;
};

static int buffer_make(struct buffer *b, VkDeviceSize size)
{
    const VkMemoryPropertyFlags want = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    VkBufferCreateInfo bci = {
        .sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO, .size = size, .usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT};
    VkMemoryAllocateInfo mai = {.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
    VkMemoryRequirements need;
    VkPhysicalDeviceMemoryProperties mem;
    uint32_t i;
    if (vkCreateBuffer(device, &bci, NULL, &b->handle))
        return 0;
    vkGetBufferMemoryRequirements(device, b->handle, &need);
    vkGetPhysicalDeviceMemoryProperties(physical, &mem);
    for (i = 0; i < mem.memoryTypeCount; i++)
        if ((need.memoryTypeBits >> i & 1) && (mem.memoryTypes[i].propertyFlags & want) == want)
            break;
    mai.allocationSize = need.size;
    mai.memoryTypeIndex = i;
    return i < mem.memoryTypeCount && !vkAllocateMemory(device, &mai, NULL, &b->memory) &&
           !vkBindBufferMemory(device, b->handle, b->memory, 0) &&
           !vkMapMemory(device, b->memory, 0, size, 0, &b->bytes);
}

static void buffer_free(struct buffer *b)
{
    vkDestroyBuffer(device, b->handle, NULL);
    vkFreeMemory(device, b->memory, NULL);
}

/* The objects of one run; zeros are valid arguments of every vkDestroy. */
struct job {
    struct buffer in, out;
    VkShaderModule shader;
    VkDescriptorSetLayout set_layout;
    VkPipelineLayout layout;
    VkPipeline pipeline;
    VkDescriptorPool sets;
    VkDescriptorSet set;
    VkCommandPool commands;
};

static const char *make_pipeline(struct job *j, const char *path)
{
    VkDescriptorSetLayoutBinding bind[2] = {{.binding = 0,
                                             .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                             .descriptorCount = 1,
                                             .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT},
                                            {.binding = 1,
                                             .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                             .descriptorCount = 1,
                                             .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT}};
    VkDescriptorSetLayoutCreateInfo sci = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO, .bindingCount = 2, .pBindings = bind};
    VkPushConstantRange push = {.stageFlags = VK_SHADER_STAGE_COMPUTE_BIT, .size = sizeof(uint32_t)};
    VkPipelineLayoutCreateInfo lci = {.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                      .setLayoutCount = 1,
                                      .pSetLayouts = &j->set_layout,
                                      .pushConstantRangeCount = 1,
                                      .pPushConstantRanges = &push};
    VkShaderModuleCreateInfo mci = {.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    VkComputePipelineCreateInfo pci = {.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    size_t size;
    void *code = read_whole(path, &size);
    VkResult bad;
    if (!code)
        return "cannot read the SPIR-V file";
    mci.codeSize = size;
    mci.pCode = code;
    bad = vkCreateShaderModule(device, &mci, NULL, &j->shader);
    free(code);
    if (bad)
        return "the driver refuses the shader";
    if (vkCreateDescriptorSetLayout(device, &sci, NULL, &j->set_layout) ||
        vkCreatePipelineLayout(device, &lci, NULL, &j->layout))
        return "no pipeline layout";
    pci.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    pci.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    pci.stage.module = j->shader;
    pci.stage.pName = "main";
    pci.layout = j->layout;
    return vkCreateComputePipelines(device, NULL, 1, &pci, NULL, &j->pipeline) ? "no pipeline" : NULL;
}

static const char *bind_buffers(struct job *j)
{
    VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 2};
    VkDescriptorPoolCreateInfo pci = {
        .sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO, .maxSets = 1, .poolSizeCount = 1, .pPoolSizes = &size};
    VkDescriptorSetAllocateInfo sai = {.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                       .descriptorSetCount = 1,
                                       .pSetLayouts = &j->set_layout};
    VkDescriptorBufferInfo info[2] = {{j->in.handle, 0, VK_WHOLE_SIZE}, {j->out.handle, 0, VK_WHOLE_SIZE}};
    VkWriteDescriptorSet write = {.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                                  .descriptorCount = 2,
                                  .descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                  .pBufferInfo = info};
    if (vkCreateDescriptorPool(device, &pci, NULL, &j->sets))
        return "no descriptor pool";
    sai.descriptorPool = j->sets;
    if (vkAllocateDescriptorSets(device, &sai, &j->set))
        return "no descriptor set";
    write.dstSet = j->set;
    vkUpdateDescriptorSets(device, 1, &write, 0, NULL);
    return NULL;
}

static const char *dispatch(struct job *j, uint32_t rows)
{
    VkCommandPoolCreateInfo pci = {.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO, .queueFamilyIndex = family};
    VkCommandBufferAllocateInfo cai = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                       .commandBufferCount = 1};
    VkCommandBufferBeginInfo begin = {.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    VkMemoryBarrier read_back = {.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                 .srcAccessMask = VK_ACCESS_SHADER_WRITE_BIT,
                                 .dstAccessMask = VK_ACCESS_HOST_READ_BIT};
    VkSubmitInfo submit = {.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO, .commandBufferCount = 1};
    VkCommandBuffer c;
    if (vkCreateCommandPool(device, &pci, NULL, &j->commands))
        return "no command pool";
    cai.commandPool = j->commands;
    if (vkAllocateCommandBuffers(device, &cai, &c) || vkBeginCommandBuffer(c, &begin))
        return "no command buffer";
    vkCmdBindPipeline(c, VK_PIPELINE_BIND_POINT_COMPUTE, j->pipeline);
    vkCmdBindDescriptorSets(c, VK_PIPELINE_BIND_POINT_COMPUTE, j->layout, 0, 1, &j->set, 0, NULL);
    vkCmdPushConstants(c, j->layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof rows, &rows);
    vkCmdDispatch(c, (rows + GROUP - 1) / GROUP, 1, 1);
    vkCmdPipelineBarrier(c, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_PIPELINE_STAGE_HOST_BIT, 0, 1, &read_back, 0, NULL,
                         0, NULL);
    submit.pCommandBuffers = &c;
    if (vkEndCommandBuffer(c) || vkQueueSubmit(queue, 1, &submit, VK_NULL_HANDLE) || vkQueueWaitIdle(queue))
        return "the dispatch fails";
    return NULL;
}

const char *device_run(const char *path, const float *in, unsigned n_in, float *out, unsigned n_out, size_t rows)
{
    struct job j;
    const char *bad;
    memset(&j, 0, sizeof j);
    if (rows == 0 || rows > properties.limits.maxComputeWorkGroupCount[0] * (size_t)GROUP)
        return "too many rows for one dispatch";
    if (!buffer_make(&j.in, rows * n_in * sizeof *in) || !buffer_make(&j.out, rows * n_out * sizeof *out)) {
        bad = "no memory on the device";
    } else {
        memcpy(j.in.bytes, in, rows * n_in * sizeof *in);
        memset(j.out.bytes, 0xff, rows * n_out * sizeof *out);
        bad = make_pipeline(&j, path);
        if (!bad)
            bad = bind_buffers(&j);
        if (!bad)
            bad = dispatch(&j, (uint32_t)rows);
        if (!bad)
            memcpy(out, j.out.bytes, rows * n_out * sizeof *out);
    }
    vkDestroyCommandPool(device, j.commands, NULL);
    vkDestroyDescriptorPool(device, j.sets, NULL);
    vkDestroyPipeline(device, j.pipeline, NULL);
    vkDestroyPipelineLayout(device, j.layout, NULL);
    vkDestroyDescriptorSetLayout(device, j.set_layout, NULL);
    vkDestroyShaderModule(device, j.shader, NULL);
    buffer_free(&j.in);
    buffer_free(&j.out);
    return bad;
}
