// Compiles compute kernels for a graphics chip that need not be there, and prints what the driver states of their code
// (VK_KHR_pipeline_executable_properties). Mesa's driver for AMD compiles for RADV_FORCE_FAMILY without a device.
//   kernel_figures FILE.spv...
// The first line is the driver's version, the others are FILE,REGISTERS,WAVES,LDS_BYTES,SPILLS: vector registers of an
// invocation, waves that a SIMD unit holds at once, shared memory of a work group, spilled registers and bytes of
// scratch memory. Exit code 77 without a driver.
#include <vulkan/vulkan.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace {

void require(VkResult result, const char* what) {
  if (result == VK_SUCCESS) return;
  std::fprintf(stderr, "kernel_figures: %s: Vulkan error %d\n", what, static_cast<int>(result));
  std::exit(1);
}

std::vector<std::uint32_t> read_words(const char* path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  std::vector<std::uint32_t> words(bytes.size() / sizeof(std::uint32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(std::uint32_t));
  return words;
}

/// The blocks of a module: storage and uniform ones, by the numbers that glslang gave them.
std::vector<VkDescriptorSetLayoutBinding> bindings_of(const std::vector<std::uint32_t>& words) {
  constexpr std::uint32_t kDecorate = 71, kBinding = 33, kVariable = 59, kStorageBuffer = 12;
  constexpr std::size_t kHeader = 5;
  std::map<std::uint32_t, std::uint32_t> number, storage_class;  // of a variable
  for (std::size_t i = kHeader; i < words.size(); i += words[i] >> 16) {
    const std::uint32_t code = words[i] & 0xffff;
    if (code == kDecorate && words[i + 2] == kBinding) number[words[i + 1]] = words[i + 3];
    if (code == kVariable) storage_class[words[i + 2]] = words[i + 3];
  }
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const auto& [variable, binding] : number)
    bindings.push_back({binding,
                        storage_class[variable] == kStorageBuffer ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER
                                                                  : VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER,
                        1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
  return bindings;
}

class Driver {
 public:
  Driver() {
    VkApplicationInfo application{};
    application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
    application.apiVersion = VK_API_VERSION_1_2;
    VkInstanceCreateInfo instance_info{};
    instance_info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
    instance_info.pApplicationInfo = &application;
    VkInstance instance = nullptr;
    std::uint32_t count = 1;
    VkPhysicalDevice chip = nullptr;
    if (vkCreateInstance(&instance_info, nullptr, &instance) != VK_SUCCESS ||
        vkEnumeratePhysicalDevices(instance, &count, &chip) < VK_SUCCESS || count == 0)
      std::exit(77);
    VkPhysicalDeviceDriverProperties driver{};
    driver.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES;
    VkPhysicalDeviceProperties2 properties{};
    properties.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2;
    properties.pNext = &driver;
    vkGetPhysicalDeviceProperties2(chip, &properties);
    std::printf("%s\n", driver.driverInfo);

    VkPhysicalDevicePipelineExecutablePropertiesFeaturesKHR feature{};
    feature.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PIPELINE_EXECUTABLE_PROPERTIES_FEATURES_KHR;
    feature.pipelineExecutableInfo = VK_TRUE;
    const float priority = 1;
    VkDeviceQueueCreateInfo queue{};
    queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
    queue.queueCount = 1;
    queue.pQueuePriorities = &priority;
    const char* const extension = VK_KHR_PIPELINE_EXECUTABLE_PROPERTIES_EXTENSION_NAME;
    VkDeviceCreateInfo device_info{};
    device_info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
    device_info.pNext = &feature;
    device_info.queueCreateInfoCount = 1;
    device_info.pQueueCreateInfos = &queue;
    device_info.enabledExtensionCount = 1;
    device_info.ppEnabledExtensionNames = &extension;
    require(vkCreateDevice(chip, &device_info, nullptr, &device_), "no device");
    statistics_ = reinterpret_cast<PFN_vkGetPipelineExecutableStatisticsKHR>(
        vkGetDeviceProcAddr(device_, "vkGetPipelineExecutableStatisticsKHR"));
  }

  /// By the driver's names.
  std::map<std::string, unsigned long long> figures_of(const char* path) const {
    const std::vector<std::uint32_t> words = read_words(path);
    const std::vector<VkDescriptorSetLayoutBinding> bindings = bindings_of(words);
    VkDescriptorSetLayoutCreateInfo set_info{};
    set_info.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
    set_info.bindingCount = static_cast<std::uint32_t>(bindings.size());
    set_info.pBindings = bindings.data();
    VkDescriptorSetLayout set = nullptr;
    require(vkCreateDescriptorSetLayout(device_, &set_info, nullptr, &set), path);
    VkPipelineLayoutCreateInfo layout_info{};
    layout_info.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
    layout_info.setLayoutCount = 1;
    layout_info.pSetLayouts = &set;
    VkPipelineLayout layout = nullptr;
    require(vkCreatePipelineLayout(device_, &layout_info, nullptr, &layout), path);
    VkShaderModuleCreateInfo module_info{};
    module_info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
    module_info.codeSize = words.size() * sizeof(std::uint32_t);
    module_info.pCode = words.data();
    VkShaderModule module = nullptr;
    require(vkCreateShaderModule(device_, &module_info, nullptr, &module), path);
    VkComputePipelineCreateInfo pipeline_info{};
    pipeline_info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
    pipeline_info.flags = VK_PIPELINE_CREATE_CAPTURE_STATISTICS_BIT_KHR;
    pipeline_info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    pipeline_info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    pipeline_info.stage.module = module;
    pipeline_info.stage.pName = "main";
    pipeline_info.layout = layout;
    VkPipeline pipeline = nullptr;
    require(vkCreateComputePipelines(device_, nullptr, 1, &pipeline_info, nullptr, &pipeline), path);

    VkPipelineExecutableInfoKHR executable{};
    executable.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_INFO_KHR;
    executable.pipeline = pipeline;
    std::uint32_t count = 0;
    require(statistics_(device_, &executable, &count, nullptr), path);
    VkPipelineExecutableStatisticKHR empty{};
    empty.sType = VK_STRUCTURE_TYPE_PIPELINE_EXECUTABLE_STATISTIC_KHR;
    std::vector<VkPipelineExecutableStatisticKHR> statistics(count, empty);
    require(statistics_(device_, &executable, &count, statistics.data()), path);
    std::map<std::string, unsigned long long> figures;
    for (const VkPipelineExecutableStatisticKHR& statistic : statistics) figures[statistic.name] = statistic.value.u64;
    return figures;
  }

 private:
  VkDevice device_ = nullptr;
  PFN_vkGetPipelineExecutableStatisticsKHR statistics_ = nullptr;
};

}  // namespace

int main(int count, char** arguments) {
  const Driver driver;
  for (int i = 1; i < count; ++i) {
    const auto figures = driver.figures_of(arguments[i]);
    std::printf("%s,%llu,%llu,%llu,%llu\n", arguments[i], figures.at("VGPRs"), figures.at("Subgroups per SIMD"),
                figures.at("LDS size"),
                figures.at("Spilled SGPRs") + figures.at("Spilled VGPRs") + figures.at("Scratch size"));
  }
}
