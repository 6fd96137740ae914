#include "meshes/msh_sections.h"

#include <fmt/format.h>

#include <unordered_map>

#include "meshes/msh_words.h"

namespace fretval::meshes {
namespace {

/// Physical groups of the geometrical entities (dimension, number), which version 4.1 has instead of those of elements.
using EntityGroups = std::map<std::pair<int, long long>, long long>;

/// Index of a node by its number in the file.
using NodeIndex = std::unordered_map<long long, unsigned>;

std::string type_name(int type) {
  switch (type) {
    case 4:
    case 5:
    case 6:
    case 7:
      return fmt::format("{} (solid)", type);
    case 8:
    case 9:
    case 10:
    case 16:
      return fmt::format("{} (second order)", type);
    default:
      return fmt::format("{}", type);
  }
}

std::size_t n_nodes_of(int type, long long element, const Words& words) {
  switch (type) {
    case msh_point:
      return 1;
    case msh_line:
      return 2;
    case msh_triangle:
      return 3;
    case msh_quadrilateral:
      return 4;
    default:
      words.fail(fmt::format("the type of element {}", element), type_name(type),
                 "3 (4-node quadrilateral), 2 (3-node triangle), 1 (2-node line) or 15 (point)");
  }
}

int dimension_of(int type) {
  return type == msh_point ? 0 : type == msh_line ? 1 : 2;
}

std::string read_version(Words& words) {
  words.expect("$MeshFormat");
  std::string version(words.next("the version"));
  if (version != "2.2" && version != "4.1") words.fail("the version of the format", version, "2.2 or 4.1");
  const auto is_binary = words.integer("the kind of file");
  if (is_binary != 0) words.fail("the kind of file", fmt::format("{} (binary)", is_binary), "0 (ASCII)");
  words.next("the size of a number");
  words.expect("$EndMeshFormat");
  return version;
}

void read_group_names(Words& words, MshSections& sections) {
  const std::size_t n = words.count("the number of physical names");
  for (std::size_t i = 0; i < n; ++i) {
    const auto dimension = static_cast<int>(words.integer("the dimension of a physical name"));
    const auto number = words.integer("the number of a physical name");
    sections.group_names[{dimension, number}] = words.quoted("a physical name");
  }
}

EntityGroups read_entities(Words& words) {
  EntityGroups groups;
  std::array<std::size_t, 4> n_entities{};
  for (auto& n : n_entities) n = words.count("the number of entities");
  for (int dimension = 0; dimension < 4; ++dimension) {
    for (std::size_t i = 0; i < n_entities[dimension]; ++i) {
      const auto entity = words.integer("the number of an entity");
      const int n_coordinates = dimension == 0 ? 3 : 6;
      for (int k = 0; k < n_coordinates; ++k) words.real("a coordinate of an entity");
      const std::size_t n_groups = words.count("the number of physical groups of an entity");
      if (n_groups > 1)
        words.fail(fmt::format("the number of physical groups of entity {} of dimension {}", entity, dimension),
                   fmt::format("{}", n_groups), "0 or 1");
      // gmsh marks an entity that runs against its group by a minus sign.
      if (n_groups == 1) groups[{dimension, entity}] = std::abs(words.integer("a physical group"));
      if (dimension == 0) continue;
      const std::size_t n_bounding = words.count("the number of bounding entities");
      for (std::size_t k = 0; k < n_bounding; ++k) words.integer("a bounding entity");
    }
  }
  return groups;
}

void add_node(long long number, Words& words, MshSections& sections, NodeIndex& index) {
  auto& node = sections.nodes.emplace_back();
  for (double& x : node) x = words.real("a coordinate of a node");
  sections.node_numbers.push_back(number);
  if (!index.emplace(number, static_cast<unsigned>(index.size())).second)
    words.fail("the number of a node", fmt::format("{}, a second time", number), "its own");
}

NodeIndex read_nodes_22(Words& words, MshSections& sections) {
  NodeIndex index;
  const std::size_t n = words.count("the number of nodes");
  for (std::size_t i = 0; i < n; ++i) add_node(words.integer("the number of a node"), words, sections, index);
  return index;
}

NodeIndex read_nodes_41(Words& words, MshSections& sections) {
  NodeIndex index;
  const std::size_t n_blocks = words.count("the number of node blocks");
  const std::size_t n = words.count("the number of nodes");
  for (const char* what : {"the smallest node number", "the largest node number"}) words.integer(what);
  for (std::size_t block = 0; block < n_blocks; ++block) {
    const auto dimension = words.integer("the dimension of a node block");
    words.integer("the entity of a node block");
    const bool parametric = words.integer("the parametric flag of a node block") != 0;
    std::vector<long long> numbers(words.count("the number of nodes of a block"));
    for (auto& number : numbers) number = words.integer("the number of a node");
    for (const long long number : numbers) {
      add_node(number, words, sections, index);
      for (long long k = 0; parametric && k < dimension; ++k) words.real("a parameter of a node");
    }
  }
  if (sections.nodes.size() != n)
    words.fail("the number of nodes", fmt::format("{}", sections.nodes.size()), fmt::format("{} as announced", n));
  return index;
}

void add_element(MshSections::Element element, Words& words, MshSections& sections, const NodeIndex& index) {
  const std::size_t n_nodes = n_nodes_of(element.type, element.number, words);
  for (std::size_t i = 0; i < n_nodes; ++i) {
    const auto number = words.integer("a node of an element");
    const auto found = index.find(number);
    if (found == index.end())
      words.fail(fmt::format("a node of element {}", element.number), fmt::format("{}", number),
                 "the number of a node of the file");
    element.nodes.push_back(found->second);
  }
  sections.elements.push_back(std::move(element));
}

void read_elements_22(Words& words, MshSections& sections, const NodeIndex& index) {
  const std::size_t n = words.count("the number of elements");
  for (std::size_t i = 0; i < n; ++i) {
    MshSections::Element element{words.integer("the number of an element"), 0, 0, {}};
    element.type = static_cast<int>(words.integer("the type of an element"));
    const std::size_t n_tags = words.count("the number of tags of an element");
    for (std::size_t k = 0; k < n_tags; ++k) {
      const auto tag = words.integer("a tag of an element");
      if (k == 0) element.group = std::abs(tag);
      if (k == 1) element.entity = tag;
    }
    add_element(std::move(element), words, sections, index);
  }
}

void read_elements_41(Words& words, MshSections& sections, const NodeIndex& index, const EntityGroups& groups) {
  const std::size_t n_blocks = words.count("the number of element blocks");
  const std::size_t n = words.count("the number of elements");
  for (const char* what : {"the smallest element number", "the largest element number"}) words.integer(what);
  for (std::size_t block = 0; block < n_blocks; ++block) {
    words.integer("the dimension of an element block");
    const auto entity = words.integer("the entity of an element block");
    const auto type = static_cast<int>(words.integer("the type of an element block"));
    const auto group = groups.find({dimension_of(type), entity});
    const std::size_t n_elements = words.count("the number of elements of a block");
    for (std::size_t i = 0; i < n_elements; ++i)
      add_element(
          {words.integer("the number of an element"), type, group == groups.end() ? 0 : group->second, {}, entity},
          words, sections, index);
  }
  if (sections.elements.size() != n)
    words.fail("the number of elements", fmt::format("{}", sections.elements.size()),
               fmt::format("{} as announced", n));
}

}  // namespace

MshSections read_sections(const std::filesystem::path& file) {
  Words words(file);
  const bool is_22 = read_version(words) == "2.2";
  MshSections sections;
  EntityGroups groups;
  NodeIndex index;
  while (!words.at_end()) {
    const std::string section(words.next("a section"));
    if (section.size() < 2 || section[0] != '$') words.fail("the start of a section", section, "$Name");
    const std::string end = "$End" + section.substr(1);
    if (section == "$PhysicalNames") {
      read_group_names(words, sections);
    } else if (section == "$Entities") {
      groups = read_entities(words);
    } else if (section == "$Nodes") {
      index = is_22 ? read_nodes_22(words, sections) : read_nodes_41(words, sections);
    } else if (section == "$Elements") {
      is_22 ? read_elements_22(words, sections, index) : read_elements_41(words, sections, index, groups);
    } else {
      while (words.next(end) != end) continue;
      continue;
    }
    words.expect(end);
  }
  return sections;
}

std::string group_name(const MshSections& sections, const MshSections::Element& element) {
  const auto found = sections.group_names.find({dimension_of(element.type), element.group});
  return found == sections.group_names.end() ? "" : found->second;
}

}  // namespace fretval::meshes
